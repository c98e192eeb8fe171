#include "drape/drape_pieces.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <span>
#include <utility>

#include "base/error.h"
#include "drape/cut_proposals.h"
#include "drape/proposals.h"
#include "drape/slits.h"
#include "net/measures.h"
#include "net/topology.h"
#include "sample_surfaces.h"
#include "surface/gallery.h"
#include "surface/surface_cut.h"
#include "surface/surface_parts.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

using Border = DrapeOptions::Border;

Positions points(const std::vector<Eigen::Vector3d>& list) {
    Positions positions(3, std::ssize(list));
    for (std::size_t k = 0; k < list.size(); ++k) positions.col(static_cast<Eigen::Index>(k)) = list[k];
    return positions;
}

Surface cut_along(const Surface& surface, const std::vector<Eigen::Vector3d>& line) {
    return cut_open(surface, {{cut_line(surface, SurfaceTree(surface), points(line))}});
}

PiecesOptions wish(double length, Border border) {
    PiecesOptions options;
    options.drape.length = length;
    options.drape.border = border;
    return options;
}

double angle_limit_kept(const DrapedPieces& pieces) { return pieces.report.smallest_angle; }

/// Whether the segments a-b and c-d of the plane cross.
bool do_cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
    const auto side = [](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r) {
        return (q - p).cross(r - p).z();
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Ends no farther than `least` from the line are on it.
int edges_across(const Net& net, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double least = 1e-6) {
    const Eigen::Vector3d along = (to - from).normalized();
    const auto distance = [&](const Eigen::Vector3d& point) { return std::abs(along.cross(point - from).z()); };
    int count = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const Eigen::Vector3d a = net.rest_positions().col(net.edges()(0, e)),
                              b = net.rest_positions().col(net.edges()(1, e));
        count += do_cross(a, b, from, to) && std::min(distance(a), distance(b)) > least;
    }
    return count;
}

/// Pairs of edges that cross within the plane.
int crossing_edges(const Net& net) {
    const auto at = [&](int end, int e) { return Eigen::Vector3d(net.rest_positions().col(net.edges()(end, e))); };
    int count = 0;
    for (int e = 0; e < net.edge_count(); ++e)
        for (int f = 0; f < e; ++f) count += do_cross(at(0, e), at(1, e), at(0, f), at(1, f));
    return count;
}

}  // namespace

TEST_CASE("A surface cut in two takes two nets, which lie in one and share nothing") {
    const Surface saddle(samples::graph(21, 1, [](double x, double y) { return 0.3 * x * y; }));
    const Surface halves = cut_along(saddle, {{-1, 0.21, 0}, {0.2, -0.13, 0}, {1, 0.33, 0}});
    for (const Border border : {Border::inside, Border::beyond, Border::cut}) {
        const DrapedPieces made = drape_pieces(halves, wish(0.07, border));
        REQUIRE(made.draped.size() == 2);
        CHECK(made.bare.empty());
        CHECK(Topology(made.net).component_count() == 2);
        CHECK(made.net.vertex_count() ==
              made.draped[0].drape.net.vertex_count() + made.draped[1].drape.net.vertex_count());
        CHECK(made.report.max_deviation < 1e-12);
        CHECK(angle_limit_kept(made) >= std::numbers::pi / 6);
        CHECK(made.report.length == Approx(0.07));
        CHECK(made.report.coverage > (border == Border::inside ? 0.85 : 0.99));
        CHECK(made.draped[0].area + made.draped[1].area == Approx(saddle.area()));
        for (const DrapedPiece& piece : made.draped)
            CHECK(piece.report.coverage > (border == Border::inside ? 0.8 : 0.99));
    }
}

