#include "change/change.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "base/error.h"
#include "edit/equalize.h"
#include "net/measures.h"
#include "net/repair.h"
#include "net/topology.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "shapes/shapes.h"
#include "surface/guide.h"

using namespace chebnet;

namespace {

ChangedMesh changed(const Net& net, const char* name, std::vector<int> edges = {}, std::vector<int> vertices = {}) {
    return find_change(name).make(net, {std::move(vertices), std::move(edges)});
}

std::string change_refusal(const Net& net, const char* name, std::vector<int> edges = {},
                           std::vector<int> vertices = {}) {
    try {
        changed(net, name, std::move(edges), std::move(vertices));
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::impossible_change);
        return error.what();
    }
    return "";
}

Net net_of(const ChangedMesh& changed) { return Net(changed.mesh.positions, changed.mesh.faces); }

/// Along these vertices, one after the other.
std::vector<int> path(const Net& net, const std::vector<int>& vertices) {
    const Topology topology(net);
    std::vector<int> edges;
    for (std::size_t k = 0; k + 1 < vertices.size(); ++k)
        edges.push_back(topology.edge_between(vertices[k], vertices[k + 1]));
    return edges;
}

std::vector<int> border(const Net& net) {
    std::vector<int> edges;
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 1) edges.push_back(e);
    return edges;
}

/// Old vertices where they were; what is there is said by `origins`.
void check_origins(const Net& net, const ChangedMesh& changed) {
    REQUIRE(static_cast<Eigen::Index>(changed.origins.size()) == changed.mesh.positions.cols());
    for (std::size_t v = 0; v < changed.origins.size(); ++v)
        if (const int old = changed.origins[v]; old >= 0)
            REQUIRE(changed.mesh.positions.col(static_cast<int>(v)) == net.rest_positions().col(old));
}

/// With those faces wound the other way.
template <class IsTurned>
Net turned_where(const Net& net, IsTurned is_turned) {
    Faces faces = net.faces();
    for (int f = 0; f < faces.size(); ++f)
        if (is_turned(f))
            std::reverse(faces.vertices.begin() + faces.start[f], faces.vertices.begin() + faces.start[f + 1]);
    return Net(net.rest_positions(), faces);
}

/// A strip of 12 by 2 faces whose ends meet upside down: vertex 3 i + j.
Net twisted_strip() {
    constexpr int around = 12, rows = 3;
    Positions x(3, around * rows);
    Faces faces;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < rows; ++j) {
            const double u = 2 * std::numbers::pi * i / around;
            const Eigen::Vector3d outward(std::cos(u), std::sin(u), 0);
            x.col(rows * i + j) =
                2 * outward + (j - 1) * (std::cos(u / 2) * outward + std::sin(u / 2) * Eigen::Vector3d::UnitZ());
            if (j + 1 == rows) continue;
            const auto next = [&](int row) { return i + 1 < around ? rows * (i + 1) + row : rows - 1 - row; };
            faces.add({rows * i + j, next(j), next(j + 1), rows * i + j + 1});
        }
    return Net(x, faces);
}

/// The net without the face whose corners are these, in any order.
Net without_face(const Net& net, const std::set<int>& corners) {
    Faces faces;
    for (int f = 0; f < net.face_count(); ++f)
        if (std::set<int>(net.faces()[f].begin(), net.faces()[f].end()) != corners) faces.add(net.faces()[f]);
    return Net(net.rest_positions(), faces);
}

/// Quads around a hole of five sides, at each corner of which three of them meet: the corners come first, in order.
Net five_sided_hole() {
    Positions x(3, 20);
    Faces faces;
    for (int k = 0; k < 5; ++k) {
        const double angle = 2 * std::numbers::pi * k / 5;
        const auto at = [&](double radius, double turn) {
            return Eigen::Vector3d(radius * std::cos(angle + turn), radius * std::sin(angle + turn), 0);
        };
        x.col(k) = at(1, 0);
        x.col(5 + k) = at(2, 0.2);
        x.col(10 + k) = at(2, -0.2);
        x.col(15 + k) = at(3, 0);
        const int next = (k + 1) % 5;
        faces.add({k, 10 + k, 15 + k, 5 + k});
        faces.add({k, 5 + k, 10 + next, next});
    }
    return Net(x, faces);
}

