#include "solve/parts/bow.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>

#include "linear/graph_system.h"

namespace chebnet {

namespace {

// In edge lengths: a net that rises by no more than this is flat.
constexpr double k_flat = 0.02;
// A normal that leans by less than this against the ground points to neither side of it.
constexpr double k_level = 1e-9;
// Moves whose share across the plane is less than this lead to neither side.
constexpr double k_led = 1e-6;
// How easily the film gives way along edges that lose nothing, where it is 1 along those that lose most.
constexpr double k_stiff = 1e-4;

/// To the side on which the last coordinate that differs from 0 is positive.
Eigen::Vector3d upwards(const Eigen::Vector3d& normal) {
    for (int axis = 2; axis >= 0; --axis)
        if (std::abs(normal[axis]) > k_level) return normal[axis] > 0 ? normal : Eigen::Vector3d(-normal);
    return normal;
}

/// Of the plane in which all vertices lie.
std::optional<Eigen::Vector3d> normal_of(const Positions& positions, double edge_length) {
    const Positions from_centre = (positions.colwise() - positions.rowwise().mean()) / edge_length;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(from_centre * from_centre.transpose());
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    if (!((normal.transpose() * from_centre).cwiseAbs().maxCoeff() <= k_flat)) return std::nullopt;
    return upwards(normal);
}

/// What moves take from the square of each edge's length.
Eigen::VectorXd losses(const Net& net, const Positions& positions, const Eigen::Matrix3Xd& moves) {
    Eigen::VectorXd lost(net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const int a = net.edges()(0, e), b = net.edges()(1, e);
        const Eigen::Vector3d before = positions.col(a) - positions.col(b), move = moves.col(a) - moves.col(b);
        lost[e] = -move.dot(2 * before + move);
    }
    return lost;
}

/// The heights of the film, V.
Eigen::VectorXd film(const Net& net, const FreePart& part, const Eigen::VectorXd& lost) {
    const double most = lost.maxCoeff();
    LaplacianSystem system(part.size(), part.links());
    for (const FreePart::Edge& edge : part.edges()) {
        const LaplacianSystem::Block stiffness(1 / (std::max(lost[edge.index], 0.0) / most + k_stiff));
        if (edge.link >= 0)
            system.add_at_link(edge.link, stiffness);
        else
            system.add_at_node(std::max(edge.node_a, edge.node_b), stiffness);
    }
    for (const int node : part.floating_nodes()) system.add_at_node(node, LaplacianSystem::Block(1));
    Eigen::VectorXd heights = Eigen::VectorXd::Zero(net.vertex_count());
    if (!system.factorize()) return heights;
    const Eigen::Matrix3Xd solution = system.solve(Eigen::Matrix3Xd::Ones(3, part.size()));
    for (int i = 0; i < part.size(); ++i) heights[part.vertices()[i]] = solution(0, i);
    return heights;
}

/// The c with c² = Σ_e t_e s_e² / Σ_e s_e⁴, for which c² s_e² fits t_e best: what edge e has lost, and by how much
/// higher one of its ends comes than the other.
double rise(const Net& net, const Eigen::VectorXd& lost, const Eigen::VectorXd& heights) {
    double wanted = 0, made_up = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const double step = heights[net.edges()(0, e)] - heights[net.edges()(1, e)];
        wanted += lost[e] * step * step;
        made_up += step * step * step * step;
    }
    return wanted > 0 && made_up > 0 ? std::sqrt(wanted / made_up) : 0;
}

}  // namespace

void add_bow(const Net& net, const FreePart& part, const Positions& positions, bool hangs, Eigen::Matrix3Xd& moves) {
    const auto normal = normal_of(positions, net.mean_length());
    if (!normal || part.size() == 0) return;
    const Eigen::VectorXd lost = losses(net, positions, moves);
    if (!(lost.sum() > 0)) return;
    const Eigen::VectorXd heights = film(net, part, lost);
    const double led = (normal->transpose() * moves).dot(heights);
    const bool is_led = std::abs(led) > k_led * moves.norm() * heights.norm();
    const double side = (is_led ? led < 0 : hangs) ? -1 : 1;
    moves += side * rise(net, lost, heights) * *normal * heights.transpose();
}

}  // namespace chebnet
