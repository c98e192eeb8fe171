#include "surface/surface_cut.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "base/error.h"
#include "sample_surfaces.h"
#include "surface/curvature.h"
#include "surface/surface_parts.h"
#include "surface/surface_path.h"
#include "surface/surface_point.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

CutLine line_at(const Surface& surface, const std::vector<Eigen::Vector3d>& points) {
    Positions positions(3, std::ssize(points));
    for (std::size_t k = 0; k < points.size(); ++k) positions.col(static_cast<Eigen::Index>(k)) = points[k];
    return cut_line(surface, SurfaceTree(surface), positions);
}

Surface cut(const Surface& surface, const std::vector<std::vector<Eigen::Vector3d>>& lines) {
    std::vector<CutLine> cuts;
    for (const auto& line : lines) cuts.push_back(line_at(surface, line));
    return cut_open(surface, cuts);
}

/// Vertices − edges + faces.
int euler(const Surface& surface) {
    int sides_at_border = 0;
    for (int side = 0; side < 3 * surface.face_count(); ++side) sides_at_border += surface.opposite(side) < 0;
    return surface.vertex_count() - (3 * surface.face_count() + sides_at_border) / 2 + surface.face_count();
}

struct Form {
    int pieces, loops, euler;
    bool operator==(const Form&) const = default;
};
Form form_of(const Surface& surface) {
    return {static_cast<int>(pieces_of(surface).size()), static_cast<int>(surface.boundary_loops().size()),
            euler(surface)};
}
std::ostream& operator<<(std::ostream& out, const Form& form) {
    return out << form.pieces << " pieces, " << form.loops << " borders, Euler " << form.euler;
}

/// V×V, the lengths of the shortest ways along edges (Floyd 1962).
Eigen::MatrixXd ways_along_edges(const Surface& surface) {
    Eigen::MatrixXd ways = Eigen::MatrixXd::Constant(surface.vertex_count(), surface.vertex_count(), 1e300);
    ways.diagonal().setZero();
    for (int side = 0; side < 3 * surface.face_count(); ++side) {
        const int v = surface.from(side), w = surface.to(side);
        ways(v, w) = ways(w, v) = surface.length_of(side);
    }
    for (int u = 0; u < surface.vertex_count(); ++u)
        for (int v = 0; v < surface.vertex_count(); ++v)
            ways.row(v) = ways.row(v).cwiseMin((ways.row(u).array() + ways(v, u)).matrix());
    return ways;
}

void check_same_shape(const Surface& cut, const Surface& whole) {
    CHECK(cut.area() == Approx(whole.area()).epsilon(1e-12));
    double area = 0;
    for (const Surface& piece : pieces_of(cut)) area += piece.area();
    CHECK(area == Approx(whole.area()).epsilon(1e-12));
    const SurfaceTree tree(whole);
    for (const auto& position : cut.positions().colwise())
        CHECK(tree.nearest(position).distance < 1e-12 * whole.positions().norm());
}

}  // namespace

TEST_CASE("A path in a plane is the straight line between its ends, whatever the triangles") {
    const Surface surface(samples::plane(11, 1));
    const unsigned seed = GENERATE(1u, 2u, 3u);
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int k = 0; k < 100; ++k) {
        const SurfacePoint a = snapped(samples::random_place(surface, random)),
                           b = snapped(samples::random_place(surface, random));
        const SurfacePath path = shortest_path(surface, a, b);
        REQUIRE(path.points.size() == path.faces.size() + 1);
        CHECK(path.length == Approx((surface.position_at(a) - surface.position_at(b)).norm()).margin(1e-12));
        CHECK(samples::length_of(cut_path(surface, {a, b})) == Approx(path.length).epsilon(1e-3).margin(1e-12));
    }
}

TEST_CASE("A path is no longer than any along edges, whatever the triangles") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> around_some(3, 7), along_some(2, 6);
    std::uniform_real_distribution<double> slant_some(-3, 3), height_some(0.05, 3);
    for (int trial = 0; trial < 50; ++trial) {
        const int around = around_some(random), along = along_some(random);
        const double slant = slant_some(random), height = height_some(random);
        CAPTURE(around, along, slant, height);
        const Surface tube(samples::slanted_tube(around, along, slant, height));
        const Eigen::MatrixXd edge_ways = ways_along_edges(tube);
        for (int v = 0; v < tube.vertex_count(); ++v)
            for (int w = 0; w < tube.vertex_count(); ++w) {
                const SurfacePath path =
                    shortest_path(tube, Surface::start_of(tube.first_side(v)), Surface::start_of(tube.first_side(w)));
                CAPTURE(v, w);
                CHECK(path.length <= edge_ways(v, w) * (1 + 1e-12));
                CHECK(path.length >= (tube.positions().col(v) - tube.positions().col(w)).norm() * (1 - 1e-12));
            }
    }
}

