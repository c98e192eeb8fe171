#include "surface/gallery.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "base/error.h"
#include "base/text.h"

namespace chebnet {

namespace {

// Points along each parameter.
constexpr int k_points = 49;

/// The surface point(u, v) over the square [−1, 1]², of quads. If `is_round`, it closes from u = 1 to u = −1.
template <class Point>
Mesh over_square(int columns, int rows, bool is_round, Point point) {
    Mesh mesh{Positions(3, columns * rows), {}};
    const int steps = is_round ? columns : columns - 1;
    const auto vertex = [&](int i, int j) { return j * columns + i % columns; };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            mesh.positions.col(vertex(i, j)) = point(2. * i / steps - 1, 2. * j / (rows - 1) - 1);
            if (i < steps && j + 1 < rows)
                mesh.faces.add({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return mesh;
}

/// Half an octahedron flattened to the square, blown up to the unit hemisphere.
Eigen::Vector3d on_hemisphere(double u, double v) {
    const double x = (u - v) / 2, y = (u + v) / 2;
    return Eigen::Vector3d(x, y, 1 - std::abs(x) - std::abs(y)).normalized();
}

/// 1 at a hill's top, falling off around it.
double hill(double x, double y, double steepness) { return 1 / (1 + steepness * (x * x + y * y)); }

Surface make_hypar() {
    return Surface(over_square(k_points, k_points, false,
                               [](double u, double v) { return Eigen::Vector3d(3 * u, 3 * v, 1.8 * u * v); }));
}

Surface make_hemisphere() {
    return Surface(over_square(k_points, k_points, false,
                               [](double u, double v) { return Eigen::Vector3d(3 * on_hemisphere(u, v)); }));
}

Surface make_shell() {
    return Surface(over_square(k_points, k_points, false, [](double u, double v) {
        const double x = u * (1.35 - 0.2 * v * v), y = v * (1 - 0.15 * u * u);
        const double height = 0.62 * hill(x + 0.62, y - 0.1, 1.6) + 0.42 * hill(x - 0.75, y + 0.15, 2.2);
        return Eigen::Vector3d(3 * x, 3 * y, 3 * height);
    }));
}

/// A pebble, thicker at one end and bent.
Surface make_pebble() {
    Mesh mesh;
    for (const double side : {1., -1.}) {
        const Mesh half = over_square(k_points, k_points, false, [&](double u, double v) {
            const Eigen::Vector3d p = on_hemisphere(side * u, v);
            const double width = 1 + 0.22 * p.x();
            return Eigen::Vector3d(3 * p.x(), 2.3 * width * p.y(), 2 * width * side * p.z() + 0.7 * p.x() * p.x());
        });
        const int first = static_cast<int>(mesh.positions.cols());
        mesh.positions.conservativeResize(3, first + half.positions.cols());
        mesh.positions.rightCols(half.positions.cols()) = half.positions;
        for (int f = 0; f < half.faces.size(); ++f) {
            std::vector<int> face(half.faces[f].begin(), half.faces[f].end());
            for (int& v : face) v += first;
            mesh.faces.add(face);
        }
    }
    return repaired_surface(std::move(mesh), {Defect::duplicate_vertices}).surface;
}

/// A tube with hips, a waist and a chest, open above and below.
Surface make_torso() {
    return Surface(over_square(2 * k_points, k_points, true, [](double u, double v) {
        const double around = std::numbers::pi * u;
        const double width = 1.35 + 0.35 * v * v - 0.12 * v, depth = 0.95 + 0.18 * v * v + 0.1 * v;
        return Eigen::Vector3d(width * std::cos(around), depth * std::sin(around) + 0.15 * v * (1 - v * v), 2.6 * v);
    }));
}

constexpr OwnSurface k_own_surfaces[] = {
    {"shell", "Free-form shell", "Two hills that run into each other: a net covers them whole.", make_shell},
    {"hypar", "Hypar", "A saddle of straight lines; along them every cell lies on it.", make_hypar},
    {"hemisphere", "Hemisphere", "About as much curvature as one net can take: its corners get sharp at the border.",
     make_hemisphere},
    {"torso", "Torso", "A tube with a waist: the net goes round it and meets itself in a seam.", make_torso},
    {"pebble", "Pebble", "Closed, with twice the curvature that one net can take: a gap stays where it ends.",
     make_pebble},
};

}  // namespace

std::span<const OwnSurface> own_surfaces() { return k_own_surfaces; }

Surface make_own_surface(std::string_view name) {
    std::string known;
    for (const OwnSurface& surface : k_own_surfaces) {
        if (name == surface.name) return surface.make();
        known.append(known.empty() ? "" : ", ").append(surface.name);
    }
    throw Error(ErrorCode::bad_option, "no surface is called " + quoted(name) + "; known are " + known);
}

}  // namespace chebnet
