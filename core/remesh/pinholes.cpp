#include "remesh/pinholes.h"

#include <numbers>
#include <vector>

#include "base/error.h"

namespace chebnet {

namespace {

struct Hole {
    std::vector<int> sides;
    Eigen::Vector3d middle;
};

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

std::vector<Hole> holes_up_to(const Surface& surface, double longest) {
    const Eigen::VectorXd areas = piece_areas(surface);
    std::vector<Hole> holes;
    for (const std::vector<int>& loop : surface.boundary_loops()) {
        const double length = surface.length_of(loop);
        if (length > longest || areas[Surface::face_of(loop.front())] <= area_within(length)) continue;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const int s : loop) sum += surface.positions().col(surface.from(s));
        holes.push_back({loop, sum / static_cast<double>(loop.size())});
    }
    return holes;
}

}  // namespace

std::optional<Surface> without_pinholes(const Surface& surface, double longest) {
    const std::vector<Hole> holes = holes_up_to(surface, longest);
    if (holes.empty()) return std::nullopt;
    Mesh mesh{surface.positions(), {}};
    mesh.positions.conservativeResize(3, surface.vertex_count() + std::ssize(holes));
    for (int f = 0; f < surface.face_count(); ++f) {
        const Eigen::Vector3i corners = surface.triangles().col(f);
        mesh.faces.add({corners[0], corners[1], corners[2]});
    }
    for (int h = 0; h < std::ssize(holes); ++h) {
        const int middle = surface.vertex_count() + h;
        mesh.positions.col(middle) = holes[h].middle;
        for (const int s : holes[h].sides) mesh.faces.add({surface.to(s), surface.from(s), middle});
    }
    try {
        return Surface(mesh);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace chebnet