TEST_CASE("A path on a sphere is nearly an arc of a great circle, and goes round what is in its way") {
    const Surface sphere(samples::sphere(24));
    const CutLine arc = line_at(sphere, {{1, 0.1, 0.2}, {-0.5, 0.9, -0.2}});
    const double angle =
        std::acos(sphere.position_at(arc[0]).normalized().dot(sphere.position_at(arc[1]).normalized()));
    CHECK(samples::length_of(cut_path(sphere, arc)) == Approx(angle).epsilon(5e-3));

    // A cylinder whose shorter way is across the seam between first and last column.
    const Surface cylinder(samples::cylinder(60, 21, 2));
    const CutLine across = line_at(cylinder, {{std::cos(0.4), -std::sin(0.4), -1}, {std::cos(0.5), std::sin(0.5), 1}});
    CHECK(samples::length_of(cut_path(cylinder, across)) == Approx(std::hypot(0.9, 2)).epsilon(3e-3));
}

TEST_CASE("A cut changes borders and pieces as theory says, and no area") {
    const Surface disc(samples::plane(9, 1));
    const Surface annulus(samples::cylinder(24, 9, 1));
    const Surface sphere(samples::sphere(6));
    const Surface torus(samples::torus(24, 12, 2, 0.7));
    const auto ring = [](double x, double r, int n) {
        std::vector<Eigen::Vector3d> points;
        for (int k = 0; k <= n; ++k) {
            const double u = 2 * std::numbers::pi * (k % n) / n + 0.1;
            points.emplace_back(x + r * std::cos(u), r * std::sin(u), 0);
        }
        return points;
    };
    std::vector<Eigen::Vector3d> along_torus = ring(0, 2.7, 8), around_torus;
    for (int k = 0; k <= 6; ++k) {
        const double v = 2 * std::numbers::pi * (k % 6) / 6 + 0.13;
        around_torus.emplace_back((2 + 0.7 * std::cos(v)) * std::cos(0.2), (2 + 0.7 * std::cos(v)) * std::sin(0.2),
                                  0.7 * std::sin(v));
    }
    struct Case {
        const char* name;
        const Surface& surface;
        std::vector<std::vector<Eigen::Vector3d>> cuts;
        Form expected;
    };
    const std::vector<Case> cases = {
        {"disc, slit", disc, {{{-0.4, 0.03, 0}, {0.1, 0.21, 0}, {0.5, -0.3, 0}}}, {1, 2, 0}},
        {"disc, slit within one triangle", disc, {{{0.03, 0.05, 0}, {0.08, 0.06, 0}}}, {1, 2, 0}},
        {"disc, slit along one edge", disc, {{{0, 0, 0}, {0.25, 0, 0}}}, {1, 2, 0}},
        {"disc, slit along edges and through vertices", disc, {{{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.5, 0}}}, {1, 2, 0}},
        {"disc, from the border", disc, {{{-1, 0.1, 0}, {0.33, 0.2, 0}}}, {1, 1, 1}},
        {"disc, from border to border", disc, {{{-1, 0.1, 0}, {1, 0.3, 0}}}, {2, 2, 2}},
        {"disc, along its border", disc, {{{-1, -1, 0}, {1, -1, 0}}}, {1, 1, 1}},
        {"disc, corner to corner", disc, {{{-1, -1, 0}, {1, 1, 0}}}, {2, 2, 2}},
        {"disc, closed", disc, {ring(0.1, 0.5, 7)}, {2, 3, 1}},
        {"disc, a cross", disc, {{{-1, 0.1, 0}, {1, 0.3, 0}}, {{0.1, -1, 0}, {0.12, 1, 0}}}, {4, 4, 4}},
        {"disc, a T", disc, {{{-1, 0.1, 0}, {1, 0.1, 0}}, {{0.1, 0.1, 0}, {0.2, 1, 0}}}, {3, 3, 3}},
        {"disc, the same twice", disc, {{{-1, 0.1, 0}, {1, 0.3, 0}}, {{-1, 0.1, 0}, {1, 0.3, 0}}}, {2, 2, 2}},
        {"annulus, from border to border", annulus, {{{1, 0, -1}, {std::cos(0.5), std::sin(0.5), 1}}}, {1, 1, 1}},
        {"annulus, around", annulus, {ring(0, 1, 8)}, {2, 4, 0}},
        {"sphere, slit", sphere, {{{1, 0, 0.2}, {0, 1, 0.3}}}, {1, 1, 1}},
        {"sphere, closed", sphere, {ring(0, 1, 8)}, {2, 2, 2}},
        {"torus, slit", torus, {{{2.7, 0.2, 0.1}, {2, 1.9, 0.1}}}, {1, 1, -1}},
        {"torus, along", torus, {along_torus}, {1, 2, 0}},
        {"torus, along and around", torus, {along_torus, around_torus}, {1, 1, 1}},
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const Surface opened = cut(c.surface, c.cuts);
        CHECK(form_of(opened) == c.expected);
        check_same_shape(opened, c.surface);
    }
}

