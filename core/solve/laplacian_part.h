#pragma once

#include <Eigen/Core>
#include <vector>

#include "linear/graph_system.h"
#include "net/net.h"
#include "solve/free_part.h"

namespace chebnet {

/// The free vertices of a net with the uniform Laplacian of its edges, factored once: what all methods share that ask
/// of each edge to become a certain vector and then spread the contradictions evenly. Keeps a reference to the net.
class LaplacianPart {
public:
    /// `is_free`: V. Finds an order and factors; everything after costs two triangular solves.
    LaplacianPart(const Net& net, const std::vector<bool>& is_free);

    const Net& net() const { return m_net; }
    const FreePart& part() const { return m_part; }

    /// Moves the free vertices of `positions` (3×V) to the minimum of F = Σ_e ‖(x_a − x_b) − t_e‖², where t_e is column
    /// e of `vectors` (3×E) and (a, b) are the ends of edge e. A piece of the net that no fixed vertex holds keeps one
    /// vertex where it is. Returns ‖∇F‖ over the free vertices before the move.
    double fit(const Eigen::Matrix3Xd& vectors, Positions& positions);

    /// Replaces a right-hand side, 4×nodes, by the solution of the Laplacian's system, without allocation.
    void solve_in_place(Eigen::Matrix4Xf& x) { m_system.solve_in_place(x); }

private:
    const Net& m_net;
    FreePart m_part;
    LaplacianSystem m_system;
    Eigen::Matrix3Xd m_residual;  // 3×nodes, −∇F / 2, then the moves
};

}  // namespace chebnet
