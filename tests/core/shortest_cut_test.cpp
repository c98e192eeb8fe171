#include "surface/shortest_cut.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "sample_surfaces.h"
#include "surface/geodesics.h"
#include "surface/surface_path.h"
#include "surface/surface_tree.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

SurfacePoint at(const Surface& surface, const Eigen::Vector3d& point) { return SurfaceTree(surface).nearest(point).at; }

double length_of(const Surface& surface, const CutLine& cut) {
    double length = 0;
    for (std::size_t k = 1; k < cut.size(); ++k) length += shortest_path(surface, cut[k - 1], cut[k]).length;
    return length;
}

int euler_characteristic(const Surface& surface) {
    int edges = 0;
    for (int s = 0; s < 3 * surface.face_count(); ++s) edges += surface.opposite(s) < s ? 1 : 0;
    return surface.vertex_count() - edges + surface.face_count();
}

/// A square of 1 × 1 with two square holes.
Surface plate_with_holes() {
    const Mesh all =
        samples::quads(13, 13, false, false, [](int i, int j) { return Eigen::Vector3d(i / 12., j / 12., 0); });
    Mesh mesh{all.positions, {}};
    for (int f = 0; f < all.faces.size(); ++f) {
        const int i = f % 12, j = f / 12;
        const bool is_hole = (i / 2 == 2 && j / 2 == 1) || (i / 2 == 4 && j / 2 == 3);
        if (!is_hole) mesh.faces.add(all.faces[f]);
    }
    return Surface(repair(mesh, {Defect::unused_vertices}).mesh);
}

}  // namespace

TEST_CASE("From a point of a square the shortest cut goes straight to the side that is nearest") {
    // Two triangles alone, and many: where a side is met does not depend on where its vertices are.
    std::mt19937 random(11);
    for (const int n : {2, 17}) {
        const Surface square(samples::plane(n, 1));
        for (int trial = 0; trial < 20; ++trial) {
            Eigen::Vector3d point = samples::random_point(0.9, random);
            point.z() = 0;
            const CutLine cut = shortest_cut_to_border(square, at(square, point));
            const double way = 1 - point.head<2>().lpNorm<Eigen::Infinity>();
            CAPTURE(n, point.transpose());
            CHECK((square.position_at(cut[0]) - point).norm() < 1e-9);
            CHECK(square.position_at(cut[1]).head<2>().lpNorm<Eigen::Infinity>() == Approx(1));
            CHECK(length_of(square, cut) == Approx(way).epsilon(0.01));
        }
    }
}

TEST_CASE("A tube cut between its borders along the shortest way is a piece with one border") {
    const Surface tube(samples::cylinder(40, 9, 1.5));
    const CutLine cut = shortest_cut_between_borders(tube);
    CHECK(length_of(tube, cut) == Approx(3));
    REQUIRE(cut.size() == 4);
    CHECK(tube.position_at(cut[0]).z() * tube.position_at(cut[3]).z() == Approx(-1.5 * 1.5));
    CHECK(std::abs(tube.position_at(cut[1]).z()) == Approx(0.5));
    const Surface open = cut_open(tube, {{cut}});
    CHECK(open.boundary_loops().size() == 1);
    CHECK(euler_characteristic(open) == 1);
}

TEST_CASE("The two borders of a tube are found whatever its triangles are") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> around_some(3, 60), along_some(2, 8);
    std::uniform_real_distribution<double> slant_some(-3, 3), height_some(0.05, 3);
    for (int trial = 0; trial < 100; ++trial) {
        const int around = around_some(random), along = along_some(random);
        const double slant = slant_some(random), height = height_some(random);
        CAPTURE(around, along, slant, height);
        const Surface tube(samples::slanted_tube(around, along, slant, height));
        const CutLine cut = shortest_cut_between_borders(tube);
        const double slanted = 2 * std::sin(std::numbers::pi * slant / around), up = height / (along - 1);
        CHECK(length_of(tube, cut) >= height * (1 - 1e-9));
        // Each end is aside by a thousandth of a side, as points are snapped, and half a thousandth, as sections end.
        const double aside = 2 * 1.5e-3 * 2 * std::sin(std::numbers::pi / around);
        CHECK(length_of(tube, cut) <= std::hypot((along - 1) * std::hypot(slanted, up), aside) * (1 + 1e-9));
        const Surface open = cut_open(tube, {{cut}});
        CHECK(open.boundary_loops().size() == 1);
        CHECK(euler_characteristic(open) == 1);
    }
}

TEST_CASE("A cut between borders is the way that was measured, where the way back is longer") {
    // Three corners around, turned from row to row: paths found from one end and from the other differ.
    const double height = 2.6759365753;
    const Surface tube(samples::slanted_tube(3, 8, 0.4297290611, height));
    const double length = length_of(tube, shortest_cut_between_borders(tube));
    CHECK(length >= height);
    CHECK(length < 4.35);  // 6.77 along the other path
}