struct Exact {
    Net net;
    EqualizeReport report;
};

Exact made_exact(const Net& net, const ChangedMesh& changed) {
    EqualizeOptions options;
    options.choice = EqualLength::given;
    options.length = changed.length_factor * net.mean_length();
    Equalizer equalizer(Net(changed.mesh.positions, changed.mesh.faces, RestLengths::own), options);
    const EqualizeReport report = equalizer.solve();
    return {Net(equalizer.positions(), changed.mesh.faces, RestLengths::equal), report};
}

}  // namespace

TEST_CASE("A finer net has four quads for one, and coarsening takes them back") {
    const Net net = GENERATE(samples::patch(5, 4), samples::ring(6, 5, true), samples::cube());
    const ChangedMesh finer = changed(net, "refine");
    check_origins(net, finer);
    const Net fine = net_of(finer);
    CHECK(fine.vertex_count() == net.vertex_count() + net.edge_count() + net.face_count());
    CHECK(fine.face_count() == 4 * net.face_count());
    CHECK(Topology(fine).singular_vertices() == Topology(net).singular_vertices());

    const ChangedMesh coarser = changed(fine, "coarsen");
    check_origins(fine, coarser);
    CHECK(coarser.length_factor * finer.length_factor == 1);
    CHECK(coarser.mesh.positions == net.rest_positions());
    const Net coarse = net_of(coarser);
    CHECK(coarse.edges() == net.edges());
    CHECK(coarse.face_count() == net.face_count());
}

TEST_CASE("A finer net is exact, near the shape that was, and within the limit of corners") {
    const char* recipe = GENERATE("dome:vertices=200", "torus:vertices=200", "jug:vertices=300");
    const Net net = make_shape(recipe).net;
    const Exact exact = made_exact(net, changed(net, "refine"));
    CAPTURE(recipe);
    REQUIRE(exact.report.status == Status::converged);
    CHECK(max_deviation(exact.net, exact.net.rest_positions()) < 1e-9);
    CHECK(exact.net.mean_length() == Approx(net.mean_length() / 2).epsilon(1e-4));
    CHECK(exact.report.smallest_angle >
          std::min(corner_angle_range(net, net.rest_positions()).smallest, std::numbers::pi / 6) - 1e-6);
    REQUIRE(exact.report.distance);
    CHECK(exact.report.distance->largest < 0.5);
}

TEST_CASE("Triangles become four, exact at once or beside quads, larger faces of a net of one length nothing") {
    // A strip of triangles, bent at each edge between two.
    Positions x(3, 8);
    Faces triangles;
    const double height = std::sqrt(3) / 2;
    for (int k = 0; k < 8; ++k) x.col(k) << 0.5 * k, k % 2 * height, 0;
    for (int k = 0; k + 2 < 8; ++k) triangles.add({k, k + 1 + k % 2, k + 2 - k % 2});
    const Net net(x, triangles);
    REQUIRE(net.is_chebyshev());
    const ChangedMesh finer = changed(net, "refine");
    CHECK(finer.keeps_edges);
    check_origins(net, finer);
    const Net fine = net_of(finer);
    CHECK(fine.vertex_count() == net.vertex_count() + net.edge_count());
    CHECK(faces_by_arity(fine.faces()) == std::map<int, int>{{3, 4 * net.face_count()}});
    CHECK(fine.is_chebyshev());
    CHECK(fine.mean_length() == Approx(0.5));
    CHECK(repair(finer.mesh, {}).findings.empty());

    // A quad with a triangle on one side.
    Positions house(3, 5);
    house << 0, 1, 1, 0.5, 0, 0, 0, 1, 1 + height, 1, 0, 0, 0, 0, 0;
    Faces two;
    two.add({0, 1, 2, 4});
    two.add({4, 2, 3});
    const Net mixed(house, two);
    const ChangedMesh parts = changed(mixed, "refine");
    CHECK(faces_by_arity(parts.mesh.faces) == std::map<int, int>{{3, 4}, {4, 4}});
    CHECK(made_exact(mixed, parts).report.status == Status::converged);

    Positions pentagon(3, 5);
    for (int k = 0; k < 5; ++k)
        pentagon.col(k) << std::cos(2 * std::numbers::pi * k / 5), std::sin(2 * std::numbers::pi * k / 5), 0;
    Faces one;
    one.add({0, 1, 2, 3, 4});
    CHECK_THAT(change_refusal(Net(pentagon, one), "refine"), Catch::Contains("face 0 has 5 corners"));
    // With a length each edge keeps what it gets.
    pentagon.row(0) *= 2;
    CHECK(changed(Net(pentagon, one), "refine").mesh.faces.size() == 5);
}

