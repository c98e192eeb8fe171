#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "net/mesh.h"
#include "surface/surface.h"

namespace chebnet::samples {

/// The quads of m × n points, point(i, j) for i < m and j < n; a closed direction joins its last point to its first.
inline Mesh quads(int m, int n, bool closed_i, bool closed_j, const std::function<Eigen::Vector3d(int, int)>& point) {
    Mesh mesh{Positions(3, m * n), {}};
    const auto vertex = [&](int i, int j) { return j % n * m + i % m; };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < m; ++i) {
            mesh.positions.col(vertex(i, j)) = point(i, j);
            if ((closed_i || i + 1 < m) && (closed_j || j + 1 < n))
                mesh.faces.add({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return mesh;
}

/// The surface z = height(x, y) over the square [−size, size]², of n × n points.
inline Mesh graph(int n, double size, const std::function<double(double, double)>& height) {
    return quads(n, n, false, false, [&](int i, int j) {
        const double x = size * (2. * i / (n - 1) - 1), y = size * (2. * j / (n - 1) - 1);
        return Eigen::Vector3d(x, y, height(x, y));
    });
}
inline Mesh plane(int n, double size) {
    return graph(n, size, [](double, double) { return 0; });
}

/// Around the z axis with radius 1, from z = −height to height.
inline Mesh cylinder(int around, int along, double height) {
    return quads(around, along, true, false, [&](int i, int j) {
        const double u = 2 * std::numbers::pi * i / around;
        return Eigen::Vector3d(std::cos(u), std::sin(u), height * (2. * j / (along - 1) - 1));
    });
}

/// Likewise from z = 0 to height, each ring turned by so many columns against the one before: slanted triangles are
/// obtuse ones.
inline Mesh slanted_tube(int around, int along, double slant, double height) {
    return quads(around, along, true, false, [&](int i, int j) {
        const double angle = 2 * std::numbers::pi * (i + slant * j) / around;
        return Eigen::Vector3d(std::cos(angle), std::sin(angle), height * j / (along - 1));
    });
}

inline Mesh torus(int around, int across, double large, double small) {
    return quads(around, across, true, true, [&](int i, int j) {
        const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
        const double r = large + small * std::cos(v);
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), small * std::sin(v));
    });
}

/// The unit sphere, or its half above z = 0: faces of an octahedron cut into n² triangles each and blown up.
inline Mesh sphere(int n, bool half = false) {
    Mesh mesh;
    const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    std::vector<Eigen::Vector3d> points;
    for (const double below : {1., -1.}) {
        if (half && below < 0) continue;
        const Eigen::Vector3d around[] = {x, y, -x, -y};
        for (int k = 0; k < 4; ++k) {
            const Eigen::Vector3d a = around[k], b = around[(k + 1) % 4], c = below * z;
            const int first = static_cast<int>(points.size());
            const auto vertex = [&](int i, int j) { return first + j * (n + 1) - j * (j - 1) / 2 + i; };
            for (int j = 0; j <= n; ++j)
                for (int i = 0; i + j <= n; ++i) points.push_back(((n - i - j) * a + i * b + j * c).normalized());
            const auto add = [&](int p, int q, int r) {
                below > 0 ? mesh.faces.add({p, q, r}) : mesh.faces.add({p, r, q});
            };
            for (int j = 0; j < n; ++j)
                for (int i = 0; i + j < n; ++i) {
                    add(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
                    if (i + j + 1 < n) add(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
                }
        }
    }
    mesh.positions.resize(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) mesh.positions.col(static_cast<Eigen::Index>(i)) = points[i];
    return repair(mesh, {Defect::duplicate_vertices}).mesh;
}

/// The unit sphere as a scan has it: every vertex moved along its radius by up to `noise` of it.
inline Mesh rough_sphere(int n, double noise) {
    Mesh mesh = sphere(n);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> amount(-noise, noise);
    for (int v = 0; v < mesh.positions.cols(); ++v) mesh.positions.col(v) *= 1 + amount(random);
    return mesh;
}

/// Anywhere in the cube [−size, size]³.
inline Eigen::Vector3d random_point(double size, std::mt19937& random) {
    std::uniform_real_distribution<double> coordinate(-size, size);
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    return {x, y, z};
}

/// Anywhere on a surface, triangles being equally likely.
inline SurfacePoint random_place(const Surface& surface, std::mt19937& random) {
    std::uniform_int_distribution<int> face(0, surface.face_count() - 1);
    const Eigen::Vector3d weights = random_point(1, random).cwiseAbs();
    return {face(random), weights / weights.sum()};
}

/// Of a polyline.
inline double length_of(const Positions& points) {
    double length = 0;
    for (Eigen::Index i = 1; i < points.cols(); ++i) length += (points.col(i) - points.col(i - 1)).norm();
    return length;
}

}  // namespace chebnet::samples
