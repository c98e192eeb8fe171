#include "remesh/marked_creases.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "drape/drape.h"
#include "net/measures.h"
#include "net/topology.h"
#include "remesh/remesh.h"
#include "sample_surfaces.h"
#include "surface/gallery.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

/// point(t) for t from 0 to 1 in steps.
MarkedCrease curve(int steps, const std::function<Eigen::Vector3d(double)>& point) {
    MarkedCrease points(3, steps + 1);
    for (int k = 0; k <= steps; ++k) points.col(k) = point(static_cast<double>(k) / steps);
    return points;
}

MarkedCrease closed(MarkedCrease points) {
    points.rightCols(1) = points.leftCols(1).eval();
    return points;
}

/// A great circle, tilted.
MarkedCrease waist(double tilt) {
    return closed(curve(12, [&](double t) {
        const double angle = 2 * std::numbers::pi * t;
        return Eigen::Vector3d(std::cos(angle), std::sin(angle), tilt * std::cos(angle)).normalized();
    }));
}

RemeshOptions along(const std::vector<MarkedCrease>& creases, int cells) {
    RemeshOptions options;
    options.cells = cells;
    options.marked_creases = creases;
    return options;
}

/// With all that is promised of a net over a whole surface.
Remesh remeshed_along(const Surface& surface, const RemeshOptions& options, int characteristic) {
    const auto guide = std::make_shared<const Guide>(surface);
    Remesh made = remesh(guide, options);
    const Net& net = made.net;
    CHECK(net.vertex_count() - net.edge_count() + net.face_count() == characteristic);
    CHECK(max_deviation(net, net.rest_positions()) < 1e-9);
    CHECK(corner_angle_range(net, net.rest_positions()).smallest >= options.smallest_angle - 1e-9);
    CHECK(measure_drape(surface, guide->tree(), net).mean_distance < 0.3 * net.mean_length());
    return made;
}

bool has_followed(const Remesh& made) { return made.kept.missed() == 0; }

}  // namespace

TEST_CASE("Net lines run along a waist that is marked on a ball, however it is tilted", "[large]") {
    const Surface ball(samples::sphere(24));
    for (const double tilt : {0.3, 0.7}) {
        const MarkedCrease marked = waist(tilt);
        const RemeshOptions options = along({marked}, 800);
        const Remesh made = remeshed_along(ball, options, 2);
        REQUIRE(made.kept.creases.size() == 1);
        CHECK(made.kept.creases[0] < k_followed_distance);
        CHECK(made.kept.missed() == 0);
        // As many vertices as there are edges along it stand on the circle itself.
        const Eigen::Vector3d axis = marked.col(0).cross(marked.col(3)).normalized();
        const Positions& x = made.net.rest_positions();
        const double length = made.net.mean_length();
        const auto on_it = ((axis.transpose() * x).array().abs() < 0.15 * length).count();
        CHECK(on_it > 0.9 * 2 * std::numbers::pi / length);
        CHECK(distance_along(remeshed_along(ball, along({}, 800), 2).net, marked) > 0.25);
    }
}

TEST_CASE("Net lines run along a waist of a torus, and along a curve from border to border", "[large]") {
    const MarkedCrease ring = curve(16, [](double t) {
        const double v = 2 * std::numbers::pi * t, u = 0.3 + 0.15 * std::cos(v), r = 3 + std::cos(v);
        return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), std::sin(v));
    });
    CHECK(has_followed(remeshed_along(Surface(samples::torus(60, 24, 3, 1)), along({closed(ring)}, 900), 0)));

    const MarkedCrease over = curve(4, [](double t) {
        const double angle = std::numbers::pi * t;
        return Eigen::Vector3d(-3 * std::cos(angle), 1.2 * std::sin(angle), 2.7 * std::sin(angle));
    });
    CHECK(has_followed(remeshed_along(make_own_surface("hemisphere"), along({over}, 800), 1)));
}

