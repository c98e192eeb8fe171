#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "net/mesh.h"

namespace chebnet::samples {

inline std::vector<std::vector<int>> faces_of(const Mesh& mesh) {
    std::vector<std::vector<int>> faces;
    faces.reserve(mesh.faces.size());
    for (int f = 0; f < mesh.faces.size(); ++f) faces.emplace_back(mesh.faces[f].begin(), mesh.faces[f].end());
    return faces;
}

inline Mesh with_face(Mesh mesh, std::initializer_list<int> face) {
    mesh.faces.add(face);
    return mesh;
}

/// "code message" of the Error that an action ends in.
template <class Action>
std::string refusal_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return std::string(to_string(error.code())) + " " + error.what();
    }
    return "none";
}

/// A thousand vertices at any finite numbers whatever, and a face each of 3, 4 and 5 vertices.
inline Mesh wild_mesh(std::mt19937_64& random) {
    Mesh mesh{Positions(3, 1000), {}};
    for (double& x : mesh.positions.reshaped()) {
        x = std::bit_cast<double>(random());
        if (!std::isfinite(x)) x = 0;
    }
    mesh.positions.col(0) << -0.0, std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::max();
    mesh.faces.add({0, 1, 2});
    mesh.faces.add({3, 2, 1, 999});
    mesh.faces.add({999, 0, 500, 3, 7});
    return mesh;
}

/// Equal faces, and coordinates equal bit for bit.
inline bool same_bits(const Mesh& a, const Mesh& b) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    if (a.positions.cols() != b.positions.cols()) return false;
    for (Eigen::Index k = 0; k < a.positions.size(); ++k)
        if (bits(a.positions.reshaped()[k]) != bits(b.positions.reshaped()[k])) return false;
    return a.faces.start == b.faces.start && a.faces.vertices == b.faces.vertices;
}

}  // namespace chebnet::samples
