#include "remesh/remesh.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "drape/drape.h"
#include "net/measures.h"
#include "net/topology.h"
#include "remesh/cells.h"
#include "remesh/direction_field.h"
#include "remesh/even_triangles.h"
#include "remesh/grid_map.h"
#include "remesh/integers.h"
#include "sample_surfaces.h"
#include "surface/gallery.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

constexpr double k_degree = std::numbers::pi / 180;

int euler_characteristic(const Net& net) { return net.vertex_count() - net.edge_count() + net.face_count(); }

/// Σ over inner vertices of 4 less their edges, and over those of the boundary of 3 less theirs: four times the Euler
/// characteristic of every mesh of quads.
int valence_defects(const Net& net) {
    const Topology topology(net);
    int sum = 0;
    for (int v = 0; v < net.vertex_count(); ++v) sum += (topology.is_boundary(v) ? 3 : 4) - topology.valence(v);
    return sum;
}

int singular_count(const Net& net) {
    int sum = 0;
    for (const auto& [valence, count] : Topology(net).singular_vertices()) sum += count;
    return sum;
}

/// A net over the whole of it, with all that is promised.
Net remeshed(const Surface& surface, const RemeshOptions& options, int characteristic) {
    const auto guide = std::make_shared<const Guide>(surface);
    const Net net = remesh(guide, options).net;
    CHECK(faces_by_arity(net.faces()).count(4) == 1);
    CHECK(faces_by_arity(net.faces()).size() == 1);
    CHECK(euler_characteristic(net) == characteristic);
    CHECK(valence_defects(net) == 4 * characteristic);
    CHECK(max_deviation(net, net.rest_positions()) < 1e-9);
    CHECK(corner_angle_range(net, net.rest_positions()).smallest >= options.smallest_angle - 1e-9);
    const DrapeReport report = measure_drape(surface, guide->tree(), net);
    CHECK(report.mean_distance < 0.3 * net.mean_length());
    CHECK(report.coverage > 0.85);
    return net;
}

RemeshOptions of_cells(int cells) {
    RemeshOptions options;
    options.cells = cells;
    return options;
}

Surface cube() {
    return Surface(
        {(Positions(3, 8) << 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1).finished(), [] {
             Faces faces;
             for (const auto& face : {std::array{3, 2, 1, 0}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4},
                                      std::array{1, 2, 6, 5}, std::array{2, 3, 7, 6}, std::array{3, 0, 4, 7}})
                 faces.add(face);
             return faces;
         }()});
}

}  // namespace

TEST_CASE("A smooth closed body gets a net with eight singular vertices") {
    const Net net = remeshed(make_own_surface("pebble"), of_cells(400), 2);
    CHECK(net.face_count() == Approx(400).epsilon(0.1));
    CHECK(Topology(net).singular_vertices() == std::map<int, int>{{3, 8}});
}

TEST_CASE("A cube of twelve triangles gets a net with eight singular vertices") {
    CHECK(Topology(remeshed(cube(), of_cells(600), 2)).singular_vertices() == std::map<int, int>{{3, 8}});
}

TEST_CASE("A torus gets a net with few singular vertices, and as many of either kind") {
    const Net net = remeshed(Surface(samples::torus(60, 24, 3, 1)), of_cells(500), 0);
    CHECK(singular_count(net) <= 16);
}

TEST_CASE("A surface with borders gets a net with borders") {
    const Net tube = remeshed(make_own_surface("torso"), of_cells(400), 0);
    CHECK(Topology(tube).boundary_loops().size() == 2);
    const Net hypar = remeshed(make_own_surface("hypar"), of_cells(400), 1);
    CHECK(singular_count(hypar) == 0);
}

TEST_CASE("Net lines do not wave: from vertex to vertex they go on bending to the same side", "[large]") {
    const Net net = remeshed(Surface(samples::sphere(24)), of_cells(1500), 2);
    const Positions& x = net.rest_positions();
    const auto turn = [&](const std::vector<int>& line, std::size_t k) {
        return Eigen::Vector3d(x.col(line[k - 1]) - 2 * x.col(line[k]) + x.col(line[k + 1]));
    };
    double turns = 0, changes = 0;
    for (const std::vector<int>& line : Topology(net).net_lines())
        for (std::size_t k = 2; k + 1 < line.size(); ++k) {
            turns += turn(line, k).squaredNorm();
            changes += (turn(line, k) - turn(line, k - 1)).squaredNorm();
        }
    // Turns that have nothing to do with one another would change by √2 of their size, those of a zigzag by 2.
    CHECK(std::sqrt(changes / turns) < 1.3);
}

TEST_CASE("A rough scan gets a net with as few singular vertices as the shape without its noise") {
    Mesh mesh = samples::sphere(24);
    std::mt19937 random(7);
    for (int v = 0; v < mesh.positions.cols(); ++v) mesh.positions.col(v) += samples::random_point(0.01, random);
    CHECK(singular_count(remeshed(Surface(mesh), of_cells(500), 2)) <= 12);
}

TEST_CASE("All pieces of a surface are covered") {
    Mesh mesh = samples::sphere(8);
    const Mesh other = mesh;
    const int count = static_cast<int>(mesh.positions.cols());
    mesh.positions.conservativeResize(3, 2 * count);
    mesh.positions.rightCols(count) = other.positions.colwise() + Eigen::Vector3d(3, 0, 0);
    for (int f = 0; f < other.faces.size(); ++f) {
        std::vector<int> face(other.faces[f].begin(), other.faces[f].end());
        for (int& v : face) v += count;
        mesh.faces.add(face);
    }
    CHECK(Topology(remeshed(Surface(mesh), of_cells(600), 4)).component_count() == 2);
}

