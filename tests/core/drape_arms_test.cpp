#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "constants.h"
#include "drape/bridged_drape.h"
#include "drape/drape.h"
#include "drape/drape_pieces.h"
#include "mesh_files.h"
#include "net/measures.h"
#include "sample_surfaces.h"
#include "surface/gallery.h"
#include "surface/guide.h"
#include "surface/surface_cut.h"

using namespace chebnet;
using Catch::Matchers::Contains;
using Arms = DrapeOptions::Arms;

namespace {

/// How far the corners of a net's quads are from right angles, radians.
struct Shear {
    double mean = 0, largest = 0;
};
Shear shear_of(const Net& net) {
    Shear shear;
    const Positions& x = net.rest_positions();
    for (int f = 0; f < net.face_count(); ++f)
        for (int k = 0; k < 4; ++k) {
            const auto at = [&](int corner) { return x.col(net.faces()[f][static_cast<std::size_t>(corner % 4)]); };
            const Eigen::Vector3d a = at(k + 1) - at(k), b = at(k + 3) - at(k);
            const double off = std::abs(std::atan2(a.cross(b).norm(), a.dot(b)) - samples::k_pi / 2);
            shear.mean += off / (4 * net.face_count());
            shear.largest = std::max(shear.largest, off);
        }
    return shear;
}

struct Compared {
    Drape straight, bent;
    double straight_coverage, bent_coverage;
};
Compared compared(const Surface& surface, DrapeOptions options) {
    const SurfaceTree tree(surface);
    Drape straight = drape(surface, tree, options);
    options.arms = Arms::least_shear;
    Drape bent = drape(surface, tree, options);
    const double before = measure_drape(surface, tree, straight.net).coverage;
    const double now = measure_drape(surface, tree, bent.net).coverage;
    return {std::move(straight), std::move(bent), before, now};
}

DrapeOptions beginning(const Surface& surface, int cells, const std::optional<Eigen::Vector3d>& seed = {}) {
    DrapeOptions options = suggested_drape(surface, SurfaceTree(surface), cells);
    if (seed) options.seed = *seed;
    return options;
}

/// Between vertices at the same places.
double largest_distance(const Drape& a, const Drape& b) {
    std::map<std::pair<int, int>, Eigen::Vector3d> at;
    for (int v = 0; v < a.net.vertex_count(); ++v) at[{a.places(0, v), a.places(1, v)}] = a.net.rest_positions().col(v);
    if (a.net.vertex_count() != b.net.vertex_count()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (int v = 0; v < b.net.vertex_count(); ++v)
        largest = std::max(largest, (at.at({b.places(0, v), b.places(1, v)}) - b.net.rest_positions().col(v)).norm());
    return largest;
}

/// Of the vertices of one family's arms, the largest value.
template <class Value>
double largest_on_arms(const Drape& drape, bool first, Value value) {
    double largest = 0;
    for (int v = 0; v < drape.net.vertex_count(); ++v)
        if (drape.places(first ? 1 : 0, v) == 0) largest = std::max(largest, value(drape.net.rest_positions().col(v)));
    return largest;
}

}  // namespace

TEST_CASE("On a plane all arms agree: geodesic, of least shear, along a straight line") {
    const Surface plane(samples::plane(7, 1));
    const SurfaceTree tree(plane);
    DrapeOptions options;
    options.length = 0.1;
    options.seed = {0.013, -0.027, 0};
    options.direction = {3, 1, 0};
    const Drape straight = drape(plane, tree, options);
    options.arms = Arms::least_shear;
    const Drape least = drape(plane, tree, options);
    CHECK(least.arms == Arms::geodesic);  // which cannot be bettered
    CHECK(largest_distance(least, straight) == 0);
    options.arms = Arms::curve;
    options.along.resize(3, 2);
    options.along.col(0) = options.seed - 0.6 * options.direction / 3;
    options.along.col(1) = options.seed + 0.6 * options.direction / 3;
    options.direction = {0, 1, 0};
    const Drape along = drape(plane, tree, options);
    CHECK(along.arms == Arms::curve);
    CHECK(largest_distance(along, straight) < 1e-9);
}

TEST_CASE("With an angle other than a right one, arms of least shear open a plane's net behind the seed") {
    const Surface plane(samples::plane(9, 1));
    DrapeOptions options;
    options.length = 0.05;
    options.angle = samples::k_pi / 3;
    const auto [straight, bent, before, now] = compared(plane, options);
    CHECK(bent.arms == Arms::least_shear);
    CHECK(shear_of(straight.net).mean == Approx(samples::k_pi / 6));
    CHECK(shear_of(bent.net).mean < samples::k_pi / 18);
    CHECK(max_deviation(bent.net, bent.net.rest_positions()) < samples::k_exact);
    CHECK(now > before - 0.003);
}

TEST_CASE("On a cylinder geodesic arms shear nothing, and an arm along a circle goes round it") {
    const Surface cylinder(samples::cylinder(200, 21, 1));
    const SurfaceTree tree(cylinder);
    DrapeOptions options;
    options.length = 0.1;
    options.seed = {1, 0, 0.02};
    options.direction = {0, 1, 1};
    options.arms = Arms::least_shear;
    options.reach = 8;
    const Drape least = drape(cylinder, tree, options);
    CHECK(shear_of(least.net).largest < 1e-2);
    options.arms = Arms::curve;
    options.reach = std::numeric_limits<int>::max();
    const int steps = 13;
    options.along.resize(3, steps);
    for (int k = 0; k < steps; ++k) {
        const double angle = 2 * samples::k_pi * (k % (steps - 1)) / (steps - 1) + 0.01;
        options.along.col(k) = Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.02);
    }
    const Drape around = drape(cylinder, tree, options);
    // Shortest ways between points at one height are at that height.
    CHECK(largest_on_arms(around, true, [](const Eigen::Vector3d& x) { return std::abs(x.z() - 0.02); }) < 1e-9);
    CHECK(around.places.row(0).maxCoeff() > 30);
    CHECK(shear_of(around.net).largest < 1e-2);
}

