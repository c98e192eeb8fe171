#include "surface/geodesics.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "constants.h"
#include "mesh_files.h"
#include "sample_surfaces.h"
#include "surface/surface_tree.h"

using namespace chebnet;
using Catch::Matchers::Contains;

namespace {

SurfacePoint place_near(const Surface& surface, const Eigen::Vector3d& point) {
    return SurfaceTree(surface).nearest(point).at;
}

}  // namespace

TEST_CASE("In a plane a geodesic is a line, whatever the triangles, their edges and vertices") {
    const Surface surface(samples::plane(11, 1));  // vertices at multiples of 0.2
    for (const Eigen::Vector3d& start : {Eigen::Vector3d(0.03, 0.01, 0), Eigen::Vector3d(0, 0, 0),
                                         Eigen::Vector3d(0.1, 0, 0), Eigen::Vector3d(0.1, 0.1, 0)})
        for (int degrees = 0; degrees < 360; degrees += 15) {
            CAPTURE(start.transpose(), degrees);
            const double angle = degrees * samples::k_pi / 180;
            const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0);
            const Geodesic line = trace_geodesic(surface, place_near(surface, start), direction, 0.77);
            CHECK_FALSE(line.met_boundary);
            CHECK(line.length == Approx(0.77));
            CHECK((surface.position_at(line.end) - (start + 0.77 * direction)).norm() < 1e-12);
            CHECK((line.end_direction - direction).norm() < 1e-12);
            CHECK(samples::length_of(line.points) == Approx(0.77));
        }
}

TEST_CASE("A geodesic ends at the boundary") {
    const Surface surface(samples::plane(11, 1));
    const Geodesic line = trace_geodesic(surface, place_near(surface, {0, 0.05, 0}), {2, 0, 0}, 5);
    CHECK(line.met_boundary);
    CHECK(line.length == Approx(1));
    CHECK((surface.position_at(line.end) - Eigen::Vector3d(1, 0.05, 0)).norm() < 1e-12);
}

TEST_CASE("A geodesic of a cylinder is a helix") {
    const int around = 60;
    const Surface surface(samples::cylinder(around, 9, 3));
    // Unrolled, the prism is flat: with s the length of its circumference, exactly the line of the same slope.
    const double circumference = 2 * around * std::sin(samples::k_pi / around), slope = 0.25;
    const double turn = std::hypot(circumference, slope * circumference);
    for (const Eigen::Vector3d& start : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, 0, -0.9)}) {
        const Geodesic helix = trace_geodesic(surface, place_near(surface, start), {0, 1, slope}, turn);
        CHECK_FALSE(helix.met_boundary);
        const Eigen::Vector3d end = surface.position_at(helix.end);
        CHECK((end - (start + Eigen::Vector3d(0, 0, slope * circumference))).norm() < 0.01);
        CHECK(helix.end_direction.z() == Approx(slope / std::hypot(1, slope)).epsilon(0.002));
    }
}

TEST_CASE("A geodesic of a sphere is a great circle, and comes back") {
    const Surface surface(samples::sphere(40));
    const Eigen::Vector3d start = Eigen::Vector3d(0.3, 0.5, 0.6).normalized();
    const Eigen::Vector3d direction = start.cross(Eigen::Vector3d(0.2, -1, 0.4)).normalized();
    const Geodesic circle = trace_geodesic(surface, place_near(surface, start), direction, 2 * samples::k_pi);
    CHECK((surface.position_at(circle.end) - start).norm() < 0.02);
    const Eigen::Vector3d axis = start.cross(direction);
    CHECK((axis.transpose() * circle.points).cwiseAbs().maxCoeff() < 0.02);
}

TEST_CASE("From a peak a geodesic leaves in every direction") {
    const Surface surface(samples::sphere(20));
    for (const Eigen::Vector3d& pole : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(-1, 0, 0)})
        for (int degrees = 0; degrees < 360; degrees += 15) {
            CAPTURE(pole.transpose(), degrees);
            const Eigen::Vector3d a = pole.unitOrthogonal(), b = pole.cross(a);
            const double angle = degrees * samples::k_pi / 180;
            const Eigen::Vector3d direction = std::cos(angle) * a + std::sin(angle) * b;
            const Geodesic arc = trace_geodesic(surface, place_near(surface, pole), direction, samples::k_pi / 2);
            CHECK((surface.position_at(arc.end) - direction).norm() < 0.05);
        }
}

TEST_CASE("A walk back along a geodesic ends where it began") {
    const unsigned seed = GENERATE(1u, 2u);
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Surface surface(samples::torus(31, 17, 2, 0.8));
    for (int i = 0; i < 100; ++i) {
        const SurfacePoint start = samples::random_place(surface, random);
        const Geodesic there = trace_geodesic(surface, start, samples::random_point(1, random), 2);
        const Geodesic back = trace_geodesic(surface, there.end, -there.end_direction, 2);
        CHECK((surface.position_at(back.end) - surface.position_at(start)).norm() < 1e-9);
    }
}

