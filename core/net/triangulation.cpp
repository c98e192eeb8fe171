#include "net/triangulation.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <span>

namespace chebnet {

namespace {

/// The triangles of a face as a fan from its corner number `first`.
std::vector<Triangle> fan(std::span<const int> face, std::size_t first) {
    std::vector<Triangle> triangles;
    const auto corner = [&](std::size_t k) { return face[(first + k) % face.size()]; };
    for (std::size_t k = 1; k + 1 < face.size(); ++k) triangles.push_back({corner(0), corner(k), corner(k + 1)});
    return triangles;
}

std::vector<Triangle> triangles_of_quad(const Positions& x, std::span<const int> quad) {
    const std::vector<Triangle> choices[] = {fan(quad, 0), fan(quad, 1)};
    const auto is_folded = [&x](const std::vector<Triangle>& t) {
        return area_vector(x, t[0]).dot(area_vector(x, t[1])) < 0;
    };
    const auto diagonal = [&](int first) { return (x.col(quad[first]) - x.col(quad[first + 2])).squaredNorm(); };
    // A quad that names a vertex twice is refused elsewhere.
    const auto has_no_length = [&](int first) { return quad[first] != quad[first + 2] && diagonal(first) == 0; };
    const bool has_none[] = {has_no_length(0), has_no_length(1)};
    if (has_none[0] != has_none[1]) return choices[has_none[0] ? 1 : 0];
    const bool folded[] = {is_folded(choices[0]), is_folded(choices[1])};
    if (folded[0] != folded[1]) return choices[folded[0] ? 1 : 0];
    return choices[diagonal(1) < diagonal(0) ? 1 : 0];
}

}  // namespace

std::vector<Triangle> triangulated(const Positions& positions, const Faces& faces) {
    std::vector<Triangle> triangles;
    for (int f = 0; f < faces.size(); ++f) {
        const std::span<const int> face = faces[f];
        if (face.size() == 3) {
            triangles.push_back({face[0], face[1], face[2]});
            continue;
        }
        const auto pieces = face.size() == 4 ? triangles_of_quad(positions, face) : fan(face, 0);
        triangles.insert(triangles.end(), pieces.begin(), pieces.end());
    }
    return triangles;
}

Eigen::Vector3d area_vector(const Positions& positions, const Triangle& triangle) {
    const Eigen::Vector3d corner = positions.col(triangle[0]);
    return (positions.col(triangle[1]) - corner).cross(positions.col(triangle[2]) - corner);
}

}  // namespace chebnet