TEST_CASE("Arms of least shear shear less than geodesic ones, on the average and at the worst, and cover as much") {
    struct Case {
        const char* surface;
        std::optional<Eigen::Vector3d> seed;
        double mean, largest;  // parts of those of geodesic arms, at the most
    };
    const Case beginnings[] = {
        {"hemisphere", Eigen::Vector3d(1.5, 0.5, 2.5), 0.97, 0.95},
        {"hemisphere", Eigen::Vector3d(1, 0, 2.5), 0.98, 0.95},
        {"shell", Eigen::Vector3d(1.5, -0.8, 1), 0.85, 0.75},
        {"torso", Eigen::Vector3d(0.7, 0.7, 2.5), 0.85, 0.95},
        {"torso", Eigen::Vector3d(1, 0, 3), 0.8, 0.8},
    };
    for (const auto& [name, seed, mean, largest] : beginnings) {
        CAPTURE(name);
        const Surface surface = make_own_surface(name);
        const auto [straight, bent, before, now] = compared(surface, beginning(surface, 2000, seed));
        const Shear a = shear_of(straight.net), b = shear_of(bent.net);
        CAPTURE(a.mean, b.mean, a.largest, b.largest, before, now);
        CHECK(bent.arms == Arms::least_shear);
        CHECK(b.mean < mean * a.mean);
        CHECK(b.largest < largest * a.largest);
        CHECK(now > before - 0.003);
        CHECK(max_deviation(bent.net, bent.net.rest_positions()) < samples::k_exact);
    }
}

TEST_CASE("From the side a hemisphere is sheared hardly more than from its pole, with arms of least shear") {
    const Surface hemisphere = make_own_surface("hemisphere");
    const SurfaceTree tree(hemisphere);
    const double from_pole = shear_of(drape(hemisphere, tree, beginning(hemisphere, 2000)).net).mean;
    const auto [straight, bent, before, now] =
        compared(hemisphere, beginning(hemisphere, 2000, Eigen::Vector3d(1.5, 0.5, 2.5)));
    CHECK(shear_of(straight.net).mean > 1.05 * from_pole);
    CHECK(shear_of(bent.net).mean < 1.03 * from_pole);
}

TEST_CASE("Arms of least shear are no worse than geodesic ones anywhere, and it is said where they are these") {
    for (const OwnSurface& own : own_surfaces()) {
        CAPTURE(own.name);
        const Surface surface = own.make();
        for (const auto border : {DrapeOptions::Border::inside, DrapeOptions::Border::cut}) {
            DrapeOptions options = beginning(surface, 600);
            options.border = border;
            const auto [straight, bent, before, now] = compared(surface, options);
            CHECK(now > before - 0.01);
            if (bent.arms == Arms::geodesic) {
                CHECK(bent.net.rest_positions() == straight.net.rest_positions());
            } else if (border == DrapeOptions::Border::inside) {
                CHECK(shear_of(bent.net).mean < shear_of(straight.net).mean);
                CHECK(shear_of(bent.net).largest < shear_of(straight.net).largest + samples::k_pi / 180);
            }
        }
    }
}

