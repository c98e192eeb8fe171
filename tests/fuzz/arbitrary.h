#pragma once

// libFuzzer's own: takes values off an input, and defaults where it has ended.
#include <fuzzer/FuzzedDataProvider.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "core/sample_surfaces.h"
#include "net/mesh.h"

/// Values for the targets that are given numbers, meshes and calls rather than text.
namespace chebnet::fuzz {

/// Any number whatever: more often than by chance small, huge, tiny or at the ends of the range.
inline double any_number(FuzzedDataProvider& input) {
    switch (input.ConsumeIntegralInRange(0, 7)) {
        case 0:
            return input.ConsumeIntegralInRange(-8, 8);
        case 1:
            return std::ldexp(input.ConsumeIntegralInRange(-8, 8), input.ConsumeIntegralInRange(-1074, 1023));
        case 2:
            return input.PickValueInArray({0.0, -0.0, std::numeric_limits<double>::max(),
                                           std::numeric_limits<double>::lowest(),
                                           std::numeric_limits<double>::denorm_min()});
        case 3:
            return input.PickValueInArray({std::numeric_limits<double>::infinity(),
                                           -std::numeric_limits<double>::infinity(),
                                           std::numeric_limits<double>::quiet_NaN()});
        case 4:
            return std::bit_cast<double>(input.ConsumeIntegral<std::uint64_t>());
        default:
            return input.ConsumeFloatingPointInRange(-4.0, 4.0);
    }
}

inline double finite_number(FuzzedDataProvider& input) {
    const double number = any_number(input);
    return std::isfinite(number) ? number : 0;
}

/// A mesh of up to 24 vertices, at any places, with up to 24 faces of any vertices; nothing about it need be sound but
/// that the faces name vertices that exist.
inline Mesh any_mesh(FuzzedDataProvider& input) {
    Mesh mesh{Positions::Zero(3, input.ConsumeIntegralInRange(1, 24)), {}};
    const int last = static_cast<int>(mesh.positions.cols()) - 1;
    const bool on_lattice = input.ConsumeBool();  // many coincide
    for (double& x : mesh.positions.reshaped())
        x = on_lattice ? input.ConsumeIntegralInRange(0, 3) : finite_number(input);
    for (int faces = input.ConsumeIntegralInRange(0, 24); faces > 0; --faces) {
        std::vector<int> face;
        for (int corners = input.ConsumeIntegralInRange(1, 6); corners > 0; --corners)
            face.push_back(input.ConsumeIntegralInRange(0, last));
        mesh.faces.add(face);
    }
    return mesh;
}

inline void replace_some_coordinates(Mesh& mesh, FuzzedDataProvider& input) {
    for (int changes = input.ConsumeIntegralInRange(0, 8); changes > 0; --changes)
        mesh.positions.reshaped()[input.ConsumeIntegralInRange<Eigen::Index>(0, mesh.positions.size() - 1)] =
            finite_number(input);
}

/// A dish, a hill or a saddle with a round border, up to 14 × 14 vertices, as rough as a scan, or smooth.
inline Mesh any_rough_dish(FuzzedDataProvider& input) {
    const int n = input.ConsumeIntegralInRange(4, 14);
    const double height = input.ConsumeFloatingPointInRange(-1.5, 1.5), saddle = input.ConsumeIntegralInRange(0, 1);
    const double roughness = input.ConsumeFloatingPointInRange(0.0, 0.4) / n;
    std::mt19937 random(input.ConsumeIntegral<std::uint32_t>());
    return samples::quads(n, n, false, false, [&](int i, int j) {
        // The square onto the disc, border to border.
        const double u = 2. * i / (n - 1) - 1, v = 2. * j / (n - 1) - 1;
        const double x = u * std::sqrt(1 - v * v / 2), y = v * std::sqrt(1 - u * u / 2);
        const double z = height * (x * x + (1 - 2 * saddle) * y * y);
        return Eigen::Vector3d(Eigen::Vector3d(x, y, z) + samples::random_point(roughness, random));
    });
}

/// A patch of quads, up to 6 × 6 vertices, with some of its coordinates replaced.
inline Mesh any_patch(FuzzedDataProvider& input) {
    const int columns = input.ConsumeIntegralInRange(2, 6), rows = input.ConsumeIntegralInRange(2, 6);
    Mesh mesh{Positions::Zero(3, columns * rows), {}};
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const int v = j * columns + i;
            mesh.positions.col(v) << i, j, 0.1 * (i + j) * (i - j);
            if (i > 0 && j > 0) mesh.faces.add({v - columns - 1, v - columns, v, v - 1});
        }
    replace_some_coordinates(mesh, input);
    return mesh;
}

/// A tube that may narrow, or a ring, of up to 8 × 6 vertices, with some of its coordinates replaced.
inline Mesh any_tube(FuzzedDataProvider& input) {
    const int around = input.ConsumeIntegralInRange(3, 8), along = input.ConsumeIntegralInRange(3, 6);
    const bool is_ring = input.ConsumeBool();
    const double thickness = input.ConsumeFloatingPointInRange(0.0, 1.0);
    Mesh mesh = samples::quads(around, along, true, is_ring, [&](int i, int j) {
        const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / along;
        const double radius = is_ring ? 1 + thickness * std::cos(v) : 1 - thickness * j / along;
        const double height = is_ring ? thickness * std::sin(v) : 2. * j / along - 1;
        return Eigen::Vector3d(radius * std::cos(u), radius * std::sin(u), height);
    });
    replace_some_coordinates(mesh, input);
    return mesh;
}

}  // namespace chebnet::fuzz