TEST_CASE("Folded lines stay folded in a finer net") {
    const Net net = samples::cube();
    const Positions& x = changed(net, "refine").mesh.positions;
    for (int e = 0; e < net.edge_count(); ++e) {
        const Eigen::Vector3d middle =
            (net.rest_positions().col(net.edges()(0, e)) + net.rest_positions().col(net.edges()(1, e))) / 2;
        CHECK(x.col(net.vertex_count() + e) == middle);
    }
}

TEST_CASE("Coarsening leaves out the odd row at the border, and says where rows make no pairs") {
    const Net odd = samples::patch(6, 5);  // five by four faces
    const ChangedMesh coarser = changed(odd, "coarsen");
    check_origins(odd, coarser);
    CHECK(coarser.mesh.faces.size() == 4);
    CHECK_THAT(change_refusal(samples::ring(7, 5, false), "coarsen"), Catch::Contains("pairs"));
    CHECK_THAT(change_refusal(samples::cube(), "coarsen"), Catch::Contains("pairs"));
    CHECK_THAT(change_refusal(samples::mixed_mesh(), "coarsen"), Catch::Contains("face 0 is no quad"));
    CHECK_THAT(change_refusal(samples::patch(2, 2), "coarsen"), Catch::Contains("nowhere"));
    for (const int rings : {3, 5}) {  // of which squares are left, one face on the other
        const Mesh mesh = samples::quads(4, rings, true, false, [](int i, int j) {
            return Eigen::Vector3d(std::cos(std::numbers::pi / 2 * i), std::sin(std::numbers::pi / 2 * i), j);
        });
        const Net tube(mesh.positions, mesh.faces);
        CHECK_THAT(change_refusal(tube, "coarsen"), Catch::Contains("lie on itself"));
    }
}

TEST_CASE("A cut from border to border makes two pieces, one inside a slit") {
    const Net net = samples::patch(5, 4);  // vertex 5 j + i
    const ChangedMesh parted = changed(net, "cut", path(net, {2, 7, 12, 17}));
    check_origins(net, parted);
    const Net two = net_of(parted);
    CHECK(two.vertex_count() == net.vertex_count() + 4);
    CHECK(Topology(two).component_count() == 2);
    CHECK(std::set<int>(parted.origins.begin() + 20, parted.origins.end()) == std::set<int>{2, 7, 12, 17});
    CHECK(parted.keeps_edges);

    const ChangedMesh slit = changed(net, "cut", path(net, {6, 7, 8}));
    check_origins(net, slit);
    CHECK(slit.origins.back() == 7);
    CHECK(slit.mesh.positions.cols() == net.vertex_count() + 1);
    CHECK(Topology(net_of(slit)).boundary_loops().size() == 2);

    CHECK_THAT(change_refusal(net, "cut", path(net, {6, 7})), Catch::Contains("parts nothing"));
    CHECK_THAT(change_refusal(net, "cut", border(net)), Catch::Contains("parts nothing"));
}

TEST_CASE("Of the sides of a line one stays, and other pieces of the net do") {
    const Net net = samples::patch(6, 4);  // five by three faces
    const std::vector<int> line = path(net, {2, 8, 14, 20});
    CHECK(changed(net, "keep_larger", line).mesh.faces.size() == 9);
    const ChangedMesh smaller = changed(net, "keep_smaller", line);
    check_origins(net, smaller);
    CHECK(smaller.mesh.faces.size() == 6);
    CHECK(net_of(smaller).vertex_count() == 12);

    // Again, in one of the two pieces that the cut made.
    const Net two = net_of(changed(net, "cut", line));
    CHECK(changed(two, "keep_smaller", path(two, {6, 7, 8})).mesh.faces.size() == 15 - 4);
}

