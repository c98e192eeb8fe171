#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "linear/graph_system.h"
#include "net/net.h"
#include "solve/parts/free_part.h"
#include "solve/pull.h"

namespace chebnet {

/// The free vertices of a net with the uniform Laplacian of its edges, factored once: what all methods share that ask
/// of each edge to become a certain vector and then spread the contradictions evenly. Keeps a reference to the net.
class LaplacianPart {
public:
    /// `is_free`: V. Finds an order and factors; everything after costs two triangular solves.
    LaplacianPart(const Net& net, const std::vector<bool>& is_free);

    const Net& net() const { return m_net; }
    const FreePart& part() const { return m_part; }

    /// The free vertices that are pulled, in place of those before. Weights may be anything above 0, but above 1e6 more
    /// makes no difference. Factors anew if vertices or weights differ; moving targets costs nothing.
    void set_pulls(std::span<const Pull> pulls);
    /// Makes all pulls weaker alike, 0 < scale ≤ 1, until the next call. Factors anew if the scale differs.
    void scale_pulls(double scale);
    /// With their weights as scaled.
    std::span<const Pull> pulls() const { return m_pulls; }

    /// Moves the free vertices of `positions` (3×V) towards the minimum of
    ///
    ///     F = Σ_e ‖(x_a − x_b) − t_e‖² + Σ_h w_h ‖x_h − t_h‖²,
    ///
    /// where t_e is column e of `vectors` (3×E), (a, b) are the ends of edge e, and h are the pulls. One call takes
    /// them there, but for a piece of the net that no fixed vertex keeps in place: without a pull it leaves one vertex
    /// where it is, and with weak ones it goes there in small steps. Returns ‖∇F‖ over the free vertices before the
    /// move.
    double fit(const Eigen::Matrix3Xd& vectors, Positions& positions);

    /// Replaces a right-hand side, 4×nodes, by the solution of the Laplacian's system, without allocation.
    void solve_in_place(Eigen::Matrix4Xf& x) { m_system.solve_in_place(x); }

private:
    void factorize();

    const Net& m_net;
    FreePart m_part;
    std::vector<Pull> m_pulls;  // weights scaled
    double m_scale = 1;
    std::vector<double> m_piece_weight;  // nodes: at a node that stands for its piece, the sum of the pulls in it
    std::vector<bool> m_is_light;        // likewise: whether these hold it, but hardly
    LaplacianSystem m_system;
    Eigen::Matrix3Xd m_residual;  // 3×nodes, −∇F / 2, then the moves
};

}  // namespace chebnet
