#include "io/stl.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/error.h"
#include "io/bytes.h"

namespace chebnet {

namespace {

using Triangle = std::array<int, 3>;

void check_range(const Positions& positions) {
    for (int v = 0; v < positions.cols(); ++v)
        if (!(positions.col(v).cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max()))
            throw Error(ErrorCode::too_large,
                        "vertex " + std::to_string(v) + " has a coordinate that is too large for STL");
}

/// Twice the area of the triangle along its normal.
Eigen::Vector3d area_vector(const Positions& x, const Triangle& t) {
    const Eigen::Vector3d corner = x.col(t[0]);
    return (x.col(t[1]) - corner).cross(x.col(t[2]) - corner);
}

/// `vector` with the length 1, however small it is; 0 remains 0.
Eigen::Vector3d direction_of(const Eigen::Vector3d& vector) {
    const double largest = vector.cwiseAbs().maxCoeff();
    return largest > 0 ? (vector / largest).normalized() : vector;
}

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
    const bool folded[] = {is_folded(choices[0]), is_folded(choices[1])};
    if (folded[0] != folded[1]) return choices[folded[0] ? 1 : 0];
    const auto diagonal = [&](int first) { return (x.col(quad[first]) - x.col(quad[first + 2])).squaredNorm(); };
    return choices[diagonal(1) < diagonal(0) ? 1 : 0];
}

std::vector<Triangle> triangles_of(const Positions& positions, const Faces& faces) {
    std::vector<Triangle> triangles;
    for (int f = 0; f < faces.size(); ++f) {
        const std::span<const int> face = faces[f];
        const auto pieces = face.size() == 4 ? triangles_of_quad(positions, face) : fan(face, 0);
        triangles.insert(triangles.end(), pieces.begin(), pieces.end());
    }
    return triangles;
}

void append(std::string& bytes, const Eigen::Vector3d& vector) {
    for (const double coordinate : vector) append_little_endian(bytes, static_cast<float>(coordinate));
}

}  // namespace

std::string write_stl(const Positions& positions, const Faces& faces) {
    check_range(positions);
    const std::vector<Triangle> triangles = triangles_of(positions, faces);
    // The first 80 bytes are free, but must not begin with "solid", as STL as text does.
    std::string bytes = "binary STL";
    bytes.resize(80, ' ');
    append_little_endian(bytes, static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& triangle : triangles) {
        append(bytes, direction_of(area_vector(positions, triangle)));
        for (const int vertex : triangle) append(bytes, positions.col(vertex));
        append_little_endian(bytes, std::uint16_t{0});  // attributes: none
    }
    return bytes;
}

}  // namespace chebnet