TEST_CASE("Of the pieces of a net those at the vertices stay, or go") {
    const Net net = samples::patch(6, 4);  // five by three faces
    const Net two = net_of(changed(net, "cut", path(net, {2, 8, 14, 20})));
    const ChangedMesh left = changed(two, "keep_pieces", {}, {0, 6});
    check_origins(two, left);
    CHECK(left.mesh.faces.size() == 6);
    CHECK(left.keeps_edges);
    CHECK(net_of(left).vertex_count() == 12);
    CHECK(changed(two, "delete_pieces", {}, {0}).mesh.faces.size() == 9);
    CHECK_THAT(change_refusal(two, "keep_pieces"), Catch::Contains("no piece is chosen"));
    for (const char* const name : {"keep_pieces", "delete_pieces"}) {
        CHECK_THAT(change_refusal(net, name, {}, {0}), Catch::Contains("is in one piece"));
        CHECK_THAT(change_refusal(two, name, {}, {0, 5}), Catch::Contains("every piece"));
    }
}

TEST_CASE("Rows and faces are deleted where they are named") {
    const Net net = samples::patch(6, 4);
    const ChangedMesh shorter = changed(net, "delete_rows", path(net, {0, 6, 12, 18}));
    check_origins(net, shorter);
    CHECK(shorter.mesh.faces.size() == 12);
    CHECK(changed(net, "delete_rows", path(net, {1, 7, 13, 19})).mesh.faces.size() == 9);
    CHECK(changed(net, "delete_faces", {}, {0, 8}).mesh.faces.size() == 10);
    CHECK_THAT(change_refusal(net, "delete_faces"), Catch::Contains("no face lies there"));
    std::vector<int> all;
    for (int e = 0; e < net.edge_count(); ++e) all.push_back(e);
    CHECK_THAT(change_refusal(net, "delete_rows", all), Catch::Contains("would be left"));
    CHECK_THAT(change_refusal(net, "keep_larger", path(net, {7, 8})), Catch::Contains("does not part"));
}

TEST_CASE("A row along one side continues the lines that end there, and deleting it brings the net back") {
    const Net net = samples::patch(5, 4, 0);
    const ChangedMesh longer = changed(net, "add_row", path(net, {15, 16, 17, 18, 19}));
    check_origins(net, longer);
    const Net more = net_of(longer);
    CHECK(more.vertex_count() == 25);
    CHECK(more.face_count() == 16);
    CHECK(more.is_chebyshev());
    CHECK(Topology(more).net_lines().size() == Topology(net).net_lines().size() + 1);
    for (int v = 20; v < 25; ++v) CHECK(longer.mesh.positions(1, v) == Approx(4));
    const std::vector<int> outside = {20, 21, 22, 23, 24};
    CHECK(changed(more, "delete_faces", {}, outside).mesh.positions == net.rest_positions());
}

TEST_CASE("A row turns round corners, outwards and inwards") {
    const Net square = samples::patch(3, 3, 0);
    const Net around = net_of(changed(square, "add_row", border(square)));
    CHECK(around.face_count() == 4 * 4);
    CHECK(around.is_chebyshev());
    CHECK(Topology(around).boundary_loops().size() == 1);

    // Five by four faces without the one in a corner: the border turns inwards once.
    const Net corner = net_of(changed(samples::patch(6, 5, 0), "delete_faces", {}, {0}));
    const Net filled = net_of(changed(corner, "add_row", path(corner, {0, 6, 5})));
    CHECK(filled.face_count() == corner.face_count() + 1);
    const Net all_round = net_of(changed(corner, "add_row", border(corner)));
    CHECK(all_round.is_chebyshev());
    CHECK(all_round.face_count() == 7 * 6 - 1);
    CHECK(Topology(all_round).boundary_loops().size() == 1);
}

TEST_CASE("A row that ends in a corner that it fills goes on over that") {
    const Net net = without_face(samples::patch(6, 4, 0), {14, 15, 20, 21});  // a notch in the upper border
    const ChangedMesh longer = changed(net, "add_row", path(net, {19, 20, 14, 15}));
    check_origins(net, longer);
    const Net more = net_of(longer);
    CHECK(more.face_count() == net.face_count() + 3);
    CHECK(more.vertex_count() == net.vertex_count() + 3);
    CHECK(more.is_chebyshev());
    CHECK(Topology(more).boundary_loops().size() == 1);
    CHECK(longer.mesh.positions.rightCols(3).row(1).minCoeff() == Approx(4));

    const Net hole = five_sided_hole();
    CHECK_THAT(change_refusal(hole, "add_row", path(hole, {4, 0, 1})), Catch::Contains("closes on itself"));
}

