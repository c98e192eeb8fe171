#include "remesh/pinholes.h"

#include <numbers>
#include <vector>

#include "base/error.h"

namespace chebnet {

namespace {

/// F, the area of the piece of each triangle.
Eigen::VectorXd piece_areas(const Surface& surface) {
    const std::vector<int> pieces = surface.components();
    Eigen::VectorXd of_piece = Eigen::VectorXd::Zero(surface.face_count()), of_face = of_piece;
    for (int f = 0; f < surface.face_count(); ++f) of_piece[pieces[f]] += surface.areas()[f];
    for (int f = 0; f < surface.face_count(); ++f) of_face[f] = of_piece[pieces[f]];
    return of_face;
}

/// Of a hemisphere with a border of this length: a piece that is no larger is what lies within the border, not around
/// it.
double area_within(double border) { return border * border / (2 * std::numbers::pi); }

std::vector<std::vector<int>> holes_up_to(const Surface& surface, double longest) {
    const Eigen::VectorXd areas = piece_areas(surface);
    std::vector<std::vector<int>> holes;
    for (const std::vector<int>& loop : surface.boundary_loops()) {
        const double length = surface.length_of(loop);
        if (length <= longest && areas[Surface::face_of(loop.front())] > area_within(length)) holes.push_back(loop);
    }
    return holes;
}

Eigen::Vector3d middle_of(const Surface& surface, const std::vector<int>& loop) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int s : loop) sum += surface.positions().col(surface.from(s));
    return sum / static_cast<double>(loop.size());
}

}  // namespace

std::optional<Surface> without_pinholes(const Surface& surface, double longest) {
    return closed_at(surface, holes_up_to(surface, longest));
}

std::optional<Surface> closed_at(const Surface& surface, const std::vector<std::vector<int>>& loops) {
    if (loops.empty()) return std::nullopt;
    Mesh mesh{surface.positions(), {}};
    mesh.positions.conservativeResize(3, surface.vertex_count() + std::ssize(loops));
    for (int f = 0; f < surface.face_count(); ++f) {
        const Eigen::Vector3i corners = surface.triangles().col(f);
        mesh.faces.add({corners[0], corners[1], corners[2]});
    }
    for (int h = 0; h < std::ssize(loops); ++h) {
        const int middle = surface.vertex_count() + h;
        mesh.positions.col(middle) = middle_of(surface, loops[h]);
        for (const int s : loops[h]) mesh.faces.add({surface.to(s), surface.from(s), middle});
    }
    try {
        return Surface(mesh);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace chebnet
