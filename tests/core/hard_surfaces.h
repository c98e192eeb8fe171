#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "implicit_surface.h"
#include "net/repair.h"
#include "sample_surfaces.h"

/// Surfaces as files have them: bodies of several genus, noise, holes, thin ones, slivers, pieces, faults that were
/// repaired, and sizes from a millionth to a million.
namespace chebnet::samples {

struct NamedMesh {
    std::string name;
    Mesh mesh;
};

inline Mesh changed(Mesh mesh, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& change) {
    for (auto point : mesh.positions.colwise()) point = change(point);
    return mesh;
}

inline Mesh stretched(const Mesh& mesh, double x, double y, double z) {
    return changed(mesh, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(x * p.x(), y * p.y(), z * p.z()); });
}

/// Without the faces for which a function of their middle holds.
inline Mesh without(const Mesh& mesh, const std::function<bool(const Eigen::Vector3d&)>& is_hole) {
    Mesh left{mesh.positions, {}};
    for (int f = 0; f < mesh.faces.size(); ++f) {
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const int v : mesh.faces[f]) middle += mesh.positions.col(v) / std::ssize(mesh.faces[f]);
        if (!is_hole(middle)) left.faces.add(mesh.faces[f]);
    }
    return repair(left, k_all_defects).mesh;
}

inline Mesh together(const Mesh& a, const Mesh& b) {
    Mesh both = a;
    const int first = static_cast<int>(a.positions.cols());
    both.positions.conservativeResize(3, first + b.positions.cols());
    both.positions.rightCols(b.positions.cols()) = b.positions;
    for (int f = 0; f < b.faces.size(); ++f) {
        std::vector<int> face(b.faces[f].begin(), b.faces[f].end());
        for (int& v : face) v += first;
        both.faces.add(face);
    }
    return both;
}

/// A sphere with bumps, by a seed.
inline Mesh blob(unsigned seed, double height = 0.25) {
    std::mt19937 random(seed);
    std::array<Eigen::Vector3d, 6> waves;
    std::generate(waves.begin(), waves.end(), [&] { return random_point(3, random); });
    return changed(sphere(20), [&](const Eigen::Vector3d& p) {
        double radius = 1;
        for (const Eigen::Vector3d& wave : waves) radius += height / 2 * std::sin(wave.dot(p) + wave.x());
        return Eigen::Vector3d(radius * p);
    });
}

inline Mesh noisy(const Mesh& mesh, double height) {
    std::mt19937 random(7);
    return changed(mesh, [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(p + random_point(height, random)); });
}

/// So many rings in a row, melted into each other.
inline Mesh chain_of_rings(int rings) {
    return implicit_surface(40, {-1.7, -1.7, -0.7}, {1.7 + 2 * (rings - 1), 1.7, 0.7}, [&](const Eigen::Vector3d& p) {
        double sum = 0;
        for (int ring = 0; ring < rings; ++ring) {
            const Eigen::Vector3d q = p - Eigen::Vector3d(2 * ring, 0, 0);
            const double across = std::hypot(std::hypot(q.x(), q.y()) - 1, q.z()) - 0.35;
            sum += std::exp(-12 * across);
        }
        return 1 - sum;
    });
}

/// A tube around a trefoil.
inline Mesh knot() {
    const auto centre = [](double t) {
        return Eigen::Vector3d(std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t));
    };
    return quads(240, 16, true, true, [&](int i, int j) {
        const double t = 2 * std::numbers::pi * i / 240, v = 2 * std::numbers::pi * j / 16;
        const Eigen::Vector3d along = (centre(t + 1e-4) - centre(t - 1e-4)).normalized();
        const Eigen::Vector3d across = along.cross(Eigen::Vector3d(0, 0, 1)).normalized();
        return Eigen::Vector3d(centre(t) + 0.4 * (std::cos(v) * across + std::sin(v) * across.cross(along)));
    });
}

/// All triangles with vertices of their own, as STL has them.
inline Mesh soup(const Mesh& mesh) {
    Mesh loose;
    loose.positions.resize(3, static_cast<Eigen::Index>(mesh.faces.vertices.size()));
    for (int f = 0; f < mesh.faces.size(); ++f) {
        std::vector<int> face;
        for (int at = mesh.faces.start[f]; at < mesh.faces.start[f + 1]; ++at) {
            loose.positions.col(at) = mesh.positions.col(mesh.faces.vertices[at]);
            face.push_back(at);
        }
        loose.faces.add(face);
    }
    return loose;
}

/// Every third face wound the other way.
inline Mesh ill_wound(const Mesh& mesh) {
    Mesh turned{mesh.positions, {}};
    for (int f = 0; f < mesh.faces.size(); ++f) {
        std::vector<int> face(mesh.faces[f].begin(), mesh.faces[f].end());
        if (f % 3 == 0) std::reverse(face.begin(), face.end());
        turned.faces.add(face);
    }
    return turned;
}

/// Three leaves at one spine, where only two may meet.
inline Mesh book() {
    Mesh leaves;
    for (const double angle : {0.0, 2.1, 4.2})
        leaves = together(leaves, quads(12, 12, false, false, [&](int i, int j) {
                              return Eigen::Vector3d(i / 11. * std::cos(angle), i / 11. * std::sin(angle), j / 11.);
                          }));
    return leaves;
}