TEST_CASE("Rows are added at borders alone, and where they have room") {
    CHECK_THAT(change_refusal(samples::ring(6, 5, true), "add_row", {0, 1}), Catch::Contains("lies on the border"));
    const Net touching = net_of(changed(samples::patch(5, 5), "delete_faces", {}, {0, 12}));
    CHECK_THAT(change_refusal(touching, "add_row", border(touching)), Catch::Contains("border"));
}

TEST_CASE("A row is put in inside of the net, and taken out again") {
    const Net net = samples::patch(6, 4, 0);
    const std::vector<int> line = path(net, {3, 9, 15, 21});
    const ChangedMesh wider = changed(net, "insert_row", line);
    REQUIRE(static_cast<Eigen::Index>(wider.origins.size()) == wider.mesh.positions.cols());
    for (std::size_t v = 0; v < wider.origins.size(); ++v)
        CHECK((wider.mesh.positions.col(static_cast<int>(v)) - net.rest_positions().col(wider.origins[v])).norm() <
              0.5 + 1e-12);
    const Net more(wider.mesh.positions, wider.mesh.faces, RestLengths::own);
    CHECK(more.vertex_count() == 28);
    CHECK(more.face_count() == 18);
    CHECK(Topology(more).component_count() == 1);
    CHECK(Topology(more).boundary_loops().size() == 1);
    CHECK(repair(wider.mesh, k_all_defects).findings.empty());

    const Exact exact = made_exact(net, wider);
    REQUIRE(exact.report.status == Status::converged);
    const std::vector<int> again = path(exact.net, {3, 9, 15, 21});
    const ChangedMesh back = changed(exact.net, "remove_line", again);
    CHECK(back.mesh.faces.size() == net.face_count());
    CHECK(back.mesh.positions.cols() == net.vertex_count());
    const Exact as_before = made_exact(net, back);
    REQUIRE(as_before.report.status == Status::converged);
    CHECK(Topology(as_before.net).net_lines().size() == Topology(net).net_lines().size());
}

TEST_CASE("A row goes all round a tube, and a line leaves it") {
    const Net tube = samples::ring(8, 6, false);
    const Topology topology(tube);
    const std::vector<std::vector<int>> lines = topology.net_lines();
    const auto closed = std::find_if(lines.begin(), lines.end(), [&](const std::vector<int>& line) {
        return line.front() == line.back() && !topology.is_boundary(line.front());
    });
    REQUIRE(closed != lines.end());
    const Net longer = net_of(changed(tube, "insert_row", path(tube, *closed)));
    CHECK(longer.vertex_count() == tube.vertex_count() + static_cast<int>(closed->size()) - 1);
    CHECK(Topology(longer).boundary_loops().size() == topology.boundary_loops().size());
    const Net shorter = net_of(changed(tube, "remove_line", path(tube, *closed)));
    CHECK(shorter.vertex_count() == tube.vertex_count() - static_cast<int>(closed->size()) + 1);
    CHECK(Topology(shorter).boundary_loops().size() == topology.boundary_loops().size());
}

TEST_CASE("Rows are put in and taken out also where faces on the two sides are wound unlike each other") {
    const Net alike = samples::patch(5, 4);
    const Net unlike = turned_where(alike, [](int f) { return f % 4 >= 2; });
    const Net strip = twisted_strip();
    for (const char* way : {"insert_row", "remove_line"}) {
        CAPTURE(way);
        const Net expected = net_of(changed(alike, way, path(alike, {2, 7, 12, 17})));
        const Net found = net_of(changed(unlike, way, path(unlike, {2, 7, 12, 17})));
        CHECK(found.edge_count() == expected.edge_count());
        CHECK(edge_length_range(found, found.rest_positions()).longest ==
              Approx(edge_length_range(expected, expected.rest_positions()).longest));
        CHECK(border(found).size() == border(expected).size());
        for (const int column : {0, 5}) {  // the first is where the ends meet
            const Net other = net_of(changed(strip, way, path(strip, {3 * column, 3 * column + 1, 3 * column + 2})));
            CHECK(other.face_count() == strip.face_count() + (way[0] == 'i' ? 2 : -2));
            CHECK(border(other).size() == border(strip).size() + (way[0] == 'i' ? 2 : -2));
            CHECK(Topology(other).boundary_loops().size() == 1);
            CHECK(has_one_side(other.faces()));
        }
    }
}

