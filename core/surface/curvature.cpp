#include "surface/curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "surface/heat_step.h"

namespace chebnet {

namespace {

constexpr double k_pi = std::numbers::pi;
constexpr int k_heat_steps = 3;
// Noise of a scan is as wide as its edges: before that the surface is smoothed over so many, if they are not longer
// than this part of what curvature is smoothed over.
constexpr double k_edges_of_noise = 2, k_part_of_radius = 0.5;

Positions without_noise(const Surface& surface, double radius) {
    const double width = std::min(k_edges_of_noise * mean_edge(surface), k_part_of_radius * radius);
    const HeatStep step(surface, width * width);
    Positions x = surface.positions();
    for (int coordinate = 0; coordinate < 3; ++coordinate)
        x.row(coordinate) += step.change(x.row(coordinate).transpose()).transpose();
    return x;
}

Eigen::VectorXd angle_defects_at(const Surface& surface, const Positions& x) {
    Eigen::VectorXd defects(surface.vertex_count());
    for (int v = 0; v < surface.vertex_count(); ++v) defects[v] = surface.is_boundary(v) ? k_pi : 2 * k_pi;
    for (int side = 0; side < 3 * surface.face_count(); ++side) {
        const int v = surface.from(side);
        const Eigen::Vector3d a = x.col(surface.to(side)) - x.col(v);
        const Eigen::Vector3d b = x.col(surface.from(Surface::previous(side))) - x.col(v);
        defects[v] -= std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return defects;
}

Eigen::VectorXd inner_part(const Surface& surface, Eigen::VectorXd defects) {
    for (int v = 0; v < surface.vertex_count(); ++v)
        if (surface.is_boundary(v)) defects[v] = 0;
    return defects;
}

}  // namespace

Eigen::VectorXd angle_defects(const Surface& surface) { return angle_defects_at(surface, surface.positions()); }

Eigen::VectorXd inner_defects(const Surface& surface) { return inner_part(surface, angle_defects(surface)); }

Eigen::VectorXd angle_defects_without_noise(const Surface& surface, double radius) {
    return angle_defects_at(surface, without_noise(surface, radius));
}

Eigen::VectorXd spread_inner_defects(const Surface& surface, double radius, const Eigen::VectorXd& defects) {
    const HeatStep step(surface, radius * radius / k_heat_steps);
    Eigen::VectorXd spread = inner_part(surface, defects);
    for (int k = 0; k < k_heat_steps; ++k) spread = step.spread(spread);
    return spread;
}

Eigen::VectorXd smoothed_angle_defects(const Surface& surface, double radius) {
    return spread_inner_defects(surface, radius, angle_defects_without_noise(surface, radius));
}

TotalCurvature total_curvature(const Eigen::VectorXd& defects) {
    TotalCurvature total;
    for (const double defect : defects) (defect > 0 ? total.positive : total.negative) += defect;
    return total;
}

}  // namespace chebnet
