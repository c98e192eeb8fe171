#include "remesh/thin_limbs.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "drape/drape.h"
#include "drape/tilt.h"
#include "hard_surfaces.h"
#include "implicit_surface.h"
#include "net/topology.h"
#include "remesh/creases.h"
#include "remesh/remesh.h"
#include "sample_surfaces.h"

using namespace chebnet;

namespace {

constexpr int k_cells = 600;
constexpr double k_girth = 4;
constexpr double k_ball_area = 4 * EIGEN_PI;

/// A bar from the middle of the ball of radius 1, as far as `end` on the x axis.
double outside_bar(const Eigen::Vector3d& p, const Eigen::Vector3d& end, double radius) {
    const double along = std::clamp(p.dot(end) / end.squaredNorm(), 0.0, 1.0);
    return (p - along * end).norm() - radius;
}

/// A ball of radius 1 with bars of a radius that stick out of it by 1.
Mesh ball_with_bars(double radius) {
    return samples::implicit_surface(
        60, Eigen::Vector3d::Constant(-2.3), Eigen::Vector3d::Constant(2.3), [&](const Eigen::Vector3d& p) {
            return std::min({p.norm() - 1, outside_bar(p, {2, 0, 0}, radius), outside_bar(p, {0, -1.9, 0.6}, radius)});
        });
}

/// Two balls of these radii, and a bar between them.
Mesh dumbbell(double other, double bar) {
    return samples::implicit_surface(60, Eigen::Vector3d(-1.413, -2.517, -2.523), Eigen::Vector3d(4.631, 2.541, 2.529),
                                     [&](const Eigen::Vector3d& p) {
                                         return std::min({p.norm() - 1, (p - Eigen::Vector3d(3, 0, 0)).norm() - other,
                                                          outside_bar(p, {3, 0, 0}, bar)});
                                     });
}

std::shared_ptr<const Guide> guide_of(const Mesh& mesh) { return std::make_shared<const Guide>(Surface(mesh)); }

WithoutLimbs trimmed(const std::shared_ptr<const Guide>& guide, double cells = k_cells) {
    return without_thin_limbs(guide, std::sqrt(guide->surface().area() / cells), k_girth, k_sharp_edge);
}

int piece_count(const Surface& surface) {
    const std::vector<int> pieces = surface.components();
    return 1 + *std::max_element(pieces.begin(), pieces.end());
}

}  // namespace

TEST_CASE("Thin limbs are taken off a body, and it is closed where they were") {
    const auto guide = guide_of(ball_with_bars(0.07));
    const WithoutLimbs rest = trimmed(guide);
    REQUIRE(rest.limbs.size() == 2);
    CHECK(rest.guide != guide);
    CHECK(rest.guide->surface().euler_characteristic() == 2);
    CHECK(piece_count(rest.guide->surface()) == 1);
    CHECK(rest.guide->surface().area() == Approx(k_ball_area).epsilon(0.03));
    for (int v = 0; v < rest.guide->surface().vertex_count(); ++v)
        CHECK(rest.guide->surface().positions().col(v).norm() < 1.2);
    for (const ThinLimb& limb : rest.limbs) {
        CHECK(limb.point.norm() > 1.85);
        CHECK(limb.girth < k_girth);
        CHECK(limb.girth > 1);
    }
}

TEST_CASE("Limbs around which enough cells go stay, and more cells keep all") {
    const auto thick = guide_of(ball_with_bars(0.3)), thin = guide_of(ball_with_bars(0.07));
    CHECK(trimmed(thick).guide == thick);
    CHECK(trimmed(thin, 6 * k_cells).guide == thin);
    const auto guide = guide_of(ball_with_bars(0.14));
    CHECK(trimmed(guide, 300).limbs.size() == 2);
    CHECK(trimmed(guide, 4000).guide == guide);
}

TEST_CASE("Surfaces without limbs are given back as they are, whatever is thin about them") {
    const std::vector<std::pair<std::string, Mesh>> surfaces = {
        {"sphere", samples::sphere(16)},
        {"torus", samples::torus(48, 24, 3, 1)},
        {"thin torus", samples::torus(200, 10, 3, 0.05)},
        {"plate", samples::stretched(samples::sphere(24), 1, 1, 0.02)},
        {"ribbon",
         samples::changed(samples::plane(40, 1), [](const auto& p) { return Eigen::Vector3d(p[0], 0.03 * p[1], 0); })},
        {"annulus",
         samples::changed(samples::cylinder(80, 4, 0.05),
                          [](const auto& p) { return Eigen::Vector3d(p[0] * (1 + p[2]), p[1] * (1 + p[2]), 0); })},
        {"thin tube", samples::cylinder(12, 80, 60)},
        {"rings", samples::chain_of_rings(3)}};
    for (const auto& [name, mesh] : surfaces) {
        CAPTURE(name);
        const auto guide = guide_of(mesh);
        const WithoutLimbs rest = trimmed(guide);
        CHECK(rest.guide == guide);
        CHECK(rest.limbs.empty());
    }
}

TEST_CASE("Of a dumbbell with a thin bar both balls stay, but a small one goes with the bar") {
    const WithoutLimbs both = trimmed(guide_of(dumbbell(1, 0.09)));
    CHECK(both.limbs.size() == 1);
    CHECK(piece_count(both.guide->surface()) == 2);
    CHECK(both.guide->surface().euler_characteristic() == 4);
    const WithoutLimbs one = trimmed(guide_of(dumbbell(0.25, 0.09)));
    REQUIRE(one.limbs.size() == 1);
    CHECK(one.limbs.front().point.x() > 3);
    CHECK(piece_count(one.guide->surface()) == 1);
}

TEST_CASE("A net over a body leaves thin limbs off where it would crumple, and says so") {
    const auto guide = guide_of(ball_with_bars(0.07)), ball = guide_of(samples::sphere(24));
    RemeshOptions options;
    options.cells = GENERATE(400, k_cells);
    CAPTURE(options.cells);
    const Remesh made = remesh(guide, options);
    CHECK(made.left_off.size() == 2);
    CHECK(made.net.face_count() == Approx(options.cells).epsilon(0.1));
    CHECK(measure_drape(ball->surface(), ball->tree(), made.net).coverage > 0.99);
    CHECK(remesh(ball, options).left_off.empty());

    const int folds = crumpled_edges(*ball, made.net);
    CHECK(folds <= 2);
    options.singular.forbidden.push_back({{-1, 0, 0}, 1e-6});
    const Remesh with_limbs = remesh(guide, options);
    CHECK(with_limbs.left_off.empty());
    CHECK(crumpled_edges(*ball, with_limbs.net) > 5 * folds);
}