TEST_CASE("Random cuts keep the area and leave a surface whose form follows from how they run") {
    const unsigned seed = GENERATE(range(1u, 41u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Surface surfaces[] = {Surface(samples::sphere(8)), Surface(samples::torus(24, 12, 2, 0.7)),
                                Surface(samples::graph(15, 1, [](double x, double y) { return x * y; }))};
    for (const Surface& surface : surfaces) {
        const Form before = form_of(surface);
        CutLine line;
        for (unsigned k = 0; k < 2 + seed % 3; ++k) line.push_back(samples::random_place(surface, random));
        try {
            const Surface opened = cut_open(surface, {{line}});
            check_same_shape(opened, surface);
            // A slit, unless it touches the border of the last, which a locally shortest path inside a saddle does not.
            CHECK(form_of(opened) == Form{1, before.loops + 1, before.euler - 1});
        } catch (const Error& error) {
            CHECK_THAT(error.what(), Contains("crosses or touches itself"));
        }
    }
}

TEST_CASE("Two random lines cut a square into the pieces that they do in the plane") {
    const unsigned seed = GENERATE(range(1u, 41u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-0.95, 0.95);
    const Surface square(samples::plane(12, 1));
    double left[2], right[2];
    for (int k = 0; k < 2; ++k) left[k] = coordinate(random), right[k] = coordinate(random);
    const bool cross = (left[0] < left[1]) != (right[0] < right[1]);
    const Surface opened = cut(square, {{{-1, left[0], 0}, {1, right[0], 0}}, {{-1, left[1], 0}, {1, right[1], 0}}});
    CHECK(pieces_of(opened).size() == (cross ? 4 : 3));
    check_same_shape(opened, square);
}

TEST_CASE("A cut that cannot be made is refused, with the reason and the place") {
    const Surface square(samples::plane(9, 1));
    const auto refused = [](const Surface& surface, const std::vector<std::vector<Eigen::Vector3d>>& lines,
                            const std::string& why) { CHECK_THROWS_WITH(cut(surface, lines), Contains(why)); };
    refused(square, {{{0, 0, 0}}}, "cut 1 needs at least two points");
    refused(square, {{{0, 0, 0}, {0.5, 0, 1}}}, "point 2 of a cut is 1.0");
    refused(square, {{{0, 0, 0}, {0.5, std::nan(""), 1}}}, "point 2 of a cut has a coordinate that is not finite");
    refused(square, {{{0.1, 0.1, 0}, {0.1, 0.1, 0}}}, "cut 1 has no length");
    refused(square, {{{-1, 0, 0}, {1, 0, 0}}, {{-0.5, 0.1, 0}, {0.5, 0.1, 0}, {0.3, -0.4, 0}, {0.2, 0.6, 0}}},
            "cut 2 crosses or touches itself");
    refused(square, {{{-0.5, 0, 0}, {0.5, 0, 0}, {-0.2, 0, 0}}}, "cut 1 crosses or touches itself");
    CHECK_THROWS_WITH(cut_open(square, {{CutLine{{0, {1, 0, 0}}, {square.face_count(), {1, 0, 0}}}}}),
                      Contains("point 2 of cut 1 is not on the surface"));
    const Surface halves = cut(square, {{{-1, 0.1, 0}, {1, 0.3, 0}}});
    refused(halves, {{{0, -0.5, 0}, {0, 0.5, 0}, {0, 0.6, 0}}}, "points 1 and 2 of cut 1 are on different pieces");
}

TEST_CASE("An end of a cut goes to the border of its own piece only, however near another lies") {
    Mesh mesh = samples::plane(4, 1);
    // A sheet a little above the end of the cut, far from the border of the large one.
    const auto first = static_cast<int>(mesh.positions.cols());
    mesh.positions.conservativeResize(3, first + 3);
    mesh.positions.rightCols(3) << 0.3, 0.32, 0.3,  //
        0, 0, 0.02,                                 //
        0.01, 0.01, 0.01;
    mesh.faces.add({first, first + 1, first + 2});
    const Surface surface(mesh);
    const CutLine line = line_at(surface, {{-0.3, 0, 0}, {0.3, 0, 0}});
    CHECK(surface.components()[line[1].face] == surface.components()[line[0].face]);
    CHECK(form_of(cut_open(surface, {{line}})).pieces == 2);
}
