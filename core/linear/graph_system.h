#pragma once

#include <Eigen/Core>
#include <type_traits>
#include <vector>

#include "linear/cholesky.h"

namespace chebnet {

/// A sparse symmetric positive definite system on a graph. The unknown at a node has `size` rows (3: a Newton-like
/// system for positions; 1: a Laplacian, which serves the three coordinates as three right-hand sides), and the matrix
/// is a sum of terms of nodes and of links.
///
/// Construction orders the nodes and does the symbolic factorisation; after that, set_zero / add_* / factorize / solve
/// repeat at numeric cost only. The order is found on the graph of nodes and keeps the rows of a node together.
///
/// `Scalar`: of the factor. Single precision halves its time; it is enough where solutions serve as steps, so that what
/// they leave of the residual is the next step's to correct.
template <int size, typename Scalar>
class GraphSystem {
public:
    using Block = Eigen::Matrix<double, size, size>;

    /// `links`: 2×K, the joined pairs of nodes (distinct pairs, no loops), nodes in [0, node_count).
    /// `elimination_rank`: node → place in the order of elimination; empty: a fill-reducing one is found. Throws Error
    /// too_large if the factor would need more than k_most_factor_bytes.
    GraphSystem(int node_count, const Eigen::Matrix2Xi& links, std::vector<int> elimination_rank = {});

    int node_count() const { return static_cast<int>(m_node_blocks.size()); }
    /// node → place in the order of elimination. Restricted to some of the nodes it is a good order for them too: the
    /// fill of a principal submatrix in the same order is a part of the whole's.
    const std::vector<int>& elimination_rank() const { return m_factor.rank(); }

    void set_zero();
    /// Adds the symmetric block B at a node.
    void add_at_node(int node, const Block& B);
    /// Adds [[B, −B], [−B, B]], B symmetric, at the two nodes of a link, by the link's column in the constructor's
    /// `links`.
    void add_at_link(int link, const Block& B);

    /// Numeric factorisation of the present matrix. False if it is not positive definite or not finite.
    bool factorize();
    /// Replaces the right-hand side by the solution, without allocation. `Vectors`: Eigen::Matrix3Xd, a column for each
    /// node (for size 1, three systems at once); or Eigen::Matrix4Xf for a Laplacian, four systems in the precision of
    /// its factor. Only after factorize() returned true.
    template <typename Vectors>
    void solve_in_place(Vectors& x);
    /// The same, out of place.
    Eigen::Matrix3Xd solve(Eigen::Matrix3Xd rhs) {
        solve_in_place(rhs);
        return rhs;
    }

    /// Entries kept for the triangular factor.
    long factor_entries() const { return m_factor.entries(); }

private:
    std::vector<Block> m_node_blocks, m_link_blocks;
    Eigen::Matrix2Xi m_links;
    Cholesky<size, Scalar> m_factor;
    /// A row of the system at one node, in all right-hand sides.
    using Row = std::conditional_t<size == 1, dense::Four, Eigen::Matrix<Scalar, 3, 1>>;
    std::vector<Row> m_permuted;  // a right-hand side in the order of elimination
};

/// For positions: three coupled unknowns a node.
using BlockSystem = GraphSystem<3, double>;
using SingleBlockSystem = GraphSystem<3, float>;
/// For a scalar Laplacian, solved for three coordinates at once.
using LaplacianSystem = GraphSystem<1, float>;

extern template class GraphSystem<1, float>;
extern template class GraphSystem<3, double>;
extern template class GraphSystem<3, float>;

}  // namespace chebnet
