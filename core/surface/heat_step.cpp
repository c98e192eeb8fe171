#include "surface/heat_step.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace chebnet {

namespace {

constexpr double k_largest_cotangent = 100;  // of triangles that are nearly lines
constexpr double k_tolerance = 1e-6;
constexpr int k_most_iterations = 500;

double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    double sum = 0;  // in a fixed order: that of Eigen's sums depends on the compiler
    for (Eigen::Index i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

double cotangent(const Surface& surface, int side) {
    const Positions& x = surface.positions();
    const int across = surface.from(Surface::previous(side));
    const Eigen::Vector3d a = x.col(surface.from(side)) - x.col(across), b = x.col(surface.to(side)) - x.col(across);
    const double sine = a.cross(b).norm(), cosine = a.dot(b);
    return std::abs(cosine) < k_largest_cotangent * sine ? cosine / sine : std::copysign(k_largest_cotangent, cosine);
}

HeatStep::HeatStep(const Surface& surface, double t, HeatBoundary boundary)
    : m_areas(Eigen::VectorXd::Zero(surface.vertex_count())),
      m_is_held(static_cast<std::size_t>(surface.vertex_count()), false) {
    for (int f = 0; f < surface.face_count(); ++f)
        for (const int v : surface.triangles().col(f)) m_areas[v] += surface.areas()[f] / 3;
    for (int side = 0; side < 3 * surface.face_count(); ++side) {
        const int opposite = surface.opposite(side);
        if (opposite > side) continue;
        const double cotangents = cotangent(surface, side) + (opposite < 0 ? 0 : cotangent(surface, opposite));
        m_links.push_back({surface.from(side), surface.to(side), t * std::max(0.0, cotangents / 2)});
    }
    m_diagonal = m_areas;
    for (const Link& link : m_links) m_diagonal[link.a] += link.weight, m_diagonal[link.b] += link.weight;
    if (boundary == HeatBoundary::insulated) return;
    for (int v = 0; v < surface.vertex_count(); ++v) m_is_held[v] = surface.is_boundary(v);
}

Eigen::VectorXd HeatStep::spread(const Eigen::VectorXd& amounts) const { return solve(amounts).cwiseProduct(m_areas); }

Eigen::VectorXd HeatStep::change(const Eigen::VectorXd& values) const {
    Eigen::VectorXd image(values.size());
    multiply(values, image);
    return solve(m_areas.cwiseProduct(values) - image);
}

Eigen::VectorXd HeatStep::solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size()), residual = b, image(b.size());
    Eigen::VectorXd scaled = precondition(residual), search = scaled;
    double product = dot(residual, scaled);
    const double enough = k_tolerance * k_tolerance * product;
    for (int k = 0; k < k_most_iterations && product > enough; ++k) {
        multiply(search, image);
        const double step = product / dot(search, image);
        x += step * search;
        residual -= step * image;
        scaled = precondition(residual);
        const double previous = product;
        product = dot(residual, scaled);
        search = scaled + product / previous * search;
    }
    return x;
}

/// A vertex of triangles without area has nothing to scale by. What is held is never searched along.
Eigen::VectorXd HeatStep::precondition(const Eigen::VectorXd& residual) const {
    Eigen::VectorXd scaled = (m_diagonal.array() > 0).select(residual.array() / m_diagonal.array(), 0.0);
    for (Eigen::Index v = 0; v < scaled.size(); ++v)
        if (m_is_held[v]) scaled[v] = 0;
    return scaled;
}

void HeatStep::multiply(const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
    to = m_diagonal.cwiseProduct(from);
    for (const auto& [a, b, weight] : m_links) {
        to[a] -= weight * from[b];
        to[b] -= weight * from[a];
    }
}

double mean_edge(const Surface& surface) {
    double sum = 0;
    for (int side = 0; side < 3 * surface.face_count(); ++side) sum += surface.length_of(side);
    return sum / (3. * surface.face_count());
}

}  // namespace chebnet
