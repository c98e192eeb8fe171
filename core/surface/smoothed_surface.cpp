#include "surface/smoothed_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "surface/curvature.h"
#include "surface/heat_step.h"

namespace chebnet {

namespace {

// Between the normals of two triangles: of a rough surface half of all are inclined by more than this, in radians.
constexpr double k_rough_bend = 10 * std::numbers::pi / 180;
// What is left of a rough surface's curvature, of both signs, once it has spread over an edge.
constexpr double k_rough_part = 0.25;
// Radians: a net follows what tilts the surface by less. And how far smoothing reaches for it, in edges of the net.
constexpr double k_followed_tilt = 7 * std::numbers::pi / 180, k_farthest_smoothed = 5;
// In edges of the net: triangles that are larger, at their sides, are facets, on which it lies.
constexpr double k_largest_triangle = 2;

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Of the angles between neighbouring triangles; 0 where there are none.
double median_bend(const Surface& surface) {
    std::vector<double> bends;
    for (int side = 0; side < 3 * surface.face_count(); ++side) {
        const int other = surface.opposite(side);
        if (other > side)
            bends.push_back(angle_between(surface.face_normals().col(Surface::face_of(side)),
                                          surface.face_normals().col(Surface::face_of(other))));
    }
    if (bends.empty()) return 0;
    const auto middle = bends.begin() + std::ssize(bends) / 2;
    std::nth_element(bends.begin(), middle, bends.end());
    return *middle;
}

}  // namespace

bool is_rough(const Surface& surface) {
    if (!(median_bend(surface) > k_rough_bend)) return false;
    const Eigen::VectorXd defects = inner_defects(surface);
    const double edge = mean_edge(surface);
    const Eigen::VectorXd spread = HeatStep(surface, edge * edge).spread(defects);
    return spread.cwiseAbs().sum() < k_rough_part * defects.cwiseAbs().sum();
}

std::shared_ptr<const Guide> without_roughness(const std::shared_ptr<const Guide>& guide, double length) {
    const Surface& surface = guide->surface();
    if (!(length > 0 && std::isfinite(length * length) && mean_edge(surface) <= k_largest_triangle * length) ||
        !is_rough(surface))
        return guide;
    std::optional<Surface> smooth;
    try {
        for (double radius = length; radius < k_farthest_smoothed * length; radius *= 2) {
            Surface smoother = smoothed(surface, radius);
            if (smooth && mean_tilt(*smooth, smoother) < k_followed_tilt) break;
            smooth = std::move(smoother);
        }
    } catch (const Error&) {  // triangles that vanish
    }
    return smooth ? std::make_shared<const Guide>(*std::move(smooth)) : guide;
}

Surface smoothed(const Surface& surface, double radius, const std::function<void()>& go_on) {
    const HeatStep step(surface, radius * radius, HeatBoundary::held);
    Mesh mesh{surface.positions(), {}};
    for (int k = 0; k < 3; ++k) {
        const Eigen::VectorXd values = surface.positions().row(k).transpose();
        go_on();
        const Eigen::VectorXd change = step.change(values);
        go_on();
        mesh.positions.row(k) -= step.change(change).transpose();
    }
    for (const auto& triangle : surface.triangles().colwise()) mesh.faces.add({triangle[0], triangle[1], triangle[2]});
    return Surface(mesh);
}

double mean_tilt(const Surface& surface, const Surface& other) {
    double sum = 0;
    for (int f = 0; f < surface.face_count(); ++f) {
        const Eigen::Vector3d a = surface.face_normals().col(f), b = other.face_normals().col(f);
        sum += surface.areas()[f] * angle_between(a, b);
    }
    return surface.area() > 0 ? sum / surface.area() : 0;
}

double mean_move(const Surface& surface, const Surface& other) {
    double sum = 0;
    for (int f = 0; f < surface.face_count(); ++f)
        for (const int v : surface.triangles().col(f))
            sum += surface.areas()[f] / 3 * (surface.positions().col(v) - other.positions().col(v)).norm();
    return surface.area() > 0 ? sum / surface.area() : 0;
}

}  // namespace chebnet
