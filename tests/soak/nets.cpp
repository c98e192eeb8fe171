#include "nets.h"

#include <cmath>
#include <numbers>

#include "../core/sample_nets.h"
#include "shapes/shapes.h"

namespace chebnet::soak {

namespace {

int number(Random& random, int smallest, int largest) {
    return std::uniform_int_distribution<int>(smallest, largest)(random);
}

double real(Random& random, double smallest, double largest) {
    return std::uniform_real_distribution<double>(smallest, largest)(random);
}

/// Sizes are spread over orders of magnitude: faults of small nets are easier to understand.
int size(Random& random, int smallest, int largest) {
    return static_cast<int>(std::exp(real(random, std::log(smallest), std::log(largest + 1.0))));
}

Net shape(const std::string& name, int largest, Random& random) {
    return make_shape(name + ":vertices=" + std::to_string(size(random, 100, largest))).net;
}

/// m × n vertices in the plane, with edges of length 1.
Positions lattice(int m, int n) {
    Positions x = Positions::Zero(3, m * n);
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < m; ++i) x.col(j * m + i).head<2>() << i, j;
    return x;
}

Faces quads(int m, int n) {
    Faces faces;
    for (int j = 0; j + 1 < n; ++j)
        for (int i = 0; i + 1 < m; ++i) faces.add({j * m + i, j * m + i + 1, (j + 1) * m + i + 1, (j + 1) * m + i});
    return faces;
}

Faces triangles(int m, int n) {
    Faces faces;
    for (int j = 0; j + 1 < n; ++j)
        for (int i = 0; i + 1 < m; ++i) {
            const int a = j * m + i, b = a + 1, c = b + m, d = a + m;
            faces.add({a, b, c});
            faces.add({a, c, d});
        }
    return faces;
}

Net patch(int largest, Random& random) {
    const int m = size(random, 2, static_cast<int>(std::sqrt(largest)));
    const int n = size(random, 2, largest / m);
    return Net(lattice(m, n), quads(m, n));
}

/// Edges of random lengths, which each keeps.
Net shaken_triangles(int largest, Random& random) {
    const int m = size(random, 2, static_cast<int>(std::sqrt(largest))), n = m + number(random, 0, 3);
    Positions x = lattice(m, n);
    for (double& coordinate : x.reshaped()) coordinate += real(random, -0.3, 0.3);
    return Net(x, triangles(m, n), RestLengths::own);
}

/// Lengths that differ by a factor of up to a million.
Net graded(int largest, Random& random) {
    const int m = size(random, 3, static_cast<int>(std::sqrt(largest)));
    const double growth = std::pow(10, real(random, 0.5, 6) / m);
    Positions x = lattice(m, m);
    for (int i = 0; i < x.cols(); ++i)
        for (int axis = 0; axis < 2; ++axis) x(axis, i) = std::pow(growth, x(axis, i));
    return Net(x, quads(m, m), RestLengths::own);
}

Net fan(int largest, Random& random) {
    const int n = size(random, 3, std::min(largest, 300));
    Positions x = Positions::Zero(3, n + 1);
    Faces faces;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        x.col(i + 1) << std::cos(angle), std::sin(angle), 0.1 * (i % 3);
        faces.add({0, i + 1, (i + 1) % n + 1});
    }
    return Net(x, faces, RestLengths::own);
}

/// One face of many sides: nothing keeps it stiff.
Net polygon(int, Random& random) {
    const int n = number(random, 3, 60);
    Positions x = Positions::Zero(3, n);
    Faces faces;
    std::vector<int> face;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        x.col(i) << std::cos(angle), std::sin(angle), 0;
        face.push_back(i);
    }
    faces.add(face);
    return Net(x, faces);
}

/// A band of quads whose ends are joined, with a half twist or without.
Net band(bool twisted, Random& random) {
    const int n = number(random, 8, 80);
    const double radius = n / (2 * std::numbers::pi);
    Positions x(3, 2 * n);
    Faces faces;
    for (int i = 0; i < n; ++i) {
        const double u = 2 * std::numbers::pi * i / n, tilt = twisted ? u / 2 : 0;
        const Eigen::Vector3d outward(std::cos(u), std::sin(u), 0);
        const Eigen::Vector3d across = 0.5 * (std::cos(tilt) * Eigen::Vector3d::UnitZ() + std::sin(tilt) * outward);
        x.col(2 * i) = radius * outward - across;
        x.col(2 * i + 1) = radius * outward + across;
        const int a = 2 * ((i + 1) % n), last = twisted && i + 1 == n ? 1 : 0;
        faces.add({2 * i, 2 * i + 1, a + 1 - last, a + last});
    }
    return Net(x, faces);
}

