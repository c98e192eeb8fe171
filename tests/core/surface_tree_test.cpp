#include "surface/surface_tree.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "sample_surfaces.h"

using namespace chebnet;

namespace {

/// The nearest of some points of the segment ab and, for the three of a triangle, of its inside.
double distance_to_triangle(const Surface& surface, int face, const Eigen::Vector3d& p) {
    const Eigen::Vector3i t = surface.triangles().col(face);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d a = surface.positions().col(t[k]), b = surface.positions().col(t[(k + 1) % 3]);
        const double part = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        least = std::min(least, (a + part * (b - a) - p).norm());
    }
    const Eigen::Vector3d normal = surface.face_normals().col(face), a = surface.positions().col(t[0]);
    const Eigen::Vector3d foot = p - (p - a).dot(normal) * normal;
    bool is_inside = true;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d from = surface.positions().col(t[k]), to = surface.positions().col(t[(k + 1) % 3]);
        is_inside = is_inside && (to - from).cross(foot - from).dot(normal) >= 0;
    }
    return is_inside ? std::min(least, (foot - p).norm()) : least;
}

double distance_by_all(const Surface& surface, const Eigen::Vector3d& p) {
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < surface.face_count(); ++f) least = std::min(least, distance_to_triangle(surface, f, p));
    return least;
}

/// Triangles anywhere, of any size, on a strip: neither even nor small.
Mesh crumpled_strip(std::mt19937& random) {
    return samples::quads(2, 200, false, false, [&](int, int) { return samples::random_point(1, random); });
}

}  // namespace

TEST_CASE("The nearest point is that of a search through all triangles", "[large]") {
    const unsigned seed = GENERATE(1u, 2u, 3u);
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (const Mesh& mesh :
         {samples::sphere(9), samples::torus(30, 12, 2, 0.7), crumpled_strip(random), samples::cylinder(9, 40, 1)}) {
        const Surface surface(mesh);
        const SurfaceTree tree(surface);
        for (int i = 0; i < 200; ++i) {
            const Eigen::Vector3d p = samples::random_point(3, random);
            const SurfaceTree::Nearest nearest = tree.nearest(p);
            CHECK(nearest.distance == Approx(distance_by_all(surface, p)).epsilon(1e-12));
            CHECK((nearest.position - p).norm() == Approx(nearest.distance).epsilon(1e-12));
            CHECK(surface.position_at(nearest.at) == nearest.position);
            CHECK(nearest.at.weights.minCoeff() >= 0);
            CHECK(nearest.at.weights.sum() == Approx(1));
            const int guess = samples::random_place(surface, random).face;
            CHECK(tree.nearest(p, guess).distance == nearest.distance);
        }
    }
}

TEST_CASE("The weights of a point on an edge are not negative, whatever rounding does") {
    const Surface torus(samples::torus(48, 24, 3, 1));
    const SurfaceTree tree(torus);
    for (int side = 0; side < 3 * torus.face_count(); ++side)
        for (const double part : {1e-14, 0.1, 1. / 3}) {
            const Eigen::Vector3d point =
                (1 - part) * torus.positions().col(torus.from(side)) + part * torus.positions().col(torus.to(side));
            CHECK(tree.nearest(point).at.weights.minCoeff() >= 0);
        }
}

TEST_CASE("From a point however far away the nearest is the one that lies in its direction") {
    const Surface ball(samples::sphere(24));
    const SurfaceTree tree(ball);
    const Eigen::Vector3d direction = Eigen::Vector3d(1, -2, 2) / 3;
    const double farthest = (direction.transpose() * ball.positions()).maxCoeff();
    for (const double distance : {1e60, 1e76, 1e154, 1e200, 1e308}) {
        CAPTURE(distance);
        for (const auto& found : {tree.nearest(distance * direction), tree.nearest(distance * direction, 7)}) {
            CHECK(direction.dot(found.position) == Approx(farthest).epsilon(1e-6));
            CHECK(found.distance == Approx(distance));
        }
        CHECK(tree.nearest_in(3, distance * direction).at.face == 3);
    }
}

TEST_CASE("A point of the surface is its own nearest, and a thin triangle counts") {
    Mesh mesh = samples::plane(6, 1);
    mesh.positions.conservativeResize(3, 37);
    mesh.positions.col(36) = (mesh.positions.col(0) + mesh.positions.col(1)) / 2;  // on the edge of its own triangle
    mesh.faces.add({1, 0, 36});
    const Surface surface(mesh);
    CHECK(surface.areas()[surface.face_count() - 1] == 0);
    const SurfaceTree tree(surface);
    std::mt19937 random(4);
    for (int i = 0; i < 100; ++i) {
        const SurfacePoint place = samples::random_place(surface, random);
        CHECK(tree.nearest(surface.position_at(place)).distance < 1e-15);
    }
    CHECK(tree.nearest(Eigen::Vector3d(0.3, 0.2, -7)).distance == Approx(7));
}

TEST_CASE("A ray meets a sphere where it should, from outside and inside") {
    const Surface surface(samples::sphere(30));
    const SurfaceTree tree(surface);
    std::mt19937 random(6);
    for (int i = 0; i < 300; ++i) {
        const Eigen::Vector3d target = samples::random_point(1, random).normalized();
        const auto from_outside = tree.hit(3 * target, -target);
        REQUIRE(from_outside);
        CHECK(from_outside->way == Approx(2).margin(2e-3));
        CHECK((from_outside->position - target).norm() < 2e-3);
        const auto from_inside = tree.hit(Eigen::Vector3d::Zero(), 0.5 * target);
        REQUIRE(from_inside);
        CHECK(from_inside->way == Approx(2).margin(4e-3));
        CHECK_FALSE(tree.hit(3 * target, target));
    }
}

TEST_CASE("A ray through an edge or a vertex is not lost") {
    const Surface surface(samples::plane(9, 1));
    const SurfaceTree tree(surface);
    const Eigen::Vector3d down(0, 0, -1);
    for (int v = 0; v < surface.vertex_count(); ++v) {
        const Eigen::Vector3d vertex = surface.positions().col(v);
        CHECK(tree.hit(vertex - 2 * down, down).value().way == Approx(2));
        const Eigen::Vector3d slanted = (down + Eigen::Vector3d(0.1, 0.3, 0)).normalized();
        CHECK(tree.hit(vertex - 2 * slanted, slanted).value().way == Approx(2));
    }
    for (int side = 0; side < 3 * surface.face_count(); ++side) {
        const Eigen::Vector3d middle =
            (surface.positions().col(surface.from(side)) + surface.positions().col(surface.to(side))) / 2;
        CHECK(tree.hit(middle - down, down).has_value());
    }
    CHECK_FALSE(tree.hit({2, 0, 1}, down));
}