TEST_CASE("The directions at the seed, the reach and the limit hold for arms of least shear, too") {
    const Surface surface = make_own_surface("hemisphere");
    DrapeOptions options = beginning(surface, 1500, Eigen::Vector3d(1.5, 0.5, 2.5));
    options.direction = {1, 1, 0};
    const auto [straight, bent, before, now] = compared(surface, options);
    REQUIRE(bent.arms == Arms::least_shear);
    CHECK(samples::k_pi / 2 - shear_of(bent.net).largest > options.smallest_angle - 1e-9);
    const auto at = [](const Drape& drape, int i, int j) -> Eigen::Vector3d {
        for (int v = 0; v < drape.net.vertex_count(); ++v)
            if (drape.places(0, v) == i && drape.places(1, v) == j) return drape.net.rest_positions().col(v);
        return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    };
    for (const auto& [i, j] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0), std::pair(0, -1)})
        CHECK((at(bent, i, j) - at(straight, i, j)).norm() < 1e-12);
    options.reach = 12;
    CHECK(compared(surface, options).bent.places.cwiseAbs().maxCoeff() == 12);
}

TEST_CASE("An arm follows a drawn curve: its vertices are on it, every edge is exact, the other arm is geodesic") {
    for (const char* name : {"shell", "hemisphere", "torso", "hypar"}) {
        CAPTURE(name);
        const Surface surface = make_own_surface(name);
        const SurfaceTree tree(surface);
        DrapeOptions options = beginning(surface, 1500);
        options.arms = Arms::curve;
        // A bend around the seed.
        const SurfaceTree::Nearest middle = tree.nearest(options.seed);
        const Eigen::Vector3d normal = surface.normal_at(middle.at);
        const Eigen::Vector3d u = (options.direction - options.direction.dot(normal) * normal).normalized(),
                              v = normal.cross(u);
        options.along.resize(3, 7);
        for (int k = 0; k < 7; ++k) {
            const double s = 4 * (k - 3) * options.length;
            options.along.col(k) = tree.nearest(middle.position + s * u + 0.03 / options.length * s * s * v).position;
        }
        const Drape along = drape(surface, tree, options);
        CHECK(along.arms == Arms::curve);
        CHECK(max_deviation(along.net, along.net.rest_positions()) < samples::k_exact);
        const Positions path = cut_path(surface, cut_line(surface, tree, options.along));
        const auto distance = [&](const Eigen::Vector3d& x) {
            double least = std::numeric_limits<double>::infinity();
            for (Eigen::Index k = 0; k + 1 < path.cols(); ++k) {
                const Eigen::Vector3d a = path.col(k), d = path.col(k + 1) - a;
                if (d.isZero(0)) continue;
                least = std::min(least, (a + std::clamp((x - a).dot(d) / d.squaredNorm(), 0., 1.) * d - x).norm());
            }
            return least;
        };
        int on_it = 0;
        for (int w = 0; w < along.net.vertex_count(); ++w)
            if (along.places(1, w) == 0 && std::abs(along.places(0, w)) <= 10) {
                CHECK(distance(along.net.rest_positions().col(w)) < 1e-9 * options.length);
                ++on_it;
            }
        CHECK(on_it == 21);
    }
}

TEST_CASE("The seed goes to the nearest point of the curve, and along it wherever it is dragged") {
    const Surface plane(samples::plane(9, 1));
    const SurfaceTree tree(plane);
    DrapeOptions options;
    options.length = 0.1;
    options.arms = Arms::curve;
    options.along.resize(3, 3);
    options.along << -0.5, 0, 0.5, 0, 0, 0.5, 0, 0, 0;  // to the middle, and then aslant
    const auto begun = [&](const Eigen::Vector3d& seed) {
        options.seed = seed;
        const Drape laid = drape(plane, tree, options);
        for (int v = 0; v < laid.net.vertex_count(); ++v)
            if (laid.places.col(v).isZero()) return Eigen::Vector3d(laid.net.rest_positions().col(v));
        return Eigen::Vector3d(1, 1, 1);
    };
    CHECK((begun({-0.3, 0.1, 0}) - Eigen::Vector3d(-0.3, 0, 0)).norm() < 1e-12);
    CHECK((begun({0.3, 0.2, 0}) - Eigen::Vector3d(0.25, 0.25, 0)).norm() < 1e-12);
    CHECK((begun({-0.9, 0, 0}) - Eigen::Vector3d(-0.5, 0, 0)).norm() < 1e-12);
}