TEST_CASE("Rods cut at a seam end on it, from either side") {
    const Surface square(samples::plane(15, 1));
    const Surface halves = cut_along(square, {{-1, 0.03, 0}, {1, 0.03, 0}});
    const DrapedPieces made = drape_pieces(halves, wish(0.11, Border::cut));
    for (const DrapedPiece& piece : made.draped) {
        const Positions& x = piece.drape.net.rest_positions();
        const bool is_upper = x.row(1).mean() > 0.03;
        CHECK((is_upper ? x.row(1).minCoeff() : x.row(1).maxCoeff()) == Approx(0.03).margin(1e-9 + 0.05 * 0.11));
        CHECK(piece.drape.cut_ends > 10);
    }
    CHECK(made.report.coverage == Approx(1));

    REQUIRE(made.draped.size() == 2);
    const Drape &one = made.draped[0].drape, &other = made.draped[1].drape;
    CHECK(made.cut_ends == one.cut_ends + other.cut_ends);
    CHECK(made.locked == one.locked + other.locked);
    REQUIRE(made.places.cols() == made.net.vertex_count());
    CHECK(made.places.leftCols(one.places.cols()) == one.places);
    CHECK(made.places.rightCols(other.places.cols()) == other.places);
}

TEST_CASE("No net lies on another along a cut, nor on itself along a slit") {
    const Surface square(samples::plane(15, 1));
    const Surface halves = cut_along(square, {{-1, 0.03, 0}, {0.1, -0.2, 0}, {1, 0.23, 0}});
    const Surface slit = cut_along(square, {{-1, 0.031, 0}, {0.417, 0.052, 0}});
    for (const Surface* surface : {&halves, &slit})
        for (const Border border : {Border::inside, Border::beyond}) {
            CAPTURE(border, surface == &slit);
            const DrapedPieces made = drape_pieces(*surface, wish(0.11, border));
            CHECK(crossing_edges(made.net) == 0);
            CHECK(made.report.coverage > (border == Border::inside ? 0.85 : 0.95));
        }
}

TEST_CASE("Over its outer border a piece of a coarse surface goes as far as it does alone") {
    const Surface square(samples::plane(2, 1));
    const Surface halves = cut_along(square, {{-1, 0, 0}, {1, 0, 0}});
    PiecesOptions options = wish(0.17, Border::beyond);
    options.seeds = {{0.01, -0.52, 0}, {0.52, 0.52, 0}};
    const DrapedPieces made = drape_pieces(halves, options);
    for (const DrapedPiece& piece : made.draped) {
        const auto x = piece.drape.net.rest_positions().row(0), y = piece.drape.net.rest_positions().row(1);
        CHECK(x.minCoeff() < -1);
        CHECK(x.maxCoeff() > 1);
        CHECK(std::max(-y.minCoeff(), y.maxCoeff()) > 1);
        CHECK(std::min(-y.minCoeff(), y.maxCoeff()) < 1e-9);
    }
    CHECK(made.report.coverage > 0.99);

    // A side of the outer border may have both ends on cuts.
    const SurfaceTree tree(square);
    const std::vector<CutLine> cuts = {cut_line(square, tree, points({{-1, -0.4, 0}, {1, -0.4, 0}})),
                                       cut_line(square, tree, points({{-1, 0.4, 0}, {1, 0.4, 0}}))};
    const Surface thirds = cut_open(square, cuts);
    options.seeds = {{0.01, 0.02, 0}};
    const DrapedPieces middle = drape_pieces(thirds, options);
    const Positions& x = middle.net.rest_positions();
    CHECK(x.row(0).minCoeff() < -1);
    CHECK(x.row(0).maxCoeff() > 1);
    CHECK(x.row(1).cwiseAbs().maxCoeff() < 0.4 + 1e-9);
}

TEST_CASE("No edge goes across a slit in a plane, and around its end the net is one") {
    const Surface square(samples::plane(15, 1));
    const Eigen::Vector3d from(-1, 0.031, 0), to(0.417, 0.052, 0);
    const Surface slit = cut_along(square, {from, to});
    for (const Border border : {Border::inside, Border::cut}) {
        PiecesOptions options = wish(0.1, border);
        options.seeds = {{0.02, -0.5, 0}};
        const DrapedPieces made = drape_pieces(slit, options);
        REQUIRE(made.draped.size() == 1);
        CHECK(edges_across(made.net, from, to) == 0);
        CHECK(Topology(made.net).component_count() == 1);
        CHECK(made.report.coverage > (border == Border::cut ? 0.985 : 0.93));
        // Without the slit the same net goes across.
        DrapeOptions across = made.draped[0].options;
        across.slits = false;
        CHECK(edges_across(drape(slit, SurfaceTree(slit), across).net, from, to) > 10);
    }
}

