#include "remesh/pinholes.h"

#include <vector>

#include "base/error.h"

namespace chebnet {

namespace {

struct Hole {
    std::vector<int> sides;
    Eigen::Vector3d middle;
};

std::vector<Hole> holes_up_to(const Surface& surface, double longest) {
    std::vector<Hole> holes;
    for (const std::vector<int>& loop : surface.boundary_loops()) {
        if (surface.length_of(loop) > longest) continue;
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
