#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <vector>

#include "edit/editor.h"
#include "net/net.h"

namespace chebnet::samples {

/// A patch of m × n vertices with edges of length 1, flat (arch = 0) or bent into a translational surface: both
/// families of net lines are polylines of unit chords whose direction turns by up to ±arch radians.
inline Net patch(int m, int n, double arch = 0.6) {
    const auto polyline = [&](int count, const Eigen::Vector3d& along) {
        Positions points = Positions::Zero(3, count);
        for (int i = 1; i < count; ++i) {
            const double angle = count > 2 ? arch * (1 - 2.0 * (i - 1) / (count - 2)) : 0;
            points.col(i) = points.col(i - 1) + std::cos(angle) * along + std::sin(angle) * Eigen::Vector3d::UnitZ();
        }
        return points;
    };
    const Positions u = polyline(m, Eigen::Vector3d::UnitX()), v = polyline(n, Eigen::Vector3d::UnitY());
    Positions x(3, m * n);
    Faces faces;
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < m; ++i) {
            x.col(j * m + i) = u.col(i) + v.col(j);
            if (i + 1 < m && j + 1 < n) faces.add({j * m + i, j * m + i + 1, (j + 1) * m + i + 1, (j + 1) * m + i});
        }
    return Net(x, faces);
}

/// A ring of quads: `along` rows of `around` vertices each, open as a tube or closed as a torus.
inline Net ring(int around, int along, bool closed) {
    Positions x(3, around * along);
    Faces faces;
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const double u = 2 * EIGEN_PI * i / around, v = 2 * EIGEN_PI * j / along;
            const Eigen::Vector3d outward(std::cos(u), std::sin(u), 0);
            x.col(j * around + i) = (3 + std::cos(v)) * outward + std::sin(v) * Eigen::Vector3d::UnitZ();
            const int next_row = (j + 1) % along * around, next = (i + 1) % around;
            if (closed || j + 1 < along) faces.add({j * around + i, j * around + next, next_row + next, next_row + i});
        }
    return Net(x, faces);
}

/// The surface of a unit cube: 8 singular vertices of valence 3, closed.
inline Net cube() {
    Positions x(3, 8);
    for (int i = 0; i < 8; ++i) x.col(i) << (i & 1), (i >> 1 & 1), (i >> 2 & 1);
    Faces faces;
    faces.add({0, 2, 3, 1});
    faces.add({4, 5, 7, 6});
    faces.add({0, 1, 5, 4});
    faces.add({2, 6, 7, 3});
    faces.add({0, 4, 6, 2});
    faces.add({1, 3, 7, 5});
    return Net(x, faces);
}

/// A triangle, a quad and a pentagon in a row, with edges of different lengths: a general mesh.
inline Net mixed_mesh() {
    Positions x(3, 8);
    x << 0, 1, 2, 3, 3.5, 3, 2, 1,   //
        0, 0, 0, 0, 0.6, 1.2, 1, 1,  //
        0, 0.1, 0, 0.1, 0, 0.1, 0, 0.2;
    Faces faces;
    faces.add({0, 1, 7});
    faces.add({1, 2, 6, 7});
    faces.add({2, 3, 4, 5, 6});
    return Net(x, faces);
}

/// A net and its copy, shifted: two pieces, the vertices of the second behind those of the first.
inline Net twice(const Net& net, const Eigen::Vector3d& shift) {
    Positions x(3, 2 * net.vertex_count());
    x << net.rest_positions(), net.rest_positions().colwise() + shift;
    Faces faces = net.faces();
    for (int f = 0; f < net.face_count(); ++f) {
        std::vector<int> copied(net.faces()[f].begin(), net.faces()[f].end());
        for (int& v : copied) v += net.vertex_count();
        faces.add(copied);
    }
    return Net(x, faces);
}

/// Handles at the given vertices, at rest.
inline std::vector<Handle> handles_at_rest(const Net& net, const std::vector<int>& vertices) {
    std::vector<Handle> handles;
    handles.reserve(vertices.size());
    for (int v : vertices) handles.push_back({v, net.rest_positions().col(v)});
    return handles;
}

/// Moves every coordinate by up to ± amount.
inline Positions shaken(Positions x, double amount, std::mt19937& random) {
    std::uniform_real_distribution<double> noise(-amount, amount);
    for (double& coordinate : x.reshaped()) coordinate += noise(random);
    return x;
}

inline double largest_move(const Positions& a, const Positions& b) { return (a - b).colwise().norm().maxCoeff(); }

inline int euler_characteristic(const Net& net) { return net.vertex_count() - net.edge_count() + net.face_count(); }

inline double dot(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }

}  // namespace chebnet::samples