TEST_CASE(
    "Beside a slit in a plane every cell of the lattice is laid that it does not cross, and none is called locked") {
    const Surface square(samples::plane(13, 1));
    struct Case {
        Eigen::Vector3d from, to, seed, direction;
        double angle;
    };
    const Case cases[] = {
        {{-0.546, -0.357, 0}, {0.602, 0.276, 0}, {0.461, -0.72, 0}, {-0.3986, -0.2283, 0}, std::numbers::pi / 2},
        {{-0.018, 0.625, 0}, {-0.382, -0.442, 0}, {0.852, -0.124, 0}, {-0.4287, 0.4622, 0}, 1.3},
        {{-0.274, 0.759, 0}, {-0.77, -0.036, 0}, {0.317, 0.908, 0}, {-0.0596, -0.1171, 0}, 1.3},
    };
    for (const auto& [from, to, seed, direction, angle] : cases) {
        CAPTURE(seed);
        PiecesOptions options = wish(0.22, Border::beyond);
        options.first_seed = true;
        options.drape.seed = seed;
        options.drape.direction = direction;
        options.drape.angle = angle;
        const Net lattice = drape_pieces(square, options).net;
        int uncrossed = 0;
        for (int f = 0; f < lattice.face_count(); ++f) {
            const std::span<const int> face = lattice.faces()[f];
            const auto corner = [&](std::size_t k) { return Eigen::Vector3d(lattice.rest_positions().col(face[k])); };
            bool is_crossed = false;
            for (std::size_t k = 0; k < 4; ++k)
                is_crossed = is_crossed || do_cross(corner(k), corner((k + 1) % 4), from, to);
            uncrossed += !is_crossed;
        }
        const DrapedPieces beside = drape_pieces(cut_along(square, {from, to}), options);
        CHECK(beside.net.face_count() == uncrossed);
        CHECK(beside.draped[0].drape.locked == 0);
        options.drape.border = Border::cut;
        CHECK(drape_pieces(cut_along(square, {from, to}), options).report.coverage > 0.999);
    }
}

TEST_CASE("No edge goes across where cuts cross at a small angle, nor across a piece smaller than a cell") {
    const Surface square(samples::graph(14, 1, [](double, double) { return 0; }));
    const SurfaceTree tree(square);
    const std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> lines = {{{-0.132, 0.733, 0}, {-0.08, -0.64, 0}},
                                                                            {{-0.628, 0.702, 0}, {0.66, -0.047, 0}},
                                                                            {{-0.344, 0.522, 0}, {0.563, 0.177, 0}}};
    std::vector<CutLine> cuts;
    for (const auto& [from, to] : lines) cuts.push_back(cut_line(square, tree, points({from, to})));
    const Surface opened = cut_open(square, cuts);
    REQUIRE(pieces_of(opened).size() == 2);
    for (const double length : {0.06, 0.1, 0.14}) {
        PiecesOptions options = wish(length, Border::cut);
        options.first_seed = true;
        options.drape.seed = {-0.83, -0.74, 0};
        options.drape.direction = {-0.17, 0.132, 0};
        const Net net = drape_pieces(opened, options).draped[0].drape.net;
        CAPTURE(length);
        // Stubs shorter than a twentieth of an edge are left out: there a vertex may stand a little beyond.
        for (const auto& [from, to] : lines) CHECK(edges_across(net, from, to, 0.051 * length) == 0);
    }
}