TEST_CASE("A walk crosses a triangle without area") {
    Mesh mesh{Positions(3, 5), {}};
    mesh.positions << 0, 2, 1, 0.5, 1,  //
        0, 0, 0, 1, -1,                 //
        0, 0, 0, 0, 0;
    mesh.faces.add({0, 2, 3});
    mesh.faces.add({2, 1, 3});
    mesh.faces.add({0, 1, 2});  // vertex 2 lies between 0 and 1
    mesh.faces.add({1, 0, 4});
    const Surface surface(mesh);
    CHECK(surface.areas()[2] == 0);
    for (const double x : {0.7, 1.2}) {
        const Eigen::Vector3d start(x, 0.2, 0);
        const Geodesic line = trace_geodesic(surface, place_near(surface, start), {0.1, -1, 0}, 0.5);
        const Eigen::Vector3d end = start + 0.5 * Eigen::Vector3d(0.1, -1, 0).normalized();
        CHECK((surface.position_at(line.end) - end).norm() < 1e-12);
    }
}

TEST_CASE("A direction or a length that is none is refused") {
    const Surface surface(samples::plane(5, 1));
    const auto refusal = [&](const Eigen::Vector3d& direction, double length) {
        return samples::refusal_of([&] { trace_geodesic(surface, {3, {0.2, 0.3, 0.5}}, direction, length); });
    };
    CHECK_THAT(refusal({0, 0, 1}, 1), Contains("bad_option") && Contains("upright"));
    CHECK_THAT(refusal({0, 0, 0}, 1), Contains("bad_option"));
    CHECK_THAT(refusal({1, 0, 0}, -1), Contains("bad_option") && Contains("length"));
}

TEST_CASE("Distances in a plane are straight") {
    const Surface surface(samples::plane(21, 1));
    for (const Eigen::Vector3d& source : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.13, -0.28, 0)}) {
        const std::vector<SurfacePoint> sources{place_near(surface, source)};
        const std::vector<double> distances = geodesic_distances(surface, sources);
        for (int v = 0; v < surface.vertex_count(); ++v)
            CHECK(distances[v] == Approx((surface.positions().col(v) - source).norm()).margin(0.006));
    }
}

TEST_CASE("Distances on a sphere are arcs, to the nearest of several sources") {
    const Surface surface(samples::sphere(40));
    const Eigen::Vector3d a = Eigen::Vector3d(0.2, 0.9, 0.4).normalized(),
                          b = Eigen::Vector3d(0, -0.1, -1).normalized();
    const std::vector<SurfacePoint> sources{place_near(surface, a), place_near(surface, b)};
    const std::vector<double> distances = geodesic_distances(surface, sources);
    double largest_error = 0;
    for (int v = 0; v < surface.vertex_count(); ++v) {
        const Eigen::Vector3d x = surface.positions().col(v);
        const auto arc = [&](const Eigen::Vector3d& p) { return std::atan2(x.cross(p).norm(), x.dot(p)); };
        largest_error = std::max(largest_error, std::abs(distances[v] - std::min(arc(a), arc(b))));
    }
    CHECK(largest_error < 0.01);
}

TEST_CASE("Distances that are looked for up to a limit are the same, and none is farther") {
    const Surface surface(samples::sphere(20));
    const std::vector<SurfacePoint> sources{place_near(surface, {0.2, 0.9, 0.4})};
    const std::vector<double> all = geodesic_distances(surface, sources),
                              near = geodesic_distances(surface, sources, 0.8);
    for (int v = 0; v < surface.vertex_count(); ++v)
        CHECK(near[v] == (all[v] <= 0.8 ? all[v] : std::numeric_limits<double>::infinity()));
}

TEST_CASE("No way leads to another piece") {
    Mesh mesh = samples::plane(3, 1);
    const int count = static_cast<int>(mesh.positions.cols());
    mesh.positions.conservativeResize(3, count + 3);
    mesh.positions.rightCols(3) << 5, 6, 5, 0, 0, 1, 0, 0, 0;
    mesh.faces.add({count, count + 1, count + 2});
    const Surface surface(mesh);
    const std::vector<SurfacePoint> sources{{0, {1, 0, 0}}};
    const std::vector<double> distances = geodesic_distances(surface, sources);
    CHECK(std::isfinite(distances[count - 1]));
    for (int v = count; v < count + 3; ++v) CHECK(distances[v] == std::numeric_limits<double>::infinity());
}
