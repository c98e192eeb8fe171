#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "linear/cholesky.h"
#include "solve/parts/free_part.h"
#include "solve/parts/neighbour_pairs.h"
#include "solve/slide.h"
#include "solve/terms/term.h"

namespace chebnet {

/// A system of 3×3 blocks on the free vertices that joins neighbours and vertices with a common neighbour, factored in
/// single precision as a preconditioner. What is added at fixed vertices is left out. Keeps references to pairs and
/// part.
class NeighbourSystem : public BlockForm {
public:
    /// Throws Error too_large.
    NeighbourSystem(const NeighbourPairs& pairs, const FreePart& part);

    void set_zero();
    void add_vertex(int vertex, const Eigen::Matrix3d& B) override;
    void add_pair(int row_vertex, int column_vertex, const Eigen::Matrix3d& B) override;
    /// Takes what slides out of what has been added: the coordinates that it keeps stay 0 in solutions.
    void hold(std::span<const Slide> slides);
    /// False if it is not positive definite as far as single precision can tell.
    bool factorize() { return m_factor.factorize(m_node_blocks, m_link_blocks); }
    /// The rows of free vertices of `to` become the solution for those of `from` (both 3×V).
    void solve(const Eigen::Matrix3Xd& from, Eigen::Matrix3Xd& to);

private:
    const NeighbourPairs& m_pairs;
    const FreePart& m_part;
    std::vector<int> m_link_of_pair;  // −1: a vertex is fixed
    std::vector<Eigen::Matrix3d> m_node_blocks, m_link_blocks;
    Cholesky<3, float> m_factor;
    Eigen::VectorXf m_permuted;
};

}  // namespace chebnet