TEST_CASE("A curve that no arm can follow is refused with a sentence") {
    const auto refusal = [](const Positions& along) {
        const Surface plane(samples::plane(9, 1));
        DrapeOptions options;
        options.length = 0.1;
        options.arms = Arms::curve;
        options.along = along;
        return samples::refusal_of([&] { drape(plane, SurfaceTree(plane), options); });
    };
    Positions ends(3, 2);
    ends << 0, 0.05, 0, 0, 0, 0;
    CHECK_THAT(refusal(ends), Contains("bad_option") && Contains("shorter than an edge"));
    CHECK_THAT(refusal(ends.leftCols(1).replicate(1, 2)), Contains("bad_option") && Contains("has no length"));
    CHECK_THAT(refusal(ends.leftCols(1)), Contains("bad_option") && Contains("two points"));
    ends(2, 1) = 5;
    CHECK_THAT(refusal(ends), Contains("bad_option") && Contains("point 2 of the curve"));
    ends(2, 1) = std::numeric_limits<double>::infinity();
    CHECK_THAT(refusal(ends), Contains("non_finite"));
}

TEST_CASE("A curve that turns back along itself is refused, wherever the seed is, and a sharp bend is not") {
    const Surface plane(samples::plane(20, 1));
    DrapeOptions options;
    options.length = 0.1;
    options.arms = Arms::curve;
    const auto along = [&](const Eigen::Vector3d& end) {
        options.along = Positions(3, 3);
        options.along << Eigen::Vector3d(-0.8, 0.03, 0), Eigen::Vector3d(0.7, 0.03, 0), end;
        return drape(plane, SurfaceTree(plane), options);
    };
    for (const double seed : {-0.5, 0., 0.7}) {
        CAPTURE(seed);
        options.seed = {seed, 0, 0};
        CHECK_THROWS_WITH(along({-0.8, 0.03, 0}), Contains("turns back along itself"));
        CHECK_THROWS_WITH(along({0.2, 0.03, 0}), Contains("turns back along itself"));
        CHECK(along({0.6, 0.8, 0}).net.face_count() > 100);
    }
}

TEST_CASE("Of pieces that which has the curve follows it, and a curve over several is refused") {
    const Surface plane(samples::plane(9, 1));
    const SurfaceTree tree(plane);
    Positions cut(3, 2), curve(3, 2);
    cut << -1, 1, 0, 0, 0, 0;
    curve << -0.8, 0.8, 0.3, 0.6, 0, 0;
    const Surface opened = cut_open(plane, {{cut_line(plane, tree, cut)}});
    PiecesOptions options;
    options.drape.length = 0.1;
    options.drape.arms = Arms::curve;
    options.drape.along = curve;
    const DrapedPieces made = drape_pieces(opened, options);
    REQUIRE(made.draped.size() == 2);
    for (const DrapedPiece& piece : made.draped) {
        const bool is_upper = piece.drape.net.rest_positions().row(1).mean() > 0;
        CHECK(piece.drape.arms == (is_upper ? Arms::curve : Arms::geodesic));
    }
    options.drape.along(1, 0) = -0.3;
    CHECK_THROWS_WITH(drape_pieces(opened, options), Contains("curve"));
    options.drape.along.col(0) << 1e9, 0, 0;
    CHECK_THROWS_WITH(drape_pieces(opened, options), Contains("point 1 of the curve") && Contains("away from"));
}

TEST_CASE("A net that leaves the surface where it locks keeps its arms") {
    const auto guide = std::make_shared<const Guide>(make_own_surface("torso"));
    DrapeOptions options = beginning(guide->surface(), 300, Eigen::Vector3d(1, 0, 3));
    options.arms = Arms::least_shear;
    CHECK(bridged_drape(guide, options, 0.5).arms == drape(guide->surface(), guide->tree(), options).arms);
}