TEST_CASE("A net of quads alone that a border has cut is made neither finer nor coarser, and gets and loses no rows") {
    const Net whole = samples::patch(9, 9, 0);
    Positions x = whole.rest_positions();
    x.row(0) = x.row(0).cwiseMin(7.15);
    x.row(1) = x.row(1).cwiseMin(7.03);
    const Net cut(x, whole.faces());
    for (const char* way : {"refine", "coarsen"}) CHECK_THAT(change_refusal(cut, way), Catch::Contains("rods are cut"));
    const std::vector<int> across = path(cut, {36, 37, 38, 39, 40, 41, 42, 43, 44});
    for (const char* way : {"insert_row", "remove_line"})
        CHECK_THAT(change_refusal(cut, way, across), Catch::Contains("rods are cut"));
    CHECK_THAT(change_refusal(cut, "add_row", border(cut)), Catch::Contains("rods are cut"));
    // Wider at the border is not cut there.
    x.row(0) = (x.row(0).array() > 7).select(8, whole.rest_positions().row(0));
    x.row(1) = (x.row(1).array() > 7).select(9, whole.rest_positions().row(1));
    CHECK(changed(Net(x, whole.faces()), "refine").mesh.faces.size() == 4 * whole.face_count());
}

TEST_CASE("Where no row can be put in or taken out, the reason is said") {
    const Net net = samples::patch(5, 5);
    for (const char* way : {"insert_row", "remove_line"}) {
        CHECK_THAT(change_refusal(net, way, path(net, {0, 1, 2, 3, 4})), Catch::Contains("on the border"));
        CHECK_THAT(change_refusal(net, way, path(net, {2, 7, 12})), Catch::Contains("ends inside"));
        CHECK_THAT(change_refusal(net, way, path(net, {2, 7, 12, 17, 22, 17, 12, 11, 10})), Catch::Contains("cross"));
        CHECK_THAT(change_refusal(net, way), Catch::Contains("no line"));
    }
    CHECK_THAT(change_refusal(net, "remove_line", path(net, {2, 7, 12, 11, 10})), Catch::Contains("turns"));
    const Mesh mesh = samples::torus(8, 3, 3, 1);  // three around
    const Net torus(mesh.positions, mesh.faces);
    for (const std::vector<int>& line : Topology(torus).net_lines())
        if (line.size() == 8 + 1)
            CHECK_THAT(change_refusal(torus, "remove_line", path(torus, line)), Catch::Contains("lie on itself"));
    // Three quads about one vertex.
    Positions hexagon(3, 7);
    hexagon.col(0).setZero();
    for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3;
        hexagon.col(k + 1) << std::cos(angle), std::sin(angle), 0;
    }
    Faces three;
    for (int k = 0; k < 3; ++k) three.add({0, 1 + 2 * k, 2 + 2 * k, 1 + (2 * k + 2) % 6});
    const Net singular(hexagon, three);
    CHECK_THAT(change_refusal(singular, "remove_line", path(singular, {1, 0, 3})), Catch::Contains("singular"));
    CHECK(changed(singular, "insert_row", path(singular, {1, 0, 3})).mesh.faces.size() == 5);
}

