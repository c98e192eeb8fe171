#include "io/stl.h"

#include <cstdint>
#include <limits>
#include <vector>

#include "base/error.h"
#include "io/bytes.h"
#include "net/triangulation.h"

namespace chebnet {

namespace {

void check_range(const Positions& positions) {
    for (int v = 0; v < positions.cols(); ++v)
        if (!(positions.col(v).cwiseAbs().maxCoeff() <= std::numeric_limits<float>::max()))
            throw Error(ErrorCode::too_large,
                        "vertex " + std::to_string(v) + " has a coordinate that is too large for STL");
}

/// `vector` with the length 1, however small it is; 0 remains 0.
Eigen::Vector3d direction_of(const Eigen::Vector3d& vector) {
    const double largest = vector.cwiseAbs().maxCoeff();
    return largest > 0 ? (vector / largest).normalized() : vector;
}

void append(std::string& bytes, const Eigen::Vector3d& vector) {
    for (const double coordinate : vector) append_little_endian(bytes, static_cast<float>(coordinate));
}

}  // namespace

std::string write_stl(const Positions& positions, const Faces& faces) {
    check_range(positions);
    const std::vector<Triangle> triangles = triangulated(positions, faces);
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