TEST_CASE("No rod goes across a slit that bends, nor is cut longer than it was") {
    const Surface square(samples::plane(21, 1));
    struct Case {
        double length;
        std::array<Eigen::Vector3d, 3> line;
        Eigen::Vector3d seed, direction;
    };
    const Case cases[] = {
        {0.07,
         {{{1, -0.6201705505953307, 0},
           {0.5654148462043186, 0.19027916643546517, 0},
           {0.07215940190856229, -0.3556176302994788, 0}}},
         {-0.7916257336525446, -0.3004423664709155, 0},
         {-0.221253746048361, 0.3699210172281613, 0}},
        {0.1, {{{-0.5, -0.6, 0}, {0.6, 0.05, 0}, {-0.6, 0.3, 0}}}, {-0.7, 0.8, 0}, {0.8, 0.3, 0}},
        {0.06, {{{-0.6, 0, 0}, {0, 0.1, 0}, {0.5, -0.6, 0}}}, {-0.7, -0.8, 0}, {0.5, 0.4, 0}},
    };
    for (const auto& [length, line, seed, direction] : cases) {
        CAPTURE(length);
        PiecesOptions options = wish(length, Border::cut);
        options.first_seed = true;
        options.drape.seed = seed;
        options.drape.direction = direction;
        const DrapedPieces made = drape_pieces(cut_along(square, {line.begin(), line.end()}), options);
        for (std::size_t k = 0; k < 2; ++k) CHECK(edges_across(made.net, line[k], line[k + 1], 0.051 * length) == 0);
        // Between the ends of two rods an edge may be the diagonal of a cell.
        CHECK(made.net.rest_lengths().maxCoeff() < 1.001 * std::numbers::sqrt2 * length);
        CHECK(made.report.coverage > 0.98);
    }
}

TEST_CASE("A net goes on beside bent slits and around their ends where it could not before it had come round") {
    const Surface square(samples::plane(21, 1));
    PiecesOptions options = wish(0.2, Border::cut);
    options.first_seed = true;
    options.drape.angle = std::numbers::pi / 3;
    options.drape.seed = {0.2092213481359767, -0.32239682354384713, 0};
    options.drape.direction = {-0.6478820001863277, -0.7460132115377993, 0};
    const Surface bent = cut_along(square, {{1, -0.3747115386575236, 0},
                                            {-0.13214533297694742, -0.04514574958711137, 0},
                                            {-0.4666988492102582, 0.33604231611236035, 0}});
    CHECK(drape_pieces(bent, options).report.coverage > 0.999);

    // Here two vertices at one place come to be beside a third: an edge of three faces would be none.
    options = wish(0.13, Border::cut);
    options.first_seed = true;
    options.drape.angle = 5 * std::numbers::pi / 12;
    options.drape.seed = {0.6649301597891516, -0.0700891672802586, 0};
    options.drape.direction = {0.4984969577210772, 0.8668914483041291, 0};
    const SurfaceTree tree(square);
    const Surface twice = cut_open(
        square,
        {{cut_line(square, tree, points({{1, 0.8239583566892384, 0}, {-0.0764312147323396, -0.48220276876734014, 0}})),
          cut_line(square, tree, points({{1, -0.2975156871729766, 0}, {0.6418748710772847, -0.515310082039947, 0}}))}});
    CHECK(drape_pieces(twice, options).report.coverage > 0.95);
}

TEST_CASE("A slit parts what is on its two sides, also on the slit itself and beyond the border") {
    const Surface slit = cut_along(Surface(samples::plane(21, 1)), {{0.8, -0.5, 0}, {0.8, 0.21, 0}});
    const SurfaceTree tree(slit);
    const Slits slits(slit, tree, 0.5);
    const auto at = [&](double x, double y) {
        const Eigen::Vector3d position(x, y, 0);
        const SurfaceTree::Nearest near = tree.nearest(position);
        return DrapedVertex{position, near.at, Eigen::Vector3d::UnitZ(), near.distance};
    };
    // As seen from the point of the border below it.
    CHECK(slits.part(at(1.1, 0.4), at(0.6, 0)));
    CHECK_FALSE(slits.part(at(1.1, 0.6), at(0.6, 0.2)));

    DrapedVertex on_left = at(0.8 - 1e-3, 0.2);
    on_left.position.x() = 0.8;
    const SurfaceTree::Nearest near = tree.nearest_in(on_left.at.face, on_left.position);
    REQUIRE(near.distance < 1e-12);
    on_left.at = near.at;
    for (int k = 0; k < 50; ++k) {
        const double y = 0.207 - 0.011 * k, across = 0.03 + 0.002 * k;
        CAPTURE(y);
        CHECK(slits.part(at(0.8 + across, y), on_left));
        CHECK(slits.part(on_left, at(0.8 + across, y)));
        CHECK_FALSE(slits.part(at(0.8 - across, y), on_left));
    }
}

