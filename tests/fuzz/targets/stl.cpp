#include "io/stl.h"

#include <cmath>
#include <limits>

#include "arbitrary.h"
#include "io/bytes.h"
#include "io/mesh_file.h"
#include "require.h"

using namespace chebnet;
using fuzz::require;

namespace {

constexpr std::size_t k_header_size = 84, k_triangle_size = 50;

double float_at(const std::string& bytes, std::size_t place) {
    return number_at<float>(bytes.data() + place, std::endian::little);
}

bool fits_float(const Mesh& mesh) { return (mesh.positions.array().abs() <= std::numeric_limits<float>::max()).all(); }

/// Whether floats leave nothing of the mesh: each face has one place, or has no triangle.
bool floats_leave_points(const Mesh& mesh) {
    const Eigen::Matrix3Xf written = mesh.positions.cast<float>();
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (const int v : mesh.faces[f])
            if (mesh.faces[f].size() >= 3 && written.col(v) != written.col(mesh.faces[f][0])) return false;
    return true;
}

/// Whether there is a reason to refuse the mesh that `code` names.
bool is_refused_rightly(ErrorCode code, const Mesh& mesh) {
    if (!fits_float(mesh)) return code == ErrorCode::too_large;
    return code == ErrorCode::bad_scale && floats_leave_points(mesh);
}

/// Where `offset` begins three floats: every one is finite.
Eigen::Vector3d vector_at(const std::string& bytes, std::size_t offset) {
    const Eigen::Vector3d vector(float_at(bytes, offset), float_at(bytes, offset + 4), float_at(bytes, offset + 8));
    require(vector.allFinite(), "STL with a number that is not finite");
    return vector;
}

bool is_a_vertex(const Mesh& mesh, const Eigen::Vector3d& corner) {
    return ((mesh.positions.cast<float>().cast<double>().colwise() - corner).colwise().squaredNorm().array() == 0)
        .any();
}

void require_triangles(const Mesh& mesh, const std::string& bytes) {
    std::size_t count = 0;
    for (int f = 0; f < mesh.faces.size(); ++f) count += std::max<std::size_t>(2, mesh.faces[f].size()) - 2;
    require(bytes.size() == k_header_size + count * k_triangle_size, "STL of an unexpected size");
    require(number_at<std::uint32_t>(bytes.data() + 80, std::endian::little) == count, "STL with another count");
    for (std::size_t at = k_header_size; at < bytes.size(); at += k_triangle_size) {
        const double length = vector_at(bytes, at).norm();
        require(length == 0 || std::abs(length - 1) < 1e-6, "a normal of length " + std::to_string(length));
        for (int corner = 1; corner <= 3; ++corner)
            require(is_a_vertex(mesh, vector_at(bytes, at + 12 * corner)), "a corner that is no vertex of the mesh");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider input(data, size);
    const Mesh mesh = input.ConsumeBool() ? fuzz::any_mesh(input) : fuzz::any_patch(input);
    try {
        const std::string bytes = write_stl(mesh.positions, mesh.faces);
        require_triangles(mesh, bytes);
        const Mesh again = read_stl(bytes, "net");
        require(bytes.size() == k_header_size + again.faces.size() * k_triangle_size, "triangles do not come back");
    } catch (const Error& error) {
        fuzz::require_readable(error);
        require(is_refused_rightly(error.code(), mesh), "STL is refused without need");
    }
    return 0;
}
