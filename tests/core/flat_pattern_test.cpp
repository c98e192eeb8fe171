#include "fabricate/flat_pattern.h"

#include <array>
#include <catch2/catch.hpp>
#include <set>
#include <utility>

#include "io/obj.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

using Reason = PatternFault::Reason;

Net net_of(const std::string& obj) {
    Mesh mesh = read_obj(obj, "test");
    return Net(std::move(mesh.positions), std::move(mesh.faces));
}

/// Five squares around one boundary vertex: the fifth would lie upon the first.
Net winding_stair() {
    Positions positions(3, 12);
    Faces faces;
    for (int v = 0; v < 12; ++v) positions.col(v) << v, v * v, 0;
    for (int i = 0; i < 5; ++i) faces.add({0, 1 + 2 * i, 2 + 2 * i, 3 + 2 * i});
    return Net(std::move(positions), std::move(faces), RestLengths::equal);
}

FlatPattern pattern_of(const Net& net) { return std::get<FlatPattern>(flat_pattern(net, Topology(net))); }
PatternFault fault_of(const Net& net) { return std::get<PatternFault>(flat_pattern(net, Topology(net))); }

const std::string k_square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

}  // namespace

TEST_CASE("A vault's flat pattern is the square grid it was bent from") {
    const Net net = make_shape("vault:vertices=300").net;
    const FlatPattern pattern = pattern_of(net);
    CHECK((pattern.columns + 1) * (pattern.rows + 1) == net.vertex_count());
    std::set<std::pair<int, int>> taken;
    for (const auto& place : pattern.places.colwise()) {
        CHECK((place.x() >= 0 && place.x() <= pattern.columns && place.y() >= 0 && place.y() <= pattern.rows));
        taken.emplace(place.x(), place.y());
    }
    CHECK(static_cast<int>(taken.size()) == net.vertex_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto step = pattern.places.col(net.edges()(0, e)) - pattern.places.col(net.edges()(1, e));
        CHECK(step.cwiseAbs().sum() == 1);
    }
}

TEST_CASE("A flat pattern shows the front of the faces") {
    const Net net = samples::patch(5, 4);
    const FlatPattern pattern = pattern_of(net);
    for (int f = 0; f < net.face_count(); ++f) {
        const auto side = [&](int k) -> Eigen::Vector2i {
            return pattern.places.col(net.faces()[f][k]) - pattern.places.col(net.faces()[f][0]);
        };
        CHECK(side(1).x() * side(3).y() - side(1).y() * side(3).x() == 1);
    }
}

TEST_CASE("A net without a flat pattern says why") {
    CHECK(fault_of(make_shape("jack").net).reason == Reason::singular);
    CHECK(fault_of(make_shape("torus").net).reason == Reason::closed);
    CHECK(fault_of(make_shape("tube").net).reason == Reason::closed);
    CHECK(fault_of(net_of("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n")).reason == Reason::unequal);
    CHECK(fault_of(net_of(k_square + "v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5 1 0\nf 5 6 7 8\n")).reason == Reason::pieces);
    const PatternFault cut = fault_of(net_of(k_square + "v 2 0.5 0\nf 2 5 3\n"));
    CHECK(cut.reason == Reason::not_quads);
    CHECK(cut.face == 1);
    const PatternFault stair = fault_of(winding_stair());
    CHECK(stair.reason == Reason::overlap);
    CHECK(stair.face == 4);
}

TEST_CASE("A singular vertex without a place on the grid is named") {
    const Net net = make_shape("jack").net;
    const Topology topology(net);
    const int vertex = fault_of(net).vertex;
    CHECK_FALSE(topology.is_boundary(vertex));
    CHECK(topology.valence(vertex) != 4);
}
