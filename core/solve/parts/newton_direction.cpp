#include "solve/parts/newton_direction.h"

#include <algorithm>

#include "base/stopwatch.h"

namespace chebnet {

namespace {

void fill(BlockSystem& system, const DescentPoint& point, std::vector<EdgeCurvature>& curvatures) {
    curvatures.clear();
    double mean_radial = 0;
    for (const FreePart::Edge& edge : point.part.edges()) {
        curvatures.push_back(point.energy.curvature(point.ratios[edge.index]));
        mean_radial += curvatures.back().radial / static_cast<double>(point.part.edges().size());
    }
    const double floor = k_smallest_weight * mean_radial;

    system.set_zero();
    for (std::size_t k = 0; k < curvatures.size(); ++k) {
        const FreePart::Edge& edge = point.part.edges()[k];
        const double L = point.net.rest_lengths()[edge.index];
        const Eigen::Vector3d u = (point.positions.col(point.net.edges()(0, edge.index)) -
                                   point.positions.col(point.net.edges()(1, edge.index))) /
                                  (point.ratios[edge.index] * L);
        const double radial = std::max(curvatures[k].radial, floor);
        const double tangential = std::max(curvatures[k].tangential, floor);
        const Eigen::Matrix3d B =
            (tangential * Eigen::Matrix3d::Identity() + (radial - tangential) * u * u.transpose()) / (L * L);
        if (edge.link >= 0)
            system.add_at_link(edge.link, B);
        else
            system.add_at_node(std::max(edge.node_a, edge.node_b), B);
    }
    const double L = point.net.mean_length();
    for (int node : point.part.floating_nodes())
        system.add_at_node(node, mean_radial / (L * L) * Eigen::Matrix3d::Identity());
}

}  // namespace

void NewtonDirection::prepare(const FreePart& whole) {
    m_whole = &whole;
    m_system = std::make_unique<BlockSystem>(whole.size(), whole.links());
}

bool NewtonDirection::find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow& row) {
    Stopwatch watch;
    std::unique_ptr<BlockSystem> reduced;
    if (&point.part != m_whole)
        reduced = std::make_unique<BlockSystem>(point.part.size(), point.part.links(),
                                                point.part.induced_order(*m_whole, m_system->elimination_rank()));
    BlockSystem& system = reduced ? *reduced : *m_system;
    fill(system, point, m_curvatures);
    row.assembly_ms += watch.milliseconds();

    watch.restart();
    const bool factorised = system.factorize();
    if (factorised) direction = -system.solve(point.gradient);
    row.factorisation_ms += watch.milliseconds();
    return factorised;
}

}  // namespace chebnet
