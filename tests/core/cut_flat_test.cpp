#include "change/cut_flat.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "change/change.h"
#include "fabricate/flat_pattern.h"
#include "net/repair.h"
#include "net/topology.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

Net of_equal_edges(const Mesh& mesh) { return Net(mesh.positions, mesh.faces, RestLengths::equal); }
Net of_equal_edges(const Net& net) { return of_equal_edges(Mesh{net.rest_positions(), net.faces()}); }

/// What the cut net is, and how it lies.
struct Unfolded {
    Net net;
    FlatPattern pattern;
};

/// Checks that it lies flat, with the faces as they were and every vertex where it was.
Unfolded unfolded(const Net& net) {
    const ChangedMesh cut = cut_flat(net, {});
    REQUIRE(cut.keeps_edges);
    REQUIRE(cut.mesh.faces.size() == net.face_count());
    for (std::size_t corner = 0; corner < net.faces().vertices.size(); ++corner)
        REQUIRE(cut.origins[cut.mesh.faces.vertices[corner]] == net.faces().vertices[corner]);
    for (std::size_t v = 0; v < cut.origins.size(); ++v)
        REQUIRE(cut.mesh.positions.col(static_cast<int>(v)) == net.rest_positions().col(cut.origins[v]));
    Net parted = of_equal_edges(cut.mesh);
    auto laid = flat_pattern(parted, Topology(parted));
    const PatternFault* const fault = std::get_if<PatternFault>(&laid);
    INFO("fault: " << (fault ? to_string(fault->reason) : "none") << ", vertex " << (fault ? fault->vertex : 0)
                   << ", face " << (fault ? fault->face : 0));
    REQUIRE(fault == nullptr);
    return {std::move(parted), std::get<FlatPattern>(laid)};
}

std::string refusal(const Net& net) {
    try {
        cut_flat(net, {});
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::impossible_change);
        return error.what();
    }
    return "";
}

Net moebius_strip(int around, int across) {
    Positions x(3, around * (across + 1));
    Faces faces;
    const auto vertex = [&](int i, int j) {
        return i < around ? i * (across + 1) + j : (i - around) * (across + 1) + across - j;
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j <= across; ++j) {
            const double angle = 2 * EIGEN_PI * i / around, width = static_cast<double>(j) / across - 0.5;
            const double radius = 3 + width * std::cos(angle / 2);
            x.col(vertex(i, j)) << radius * std::cos(angle), radius * std::sin(angle), width * std::sin(angle / 2);
            if (j < across) faces.add({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return Net(x, faces);
}

}  // namespace

TEST_CASE("A tube is cut open along one line, a torus along two, a Moebius strip across") {
    const Unfolded tube = unfolded(of_equal_edges(samples::ring(12, 8, false)));
    CHECK(tube.net.vertex_count() == 13 * 8);
    CHECK(tube.pattern.pieces.size() == 1);
    CHECK(std::minmax(tube.pattern.columns, tube.pattern.rows) == std::minmax(12, 7));

    const Unfolded torus = unfolded(of_equal_edges(samples::ring(12, 8, true)));
    CHECK(torus.net.vertex_count() == 13 * 9);
    CHECK(torus.pattern.pieces.size() == 1);

    const Unfolded strip = unfolded(of_equal_edges(moebius_strip(20, 3)));
    CHECK(strip.net.vertex_count() == 21 * 4);
    CHECK(strip.pattern.pieces.size() == 1);
}

TEST_CASE("A cube is unfolded to six squares in one piece, however fine") {
    Net cube = samples::cube();
    for (int cells = 1; cells <= 8; cells *= 2) {
        const Unfolded flat = unfolded(cube);
        CHECK(flat.pattern.pieces.size() == 1);
        // Five edges of the cube hold the squares together.
        CHECK(flat.net.vertex_count() == 6 * (cells + 1) * (cells + 1) - 5 * (cells + 1));
        cube = of_equal_edges(find_change("refine").make(cube, {}).mesh);
    }
}

TEST_CASE("Every shape lies flat in a few pieces once it is cut, or did before") {
    for (const ShapeInfo& shape : shape_table()) {
        const std::string recipe = std::string(shape.name) + ":vertices=900";
        INFO(recipe);
        const Net net = make_shape(recipe).net;
        if (std::holds_alternative<FlatPattern>(flat_pattern(net, Topology(net)))) {
            CHECK_THAT(refusal(net), Catch::Contains("nothing is to be cut"));
            continue;
        }
        CHECK(unfolded(net).pattern.pieces.size() <= 8);
    }
}

TEST_CASE("What is left of a net when faces go at random lies flat once it is cut") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (const char* const recipe :
         {"teddy:vertices=600", "jack:vertices=400", "torus:vertices=400", "tube:vertices=400"}) {
        const Net net = make_shape(recipe).net;
        for (const double share : {0.02, 0.1, 0.3}) {
            INFO(recipe << " without " << share);
            std::bernoulli_distribution goes(share);
            Faces left;
            for (int f = 0; f < net.face_count(); ++f)
                if (!goes(random)) left.add(net.faces()[f]);
            unfolded(of_equal_edges(repair({net.rest_positions(), left}, {Defect::unused_vertices}).mesh));
        }
    }
}

TEST_CASE("Squares that wind up around a vertex at the border are parted") {
    Positions x(3, 12);
    Faces stair;
    for (int v = 0; v < 12; ++v) x.col(v) << v, v * v, 0;
    for (int i = 0; i < 5; ++i) stair.add({0, 1 + 2 * i, 2 + 2 * i, 3 + 2 * i});
    CHECK(unfolded(Net(x, stair, RestLengths::equal)).pattern.pieces.size() == 2);
}

TEST_CASE("A net that lies flat, and one of other faces than quads, are not cut") {
    CHECK_THAT(refusal(samples::patch(5, 4)), Catch::Contains("lies flat as a square grid as it is"));
    // A pentagon in five quads.
    Positions x(3, 11);
    Faces quads;
    x.col(10).setZero();
    for (int k = 0; k < 5; ++k) {
        const double angle = 2 * EIGEN_PI * k / 5;
        x.col(k) << std::cos(angle), std::sin(angle), 0;
        x.col(5 + k) << std::cos(angle + 0.6), std::sin(angle + 0.6), 0;
        quads.add({10, 5 + (k + 4) % 5, k, 5 + k});
    }
    CHECK(unfolded(Net(x, quads, RestLengths::equal)).pattern.pieces.size() <= 5);
}

TEST_CASE("A net of edges of different lengths lies flat in no pieces") {
    for (const bool is_torus : {false, true}) {
        const Net ring = samples::ring(12, 8, is_torus);
        const Positions wide = Eigen::Vector3d(1, 1.2, 1).asDiagonal() * ring.rest_positions();
        CHECK_THAT(refusal(Net(wide, ring.faces())), Catch::Contains("differ in length"));
    }
}

TEST_CASE("A face alone that is no quad does not lie flat as a square grid") {
    for (const int corners : {3, 5}) {
        Positions x(3, corners);
        std::vector<int> face;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::acos(-1) * k / corners;
            x.col(k) << std::cos(angle), std::sin(angle), 0;
            face.push_back(k);
        }
        Faces faces;
        faces.add(face);
        CHECK_THAT(refusal(Net(x, faces)), Catch::Contains("face 0 is no quad"));
    }
}