TEST_CASE("A slit relieves curvature: a cone's tip takes a net that does not go round it") {
    // A right cone of slope 1 misses 2π (1 − 1/√2) of angle at its tip; slit from there to its border it unrolls.
    const int around = 72;
    const Surface cone(samples::quads(around, 25, true, false, [](int i, int j) {
        const double u = 2 * std::numbers::pi * i / around, r = 0.02 + 0.98 * j / 24;
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), -1.2 * r);
    }));
    const Surface slit = cut_along(
        cone, {{0.02 * std::cos(0.03), 0.02 * std::sin(0.03), -0.024}, {std::cos(0.03), std::sin(0.03), -1.2}});
    PiecesOptions options = wish(0.05, Border::inside);
    options.seeds = {{-0.5, 0.01, -0.6}};
    const DrapedPieces whole = drape_pieces(cone, options), opened = drape_pieces(slit, options);
    CAPTURE(whole.report.coverage, opened.report.coverage);
    CHECK(opened.report.much_sheared == 0);
    CHECK(whole.report.smallest_angle < 60 * std::numbers::pi / 180);
    CHECK(opened.report.coverage > 0.93);
    CHECK(opened.report.smallest_angle > 80 * std::numbers::pi / 180);
}

TEST_CASE("Seeds choose pieces, and pieces without a net say why") {
    const Surface square(samples::plane(15, 1));
    const Surface halves = cut_along(square, {{-1, 0.03, 0}, {1, 0.03, 0}});
    PiecesOptions options = wish(0.1, Border::beyond);
    options.seeds = {{0, 0.5, 0}};
    const DrapedPieces upper = drape_pieces(halves, options);
    REQUIRE(upper.draped.size() == 1);
    REQUIRE(upper.bare.size() == 1);
    CHECK_THAT(upper.bare[0].reason, Contains("no seed is on it"));
    CHECK(upper.report.coverage == Approx(0.5).margin(0.05));
    options.seeds = {{0, 0.5, 0}, {0.3, 0.4, 0}};
    CHECK_THROWS_WITH(drape_pieces(halves, options), Contains("seed 2 is on a piece"));

    // One for where the first net begins leaves the others as they are.
    options.seeds.clear();
    options.first_seed = true;
    options.drape.seed = {0, 0.5, 0};
    options.best = true;
    const DrapedPieces both = drape_pieces(halves, options);
    REQUIRE(both.draped.size() == 2);
    CHECK(both.bare.empty());
    CHECK(both.draped[0].options.seed == options.drape.seed);

    for (const double leave : {-1., std::nan("")}) {
        options.leave = leave;
        CHECK_THROWS_WITH(drape_pieces(halves, options), Contains("leave the surface by more than 0"));
    }

    const Surface sliver = cut_along(square, {{-1, 0.99, 0}, {1, 0.99, 0}});
    const DrapedPieces rest = drape_pieces(sliver, wish(0.1, Border::inside));
    CHECK(rest.draped.size() == 1);
    REQUIRE(rest.bare.size() == 1);
    CHECK_THAT(rest.bare[0].reason, Contains("no cell"));
}

TEST_CASE("Proposed cuts help by as much as is said, and where nothing is to be gained none is proposed", "[large]") {
    const Surface pebble = make_own_surface("pebble");
    const SurfaceTree tree(pebble);
    PiecesOptions options;
    options.first_seed = true;
    options.drape = suggested_drape(pebble, tree, 500);
    const CutProposals found = propose_cuts(pebble, options.drape, 2);
    REQUIRE(found.coverage.size() == found.cuts.size() + 1);
    REQUIRE_FALSE(found.cuts.empty());
    for (std::size_t k = 0; k < found.coverage.size(); ++k) {
        const std::vector<CutLine> cuts(found.cuts.begin(), found.cuts.begin() + static_cast<std::ptrdiff_t>(k));
        CHECK(drape_pieces(cut_open(pebble, cuts), options).report.coverage == found.coverage[k]);
        if (k > 0) CHECK(found.coverage[k] > found.coverage[k - 1] + k_least_gain);
    }
    const Surface torso = make_own_surface("torso");
    const SurfaceTree torso_tree(torso);
    options.drape = suggested_drape(torso, torso_tree, 150);
    const CutProposals near_border = propose_cuts(torso, options.drape, 2);
    REQUIRE_FALSE(near_border.cuts.empty());
    std::vector<CutLine> again;
    for (const CutLine& cut : near_border.cuts) again.push_back(cut_line(torso, torso_tree, points_of(torso, cut)));
    CHECK(drape_pieces(cut_open(torso, again), options).report.coverage ==
          Approx(near_border.coverage.back()).epsilon(1e-9));

    const Surface square(samples::plane(15, 1));
    const CutProposals none = propose_cuts(square, suggested_drape(square, SurfaceTree(square), 200), 3);
    CHECK(none.cuts.empty());
    CHECK(none.coverage[0] > 0.99);
}

