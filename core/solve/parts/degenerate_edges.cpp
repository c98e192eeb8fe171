#include "solve/parts/degenerate_edges.h"

namespace chebnet {

namespace {

constexpr double k_degenerate_ratio = 1e-2;
constexpr double k_opened_ratio = 1e-1;

/// A unit direction from `anchor` towards the neighbours of `vertex`; any fixed one if they give none.
Eigen::Vector3d way_out(const Topology& topology, const Positions& positions, int vertex, int anchor) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int n : topology.neighbours(vertex)) sum += positions.col(n) - positions.col(anchor);
    const double norm = sum.norm();
    return norm > 0 ? Eigen::Vector3d(sum / norm) : Eigen::Vector3d::UnitX();
}

}  // namespace

void open_degenerate_edges(const Net& net, const Topology& topology, const std::vector<bool>& is_free,
                           Positions& positions) {
    for (int e = 0; e < net.edge_count(); ++e) {
        const int a = net.edges()(0, e), b = net.edges()(1, e);
        const double L = net.rest_lengths()[e];
        // The square of a length beside which others are 1e199 times as long is 0.
        if ((positions.col(a) - positions.col(b)).stableNorm() >= k_degenerate_ratio * L) continue;
        const int moved = is_free[b] ? b : a;
        if (!is_free[moved]) continue;
        const int anchor = moved == a ? b : a;
        positions.col(moved) = positions.col(anchor) + k_opened_ratio * L * way_out(topology, positions, moved, anchor);
    }
}

}  // namespace chebnet