TEST_CASE("The same marked creases give the same net, and what is marked splits the surface's triangles") {
    const auto ball = std::make_shared<const Guide>(Surface(samples::sphere(12)));
    const RemeshOptions options = along({waist(0.5)}, 300);
    const Remesh first = remesh(ball, options), second = remesh(ball, options);
    CHECK(first.net.rest_positions() == second.net.rest_positions());
    CHECK(first.net.faces().vertices == second.net.faces().vertices);
    CHECK(first.kept.creases == second.kept.creases);

    const auto plane = std::make_shared<const Guide>(Surface(samples::plane(9, 1)));
    const MarkedCrease line = curve(1, [](double t) { return Eigen::Vector3d(1.6 * t - 0.8, 0.9 * t - 0.31, 0); });
    const Creases creases = find_creases(plane, 0, {line});
    CHECK(creases.guide->surface().area() == Approx(4).epsilon(1e-12));
    double length = 0;
    for (const Segment& segment : creases.segments()) {
        length += (segment.to - segment.from).norm();
        CHECK(squared_distance(segment.from, line.col(0), line.col(1)) < 1e-6);
    }
    CHECK(length == Approx((line.col(1) - line.col(0)).norm()).epsilon(1e-4));
    CHECK(find_creases(plane, 0, {}).sides.empty());
    CHECK(find_creases(plane, 0, {}).guide == plane);
}

TEST_CASE("Where a marked crease is not followed it is said how far net lines are from it") {
    // Neighbouring net lines cannot run along circles that are a third of an edge apart.
    std::vector<MarkedCrease> rings;
    for (const double z : {0.0, 0.05, 0.11})
        rings.push_back(closed(curve(16, [&](double t) {
            const double angle = 2 * std::numbers::pi * t;
            return Eigen::Vector3d(std::cos(angle), std::sin(angle), z);
        })));
    const Remesh made = remeshed_along(Surface(samples::sphere(16)), along(rings, 400), 2);
    REQUIRE(made.kept.creases.size() == 3);
    CHECK(made.kept.missed() >= 1);
    const std::vector<std::string> sentences = unkept_wishes({}, made.kept);
    REQUIRE(std::ssize(sentences) == made.kept.missed());
    CHECK_THAT(sentences[0], Contains("marked crease") && Contains("edges away"));
}

TEST_CASE("A marked crease that is none is refused by name") {
    Mesh mesh = samples::sphere(8);
    const auto count = static_cast<int>(mesh.positions.cols());
    const Mesh other = mesh;
    mesh.positions.conservativeResize(3, 2 * count);
    mesh.positions.rightCols(count) = other.positions.colwise() + Eigen::Vector3d(3, 0, 0);
    for (int f = 0; f < other.faces.size(); ++f)
        mesh.faces.add({other.faces[f][0] + count, other.faces[f][1] + count, other.faces[f][2] + count});
    const auto balls = std::make_shared<const Guide>(Surface(mesh));
    const auto refused = [&](const std::vector<MarkedCrease>& creases, const std::string& why) {
        CHECK_THROWS_WITH(remesh(balls, along(creases, 200)), Contains(why));
    };
    const auto points = [](const std::vector<Eigen::Vector3d>& list) {
        MarkedCrease crease(3, std::ssize(list));
        for (std::size_t k = 0; k < list.size(); ++k) crease.col(static_cast<Eigen::Index>(k)) = list[k];
        return crease;
    };
    const MarkedCrease good = points({{1, 0, 0}, {0, 1, 0}});
    refused({good, points({})}, "marked crease 2 needs at least two points");
    refused({points({{0, 0, 1}})}, "marked crease 1 needs at least two points");
    refused({points({{0, 0, 1}, {0, 0, 1}})}, "marked crease 1 has no length");
    refused({points({{0, 0, 1}, {0, NAN, 1}})}, "point 2 of marked crease 1 has a coordinate that is not finite");
    refused({points({{0, 0, 1}, {0, 0, 2}})}, "point 2 of marked crease 1 is");
    refused({points({{0, 0, 1}, {3, 0, 1}})}, "different pieces");
    refused({points({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 0}})}, "marked crease 1 crosses or touches itself");
    refused(std::vector<MarkedCrease>(k_most_marked_creases + 1, good), "no more than 100 creases");
    refused({MarkedCrease::Ones(3, k_most_marked_points + 1)}, "no more than 10000 points");
}