TEST_CASE("Joining takes a cut back, and closes what was brought together") {
    const Net net = samples::patch(5, 4);
    const Net two = net_of(changed(net, "cut", path(net, {2, 7, 12, 17})));
    const ChangedMesh one = changed(two, "join");
    CHECK(one.mesh.positions == net.rest_positions());
    CHECK(one.mesh.faces.vertices == net.faces().vertices);

    Positions moved = two.rest_positions();
    moved.row(2).tail(4).array() += 0.3;
    const ChangedMesh halfway = changed(Net(moved, two.faces()), "join");
    CHECK(halfway.mesh.positions(2, 7) == Approx(net.rest_positions()(2, 7) + 0.15));

    // A sheet whose faces turn the other way, beside one.
    Faces turned = two.faces();
    for (int f = 0; f < turned.size(); ++f)
        if (two.rest_positions()(0, turned[f][0]) + two.rest_positions()(0, turned[f][2]) >
            2 * net.rest_positions()(0, 2))
            std::reverse(turned.vertices.begin() + turned.start[f], turned.vertices.begin() + turned.start[f + 1]);
    CHECK(repair(changed(Net(two.rest_positions(), turned), "join").mesh, k_all_defects).findings.empty());

    CHECK_THAT(change_refusal(net, "join"), Catch::Contains("drag them together"));
    // The border of rods cut short is no two borders.
    Positions trimmed = samples::patch(5, 4, 0).rest_positions();
    trimmed.row(0) = trimmed.row(0).cwiseMin(3.3);
    trimmed.row(1) = trimmed.row(1).cwiseMin(2.2);
    CHECK_THAT(change_refusal(Net(trimmed, net.faces(), RestLengths::own), "join"),
               Catch::Contains("drag them together"));
    Positions doubled(3, 2 * net.vertex_count());
    doubled << net.rest_positions(), net.rest_positions();
    Faces both = net.faces();
    for (int f = 0; f < net.face_count(); ++f) {
        std::vector<int> face(net.faces()[f].begin(), net.faces()[f].end());
        for (int& v : face) v += net.vertex_count();
        both.add(face);
    }
    CHECK(net_of(changed(Net(doubled, both), "join")).vertex_count() == 2 * net.vertex_count() - 14);
}

TEST_CASE("A border of edges that are short beside others is no two borders, and a cut beside it is joined") {
    const Net even = samples::patch(9, 5, 0);
    Positions x = even.rest_positions();
    for (double& along : x.row(0)) along = along < 4 ? 0.02 * along : along - 3.92;
    const Net net(x, even.faces(), RestLengths::own);
    CHECK_THAT(change_refusal(net, "join"), Catch::Contains("drag them together"));
    const Mesh two = changed(net, "cut", path(net, {6, 15, 24, 33, 42})).mesh;
    CHECK(two.positions.cols() == net.vertex_count() + 5);
    CHECK(changed(Net(two.positions, two.faces, RestLengths::own), "join").mesh.positions == x);
}

TEST_CASE("Borders that would meet three at an edge are not joined, which is said without numbers of what would be") {
    Mesh mesh{Positions(3, 12), {}};
    for (int sheet = 0; sheet < 3; ++sheet) {
        const double angle = 2 * std::numbers::pi * sheet / 3;
        const Eigen::Vector3d away(std::cos(angle), std::sin(angle), 0), up = Eigen::Vector3d::UnitZ();
        mesh.positions.middleCols(4 * sheet, 4) << 0.1 * away, 0.1 * away + up, 1.1 * away + up, 1.1 * away;
        mesh.faces.add({4 * sheet, 4 * sheet + 1, 4 * sheet + 2, 4 * sheet + 3});
    }
    CHECK(change_refusal(Net(mesh.positions, mesh.faces), "join") ==
          "these borders do not fit together: more than two faces would meet at an edge");
}

TEST_CASE("A longer net is exact and within the limit of corners") {
    const Net net = make_shape("dome:vertices=300").net;
    const Exact exact = made_exact(net, changed(net, "add_row", border(net)));
    REQUIRE(exact.report.status == Status::converged);
    CHECK(max_deviation(exact.net, exact.net.rest_positions()) < 1e-9);
    CHECK(exact.report.smallest_angle > std::numbers::pi / 6 - 1e-6);
}

TEST_CASE("What a change is asked for is checked") {
    const Net net = samples::patch(3, 3);
    CHECK_THROWS_WITH(changed(net, "cut", {12}), Catch::Contains("no edge 12"));
    CHECK_THROWS_WITH(changed(net, "delete_faces", {}, {-1}), Catch::Contains("no vertex -1"));
    CHECK_THROWS_WITH(find_change("melt"), Catch::Contains("\"melt\""));
}