inline bool is_near_any(const Eigen::Vector3d& point, const Mesh& centres, double radius) {
    return (centres.positions.colwise() - point).colwise().norm().minCoeff() < radius;
}

inline std::vector<NamedMesh> hard_surfaces() {
    const auto spike = [](double x, double y) { return 2 * std::exp(-8 * (x * x + y * y)); };
    const auto cliff = [](double x, double y) { return 0.4 * std::tanh(12 * x + 2 * y); };
    const auto waves = [](double x, double y) { return 0.2 * std::sin(5 * x) * std::cos(4 * y); };
    const auto gyroid = [](const Eigen::Vector3d& p) {
        return std::sin(p.x()) * std::cos(p.y()) + std::sin(p.y()) * std::cos(p.z()) +
               std::sin(p.z()) * std::cos(p.x());
    };
    const auto globe = [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 48, v = std::numbers::pi * (j + 0.1) / 32.2;
        return Eigen::Vector3d(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), -std::cos(v));
    };
    const auto catenoid = [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 60, v = j / 12. - 1;
        return Eigen::Vector3d(std::cosh(v) * std::cos(u), std::cosh(v) * std::sin(u), v);
    };
    const auto helicoid = [](int i, int j) {
        const double angle = i / 12., radius = 0.2 + j / 15.;
        return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0.3 * angle);
    };
    const auto cone = [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / 48, radius = 0.1 + j / 24.;
        return Eigen::Vector3d(radius * std::cos(u), radius * std::sin(u), -2 * radius);
    };
    const Mesh ball = sphere(16);
    return {
        {"sphere", ball},
        {"globe of slivers with two small holes", quads(48, 33, true, false, globe)},
        {"needle", stretched(sphere(24), 0.15, 0.15, 3)},
        {"disc of two sides", stretched(sphere(24), 2, 2, 0.1)},
        {"egg", stretched(sphere(16), 1, 1.2, 1.7)},
        {"first blob", blob(1)},
        {"second blob", blob(2)},
        {"third blob", blob(3)},
        {"blob with deep hollows", blob(4, 0.45)},
        {"scanned ball", noisy(sphere(24), 0.012)},
        {"scanned field", noisy(graph(40, 1, waves), 0.008)},
        {"fat torus", torus(48, 32, 1, 0.6)},
        {"thin torus", torus(96, 12, 3, 0.25)},
        {"knot", knot()},
        {"one ring", chain_of_rings(1)},
        {"two rings", chain_of_rings(2)},
        {"three rings", chain_of_rings(3)},
        {"gyroid", implicit_surface(24, {0.3, 0.2, 0.1}, {5, 5, 5}, gyroid)},
        {"ball with a hole", without(ball, [](const auto& p) { return p.z() > 0.8; })},
        {"ball with six holes", without(sphere(24), [](const auto& p) { return p.cwiseAbs().maxCoeff() > 0.95; })},
        {"sieve", without(plane(41, 1),
                          [](const auto& p) {
                              return std::abs(std::sin(5 * p.x())) > 0.9 && std::abs(std::sin(5 * p.y())) > 0.9;
                          })},
        {"cylinder", cylinder(48, 20, 1.5)},
        {"cone", quads(48, 24, true, false, cone)},
        {"hemisphere", sphere(20, true)},
        {"catenoid", quads(60, 25, true, false, catenoid)},
        {"helicoid", quads(100, 16, false, false, helicoid)},
        {"spike", graph(48, 1, spike)},
        {"cliff", graph(48, 1, cliff)},
        {"roof", graph(21, 1, [](double x, double) { return -std::abs(x); })},
        {"long strip", stretched(graph(60, 1, waves), 10, 0.3, 0.5)},
        {"soup", repair(soup(blob(5)), k_all_defects).mesh},
        {"ill wound", repair(ill_wound(blob(6)), k_all_defects).mesh},
        {"book of three leaves", repair(book(), k_all_defects).mesh},
        {"balls that touch",
         repair(
             together(ball, changed(ball, [](const auto& p) { return Eigen::Vector3d(p + Eigen::Vector3d(2, 0, 0)); })),
             k_all_defects)
             .mesh},
        {"ball beside a ring",
         together(ball, changed(torus(48, 24, 1, 0.4),
                                [](const auto& p) { return Eigen::Vector3d(p + Eigen::Vector3d(4, 0, 0)); }))},
        {"cube of twelve triangles",
         implicit_surface(1, {-1, -1, -1}, {1, 1, 1}, [](const Eigen::Vector3d& p) { return p.sum() - 0.5; })},
        {"octahedron", sphere(1)},
        {"tiny", stretched(blob(7), 1e-6, 1e-6, 1e-6)},
        {"huge", stretched(blob(8), 1e6, 1e6, 1e6)},
        {"far from the origin",
         changed(blob(9), [](const auto& p) { return Eigen::Vector3d(p + Eigen::Vector3d(3000, -2000, 500)); })},
    };
}

}  // namespace chebnet::samples
