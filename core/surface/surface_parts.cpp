#include "surface/surface_parts.h"

#include <algorithm>
#include <array>
#include <utility>

#include "net/mesh.h"

namespace chebnet {

namespace {

/// That of these triangles. `number`: −1 for each vertex, and so again afterwards.
SurfacePart part_of(const Surface& surface, const std::vector<int>& triangles, std::vector<int>& number) {
    Mesh mesh;
    std::vector<int> vertices;
    for (const int f : triangles) {
        std::array<int, 3> corners{};
        for (int k = 0; k < 3; ++k) {
            const int vertex = surface.triangles()(k, f);
            if (number[vertex] < 0) {
                number[vertex] = static_cast<int>(vertices.size());
                vertices.push_back(vertex);
            }
            corners[k] = number[vertex];
        }
        mesh.faces.add(corners);
    }
    mesh.positions = surface.positions()(Eigen::all, vertices);
    for (const int vertex : vertices) number[vertex] = -1;
    return {Surface(mesh), std::move(vertices)};
}

}  // namespace

std::vector<SurfacePart> parts_of(const Surface& surface, const std::vector<int>& part, int count) {
    std::vector<std::vector<int>> triangles(static_cast<std::size_t>(count));
    for (int f = 0; f < surface.face_count(); ++f)
        if (part[f] >= 0) triangles[part[f]].push_back(f);
    std::vector<int> number(static_cast<std::size_t>(surface.vertex_count()), -1);
    std::vector<SurfacePart> parts;
    for (const std::vector<int>& own : triangles) parts.push_back(part_of(surface, own, number));
    return parts;
}

std::vector<Surface> pieces_of(const Surface& surface) {
    const std::vector<int> piece = surface.components();
    std::vector<Surface> pieces;
    for (SurfacePart& part : parts_of(surface, piece, *std::max_element(piece.begin(), piece.end()) + 1))
        pieces.push_back(std::move(part.surface));
    return pieces;
}

}  // namespace chebnet