TEST_CASE("Cuts between borders, one after the other, begin with those that are nearest, and join all") {
    const Surface plate = plate_with_holes();
    std::vector<CutLine> cuts;
    Surface open = plate;
    for (const double way : {2. / 12, 2. / 12 * std::sqrt(2.)}) {
        const CutLine cut = shortest_cut_between_borders(open);
        CHECK(length_of(open, cut) <= way + 1e-9);
        cuts.push_back(cut_line(plate, SurfaceTree(plate), points_of(open, cut)));
        open = cut_open(plate, cuts);
    }
    CHECK(open.boundary_loops().size() == 1);
    CHECK(euler_characteristic(open) == 1);
    CHECK(open.area() == Approx(plate.area()));
    CHECK_THROWS_WITH(shortest_cut_between_borders(open), Contains("no two borders"));
}

TEST_CASE("A torus cut around once is a disc after the shortest cut between the two sides of that cut") {
    // Even, and so that the ends of the second cut are in two places; both go all around.
    for (const double uneven : {0., 0.4}) {
        CAPTURE(uneven);
        const Surface torus(samples::quads(48, 24, true, true, [&](int i, int j) {
            const double u = 2 * std::numbers::pi * i / 48, v = 2 * std::numbers::pi * j / 24;
            const double small = 1 + uneven * std::sin(u + v),
                         large = 3 + uneven * std::cos(u + 1) + small * std::cos(v);
            return Eigen::Vector3d(large * std::cos(u), large * std::sin(u),
                                   small * std::sin(v) + uneven * std::sin(u));
        }));
        const SurfaceTree tree(torus);
        Positions around(3, 5);
        for (int k = 0; k < 5; ++k) around.col(k) = torus.positions().col(k % 4 * 6 * 48);
        std::vector<CutLine> cuts{cut_line(torus, tree, around)};
        const Surface open = cut_open(torus, cuts);
        REQUIRE(open.boundary_loops().size() == 2);
        cuts.push_back(cut_line(torus, tree, points_of(open, shortest_cut_between_borders(open))));
        CHECK(length_of(torus, cuts[1]) > 8);
        const Surface disc = cut_open(torus, cuts);
        CHECK(disc.boundary_loops().size() == 1);
        CHECK(euler_characteristic(disc) == 1);
    }
}

TEST_CASE("Of many holes the two are joined that are nearest to each other") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int trial = 0; trial < 5; ++trial) {
        // Single triangles left out here and there, none at the corner of another, nor in the plate's corners, where a
        // march over the surface takes an edge between two sides of the border for border.
        const Surface plate(samples::plane(25, 1));
        std::vector<bool> is_taken;
        for (const auto& p : plate.positions().colwise()) is_taken.push_back(p.cwiseAbs().maxCoeff() > 0.85);
        Mesh mesh{plate.positions(), {}};
        for (double& height : mesh.positions.row(2)) height = 0.02 * samples::random_point(1, random).z();  // rough
        for (int f = 0; f < plate.face_count(); ++f) {
            const Eigen::Vector3i corners = plate.triangles().col(f);
            const bool is_free = !is_taken[corners[0]] && !is_taken[corners[1]] && !is_taken[corners[2]];
            if (random() % 10 == 0 && is_free)
                for (const int v : corners) is_taken[v] = true;
            else
                mesh.faces.add({corners[0], corners[1], corners[2]});
        }
        const Surface holed(repair(mesh, {Defect::unused_vertices}).mesh);
        const std::vector<std::vector<int>> loops = holed.boundary_loops();
        REQUIRE(loops.size() > 20);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < loops.size(); ++i) {
            std::vector<SurfacePoint> sources;
            for (const int side : loops[i]) sources.push_back(Surface::start_of(side));
            const std::vector<double> distances = geodesic_distances(holed, sources);
            for (std::size_t j = i + 1; j < loops.size(); ++j)
                for (const int side : loops[j]) least = std::min(least, distances[holed.from(side)]);
        }
        // Of many that are nearly alike not all are measured.
        const double side = 2. / 24;
        CHECK(length_of(holed, shortest_cut_between_borders(holed)) < least + side / 3);
    }
}

TEST_CASE("A slit is border for the cut that comes after it") {
    const Surface sphere(samples::sphere(12));
    CHECK_THROWS_WITH(shortest_cut_to_border(sphere, at(sphere, {0, 0, 1})), Contains("no border"));
    CHECK_THROWS_WITH(shortest_cut_between_borders(sphere), Contains("no two borders"));
    const Surface open = cut_open(sphere, {{CutLine{at(sphere, {1, 0, 0}), at(sphere, {0, 1, 0})}}});
    const CutLine cut = shortest_cut_to_border(open, at(open, {0.1, 0.1, 1}));
    CHECK(std::abs(open.position_at(cut[1]).z()) < 0.05);
    CHECK_THROWS_WITH(shortest_cut_to_border(open, cut[1]), Contains("cannot begin on it"));
}