TEST_CASE("Slits anywhere on a body, curved or not, leave an exact net within its limit in every way to end at them",
          "[large]") {
    const unsigned seed = GENERATE(range(1u, 7u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Surface surfaces[] = {make_own_surface("pebble"), Surface(samples::torus(36, 18, 2, 0.7)),
                                make_own_surface("shell")};
    for (const Surface& surface : surfaces) {
        std::vector<CutLine> cuts;
        for (int k = 0; k < 2; ++k)
            cuts.push_back({samples::random_place(surface, random), samples::random_place(surface, random)});
        PiecesOptions options;
        options.drape = suggested_drape(surface, SurfaceTree(surface), 250);
        for (const Border border : {Border::inside, Border::beyond, Border::cut})
            for (const double leave : {0., 0.5}) {
                if (leave > 0 && seed > 1) continue;  // takes long
                CAPTURE(border, leave);
                options.drape.border = border;
                options.leave = leave;
                const DrapedPieces made = drape_pieces(cut_open(surface, cuts), options);
                CHECK(made.report.max_deviation < (leave > 0 ? 1e-9 : 1e-12));
                CHECK(made.report.smallest_angle > 29.9 * std::numbers::pi / 180);
                CHECK(made.report.coverage > 0.3);
            }
    }
}

TEST_CASE("A net that leaves the surface where it would lock goes across no slit, also where rods are cut") {
    const Surface pebble = make_own_surface("pebble");
    const std::vector<Eigen::Vector3d> line = {{-1.5, 0, 1.717}, {0, 0, 2}, {1.5, 0, 2.097}};
    const Surface slit = cut_along(pebble, line);
    for (const Border border : {Border::cut, Border::beyond}) {
        PiecesOptions options = wish(std::sqrt(pebble.area() / 250), border);
        options.leave = 1;
        const DrapedPieces made = drape_pieces(slit, options);
        // As seen from above, but for what lies below.
        const Positions& x = made.net.rest_positions();
        int across = 0;
        for (int e = 0; e < made.net.edge_count(); ++e) {
            const Eigen::Vector3d a = x.col(made.net.edges()(0, e)), b = x.col(made.net.edges()(1, e));
            const bool is_above = a.z() > 1 && b.z() > 1;
            const double part = a.y() / (a.y() - b.y());
            const double x_there = (1 - part) * a.x() + part * b.x();
            const double least = 1e-3 * options.drape.length;
            across += is_above && std::min(a.y(), b.y()) < -least && std::max(a.y(), b.y()) > least &&
                      std::abs(x_there) < 1.3;
        }
        CHECK(across == 0);
    }
}

TEST_CASE("Trials keep to slits, and with a seed they look for the best direction there") {
    const Surface pebble = make_own_surface("pebble");
    const Surface slit = cut_along(pebble, {{-1.5, 0, 1.717}, {0, 0, 2}, {1.5, 0, 2.097}});
    PiecesOptions options = wish(std::sqrt(pebble.area() / 250), Border::beyond);
    options.best = true;
    CHECK(drape_pieces(slit, options).draped[0].options.slits);

    const Eigen::Vector3d seed(0.4, 0.8, 1.9);
    options.seeds = {seed};
    const DrapedPiece piece = drape_pieces(slit, options).draped[0];
    CHECK(piece.options.seed == seed);
    const SurfaceTree tree(slit);
    DrapeOptions there = piece.options;
    there.direction = Eigen::Vector3d::UnitX();
    CHECK(with_best_direction(slit, tree, there).direction == piece.options.direction);
    CHECK_THROWS_WITH(with_best_direction(slit, tree, DrapeOptions{.length = -1}), Contains("edge length"));
}
