// Cones: singular vertices where the curvature of a surface with a border asks for them.
#include "remesh/cones.h"

#include <Eigen/Core>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "drape/drape.h"
#include "drape/tilt.h"
#include "net/topology.h"
#include "remesh/direction_field.h"
#include "remesh/even_triangles.h"
#include "remesh/remesh.h"
#include "remesh/wish_placer.h"
#include "sample_surfaces.h"
#include "surface/guide.h"

using namespace chebnet;

namespace {

/// So many turns of a stair that is 4 wide, each 3 high.
Mesh stair(int turns) {
    return samples::quads(40 * turns + 1, 21, false, false, [&](int i, int j) {
        const double angle = 2 * std::numbers::pi * i / 40, r = 0.2 * (j - 10);
        return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), 3. * i / 40);
    });
}

std::vector<WishedSingular> cones_of(const Mesh& mesh, double most_stretch) {
    const Guide guide{Surface(mesh)};
    return Cones(guide.surface(), guide.tree()).placed(most_stretch);
}

double distance_from_axis(const WishedSingular& cone) { return std::hypot(cone.point.x(), cone.point.y()); }

}  // namespace

TEST_CASE("What is flat, or curved where it has its angles anyway, needs no cones, and what is closed has none") {
    CHECK(cones_of(samples::plane(9, 1), 0.01).empty());
    CHECK(cones_of(samples::cylinder(24, 9, 1), 0.01).empty());
    CHECK(cones_of(samples::sphere(8), 0.01).empty());
}

TEST_CASE("Around a tip that lacks a quarter of its angles one cone of valence 3 leaves nothing") {
    const double slope = std::sqrt(1 - 0.75 * 0.75) / 0.75;  // such a cone is 3/4 of a disc rolled up
    const std::vector<WishedSingular> cones =
        cones_of(samples::graph(25, 1, [&](double x, double y) { return -slope * std::hypot(x, y); }), 0.03);
    REQUIRE(cones.size() == 1);
    CHECK(cones[0].valence == 3);
    CHECK(distance_from_axis(cones[0]) < 0.1);
}

TEST_CASE("A hemisphere laid flat with its border kept is stretched by two in the middle, and cones take that away") {
    // By stereographic projection u = log(2 / (1 + tan² (θ / 2))), at most log 2, at the pole.
    const Mesh half = samples::sphere(12, true);
    CHECK(cones_of(half, std::log(2.0)).empty());
    const std::vector<WishedSingular> few = cones_of(half, 0.2), more = cones_of(half, 0.1);
    REQUIRE(!few.empty());
    CHECK(few.size() < more.size());
    for (const WishedSingular& cone : few) CHECK(cone.valence == 3);
}

TEST_CASE("A winding stair has its cones near its axis, all of valence 5, and more if it has more turns") {
    const std::vector<WishedSingular> two = cones_of(stair(2), 0.08), four = cones_of(stair(4), 0.08);
    for (const WishedSingular& cone : four) {
        CHECK(cone.valence == 5);
        CHECK(distance_from_axis(cone) < 1);
    }
    CHECK(2 * four.size() >= 3 * two.size());
}

TEST_CASE("Where singular vertices alone are wished for, the field has these and no others") {
    const Guide guide{Surface(stair(2))};
    const std::vector<WishedSingular> cones = Cones(guide.surface(), guide.tree()).placed(0.1);
    for (const double length : {0.3, 0.15}) {
        const EvenTriangles even = even_triangles(guide.surface(), guide.tree(), length);
        const PlacedWishes wishes = WishPlacer(even.surface, length).placed({cones, {}, true}, guide.tree());
        REQUIRE(wishes.pins.size() == cones.size());
        for (const bool crosses : {false, true}) {
            FieldOptions options;
            options.wishes = &wishes;
            options.crosses_border = crosses;
            const DirectionField field = smoothest_field(even.surface, options);
            CHECK(singular_count(field) == std::ssize(cones));
            for (const PlacedWishes::Pin& pin : wishes.pins) CHECK(field.holonomy[pin.vertex] == (pin.index + 4) % 4);
        }
    }
}

TEST_CASE("A winding stair is covered by a net with cones, smoothly, where a field alone would crumple it", "[large]") {
    const auto guide = std::make_shared<const Guide>(Surface(stair(2)));
    const Remesh made = remesh(guide, {.cells = 1200});
    CHECK(crumpled_edges(*guide, made.net) == 0);
    const DrapeReport report = measure_drape(guide->surface(), guide->tree(), made.net);
    CHECK(report.coverage > 0.99);
    CHECK(report.mean_distance < 0.05 * report.length);
    CHECK(made.kept.missed() == 0);
    CHECK(made.kept.vertices.empty());  // nobody has wished for them
    for (const SingularVertex& vertex : made.singular) CHECK(vertex.valence == 5);
}