/// Several patches that touch in one vertex each, or not at all.
Net pieces(bool touching, Random& random) {
    const int count = number(random, 2, 5), m = number(random, 2, 6);
    const Positions tile = lattice(m, m);
    const Faces tile_faces = quads(m, m);
    const int own = m * m - (touching ? 1 : 0);  // of each tile but the first: its vertex 0 is the last one's last
    Positions x(3, count * own + (touching ? 1 : 0));
    Faces faces;
    for (int k = 0; k < count; ++k) {
        const Eigen::Vector3d shift = k * Eigen::Vector3d(m - (touching ? 1 : 0), m - (touching ? 1 : 0), 0);
        for (int v = 0; v < m * m; ++v) x.col(k * own + v) = tile.col(v) + shift;
        for (int f = 0; f < tile_faces.size(); ++f) {
            std::vector<int> face(tile_faces[f].begin(), tile_faces[f].end());
            for (int& v : face) v += k * own;
            faces.add(face);
        }
    }
    return Net(x, faces);
}

Net scaled_patch(double exponent, Random& random) {
    const int m = number(random, 3, 12);
    return Net(std::pow(10, exponent) * lattice(m, m), quads(m, m));
}

/// Where coordinates leave few digits for the edges.
Net distant_patch(Random& random) {
    const int m = number(random, 3, 12);
    Positions x = lattice(m, m);
    x.colwise() += Eigen::Vector3d(std::pow(10, real(random, 3, 9)), 0, -std::pow(10, real(random, 3, 9)));
    return Net(x, quads(m, m), RestLengths::equal);
}

/// Rest positions far from a net with its lengths: some of the vertices lie on each other.
Net crumpled_patch(Random& random) {
    const int m = number(random, 3, 10);
    Positions x = lattice(m, m);
    for (int v = 0; v < x.cols(); ++v)
        if (x(0, v) > m / 2) x(0, v) = m / 2 * 2 - x(0, v);
    return Net(x, quads(m, m));
}

/// With corners sharper than a limit may allow: of a patch, which can be opened, or of a box, which is rigid.
Net leaning(bool closed, Random& random) {
    const Net upright = closed ? samples::cube() : patch(100, random);
    Positions x = upright.rest_positions();
    x.row(0) += real(random, 0.5, 3) * x.row(closed ? 2 : 1);
    return Net(x, upright.faces(), RestLengths::own);
}

}  // namespace

std::vector<NetKind> net_kinds(int largest) {
    std::vector<NetKind> kinds;
    for (const ShapeInfo& info : shape_table()) {
        const std::string name = info.name;
        kinds.push_back({name, [=](Random& random) { return shape(name, largest, random); }});
    }
    kinds.push_back({"patch", [=](Random& random) { return patch(largest, random); }});
    kinds.push_back({"shaken triangles", [=](Random& random) { return shaken_triangles(largest, random); }});
    kinds.push_back({"graded", [=](Random& random) { return graded(largest, random); }});
    kinds.push_back({"fan", [=](Random& random) { return fan(largest, random); }});
    kinds.push_back({"polygon", [=](Random& random) { return polygon(largest, random); }});
    kinds.push_back({"band", [](Random& random) { return band(false, random); }});
    kinds.push_back({"Möbius band", [](Random& random) { return band(true, random); }});
    kinds.push_back({"pieces", [](Random& random) { return pieces(false, random); }});
    kinds.push_back({"touching pieces", [](Random& random) { return pieces(true, random); }});
    kinds.push_back({"huge", [](Random& random) { return scaled_patch(real(random, 5, 55), random); }});
    kinds.push_back({"tiny", [](Random& random) { return scaled_patch(-real(random, 5, 55), random); }});
    kinds.push_back({"distant", distant_patch});
    kinds.push_back({"crumpled", crumpled_patch});
    kinds.push_back({"leaning", [](Random& random) { return leaning(false, random); }});
    kinds.push_back({"leaning box", [](Random& random) { return leaning(true, random); }});
    return kinds;
}

}  // namespace chebnet::soak