TEST_CASE("The length and the limit of corners are kept where they are given") {
    RemeshOptions options;
    options.length = 0.2;
    options.smallest_angle = 45 * k_degree;
    const Net net = remeshed(Surface(samples::sphere(16)), options, 2);
    CHECK(net.mean_length() == Approx(0.2).epsilon(1e-9));
}

TEST_CASE("The same surface gives the same net, whose progress is told in order and can be ended") {
    const auto surface = std::make_shared<const Guide>(make_own_surface("pebble"));
    std::vector<RemeshPhase> phases;
    const Remesh first = remesh(surface, of_cells(200), [&](RemeshPhase phase, double done) {
        CHECK((done >= 0 && done <= 1));
        if (phases.empty() || phases.back() != phase) phases.push_back(phase);
    });
    CHECK(phases == std::vector{RemeshPhase::triangles, RemeshPhase::field, RemeshPhase::grid, RemeshPhase::fit});
    const Remesh second = remesh(surface, of_cells(200));
    CHECK(first.net.rest_positions() == second.net.rest_positions());
    CHECK(first.net.faces().vertices == second.net.faces().vertices);

    const auto stop = [](RemeshPhase phase, double) {
        if (phase == RemeshPhase::fit) throw std::string("enough");
    };
    CHECK_THROWS_AS(remesh(surface, of_cells(200), stop), std::string);
}

TEST_CASE("What is too thin for its cells is refused, and says so") {
    const auto ring = std::make_shared<const Guide>(Surface(samples::torus(300, 8, 10, 0.01)));
    CHECK_THROWS_WITH(remesh(ring, of_cells(40)), Contains("smaller ones may"));
}

TEST_CASE("Even triangles keep topology and lie on the surface") {
    const Surface surface(samples::torus(40, 12, 3, 1));
    const SurfaceTree tree(surface);
    const Surface even = even_triangles(surface, tree, 0.3);
    int short_or_long = 0;
    for (int s = 0; s < 3 * even.face_count(); ++s) {
        const double length = (even.positions().col(even.to(s)) - even.positions().col(even.from(s))).norm();
        short_or_long += length < 0.15 || length > 0.45 ? 1 : 0;
    }
    CHECK(short_or_long < 3 * even.face_count() / 50);
    CHECK(even.vertex_count() - even.face_count() / 2 == 0);
    for (int v = 0; v < even.vertex_count(); ++v) CHECK(tree.nearest(even.positions().col(v)).distance < 1e-9);
}

TEST_CASE("A field on a sphere has the holonomy of its curvature") {
    const DirectionField field = smoothest_field(Surface(samples::sphere(12)), 0);
    CHECK(chebnet::singular_count(field) == 8);
}

TEST_CASE("A map that folds over still gives quads without gaps") {
    const Surface plane(samples::plane(9, 1));
    const DirectionField field = smoothest_field(plane, 0);
    GridMap map = fit_grid(plane, field, 0.3);
    std::mt19937 random(3);
    std::vector<GridPoint> moved(static_cast<std::size_t>(plane.vertex_count()), GridPoint{});
    for (int v = 0; v < plane.vertex_count(); ++v)
        if (!plane.is_boundary(v))
            for (std::int64_t& part : moved[v])
                part = 2 * (static_cast<std::int64_t>(random() % (2 * k_cell)) - k_cell);
    for (int s = 0; s < 3 * plane.face_count(); ++s)
        for (int axis = 0; axis < 2; ++axis) {
            map.corners[s][axis] += moved[plane.from(s)][axis];
            if (map.corners[s][axis] % (k_cell / 2) == 0) ++map.corners[s][axis];
        }
    const Cells cells = cells_of(plane, map);
    CHECK(cells.size() > 50);
    for (int s = 0; s < 4 * cells.size(); ++s)
        if (cells.opposite[s] >= 0) CHECK(cells.opposite[cells.opposite[s]] == s);
}

TEST_CASE("Integer solutions of conditions are found, all of them") {
    // x + 2 y = 3 z and x = y: all multiples of (1, 1, 1).
    const Eigen::MatrixXi basis = integer_null_space(3, {{{{0, 1}, {1, 2}, {2, -3}}}, {{{0, 1}, {1, -1}}}});
    REQUIRE(basis.cols() == 1);
    CHECK(basis.cwiseAbs() == Eigen::Vector3i(1, 1, 1));
    // 2 x = 3 y: multiples of (3, 2), not of fractions of it.
    const Eigen::MatrixXi other = integer_null_space(2, {{{{0, 2}, {1, -3}}}});
    REQUIRE(other.cols() == 1);
    CHECK(other.cwiseAbs() == Eigen::Vector2i(3, 2));
}

TEST_CASE("Integers are rounded together") {
    // The least of (x − y − 1)² + (0.1 x − 0.04)² + …: x alone would be rounded to 0, and y follows.
    Eigen::Matrix2d A;
    A << 2.02, -2, -2, 2.02;
    CHECK(nearest_integers(A, Eigen::Vector2d(-2.008, 2)) == Eigen::Vector2i(1, 0));
}

TEST_CASE("Numbers out of range are refused") {
    const Surface surface = make_own_surface("hypar");
    const auto refusal = [&](auto change) {
        RemeshOptions options;
        change(options);
        return [&surface, options] { check_remesh(surface, options); };
    };
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.cells = 19; })(), Contains("at least 20"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.cells = 100'001; })(), Contains("more than 100000"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.length = -1; })(), Contains("positive"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.length = NAN; })(), Contains("finite"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.length = 100; })(), Contains("too long"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.smallest_angle = 2; })(), Contains("shear limit"));
    CHECK_THROWS_WITH(refusal([](RemeshOptions& o) { o.smoothing = 101; })(), Contains("smoothing"));
}
