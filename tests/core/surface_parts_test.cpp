#include "surface/surface_parts.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "sample_surfaces.h"

using namespace chebnet;

namespace {

/// Of each triangle: 0 above the plane z = 0, 1 below; −1 near it.
std::vector<int> halves(const Surface& surface, double near) {
    std::vector<int> part;
    for (int f = 0; f < surface.face_count(); ++f) {
        const double height = surface.position_at({f, Eigen::Vector3d::Constant(1.0 / 3)}).z();
        part.push_back(std::abs(height) < near ? -1 : height < 0);
    }
    return part;
}

}  // namespace

TEST_CASE("Parts of a surface are where they were on it, and what lies between them is in none") {
    const Surface sphere(samples::sphere(16));
    const double near = GENERATE(0.0, 0.3);
    const std::vector<int> part = halves(sphere, near);
    const std::vector<SurfacePart> parts = parts_of(sphere, part, 2);
    REQUIRE(parts.size() == 2);
    double area = 0;
    for (int f = 0; f < sphere.face_count(); ++f) area += part[f] < 0 ? 0 : sphere.areas()[f];
    CHECK(parts[0].surface.area() + parts[1].surface.area() == Approx(area));
    for (const auto& [surface, vertices] : parts) {
        CHECK(surface.euler_characteristic() == 1);
        REQUIRE(surface.vertex_count() == std::ssize(vertices));
        CHECK(surface.positions() == sphere.positions()(Eigen::all, vertices));
    }
}

TEST_CASE("Triangles of a part that touch at a vertex only get one each there") {
    const Surface sphere(samples::sphere(4));
    std::vector<int> part(static_cast<std::size_t>(sphere.face_count()), -1);
    const std::vector<int> around = sphere.faces_around(0);
    REQUIRE(around.size() >= 4);
    part[around[0]] = part[around[2]] = 0;
    const SurfacePart two = parts_of(sphere, part, 1).front();
    CHECK(two.vertices.size() == 5);
    CHECK(two.surface.vertex_count() == 6);
    CHECK(pieces_of(two.surface).size() == 2);
    CHECK_THROWS_AS(parts_of(sphere, part, 2), Error);
}
