
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <map>
#include <set>

#include "base/angle.h"
#include "base/error.h"
#include "net/measures.h"
#include "net/topology.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

Positions unit_square() {
    Positions x(3, 4);
    x << 0, 1, 1, 0,  //
        0, 0, 1, 1,   //
        0, 0, 0, 0;
    return x;
}

Faces one_face(std::initializer_list<int> face) {
    Faces faces;
    faces.add(face);
    return faces;
}

ErrorCode code_of(const Positions& x, const Faces& faces, std::string* message = nullptr) {
    try {
        Net net(x, faces);
    } catch (const Error& error) {
        if (message != nullptr) *message = error.what();
        return error.code();
    }
    FAIL("the net was accepted");
    return {};
}

using Lines = std::set<std::vector<int>>;

/// Each from its smaller end; a closed one, which has none, from its smallest vertex to the smaller neighbour.
Lines net_lines(const Net& net) {
    Lines lines;
    for (std::vector<int>& line : Topology(net).net_lines()) {
        if (line.front() == line.back()) {
            line.pop_back();
            std::rotate(line.begin(), std::min_element(line.begin(), line.end()), line.end());
            line.push_back(line.front());
        }
        const std::vector<int> backwards(line.rbegin(), line.rend());
        lines.insert(std::min(line, backwards));
    }
    return lines;
}

}  // namespace

TEST_CASE("A net refuses what is not sound, and names it") {
    std::string message;
    Positions x = unit_square();

    CHECK(code_of(x, Faces()) == ErrorCode::no_faces);
    CHECK(code_of(x, one_face({0, 1})) == ErrorCode::small_face);
    CHECK(code_of(x, one_face({0, 1, 2, 4}), &message) == ErrorCode::index_out_of_range);
    CHECK(message == "face 0 names vertex 4, but vertices go from 0 to 3");
    CHECK(code_of(x, one_face({0, 1, 2, -1})) == ErrorCode::index_out_of_range);
    CHECK(code_of(x, one_face({0, 1, 2, 1}), &message) == ErrorCode::repeated_vertex);
    CHECK(message == "face 0 names vertex 1 twice");
    CHECK(code_of(x, one_face({0, 1, 2}), &message) == ErrorCode::unused_vertex);
    CHECK(message == "vertex 3 belongs to no face");

    x.col(2) = x.col(1);
    CHECK(code_of(x, one_face({0, 1, 2, 3}), &message) == ErrorCode::zero_length_edge);
    CHECK(message == "edge 1–2 has length zero");
    x(1, 3) = std::numeric_limits<double>::quiet_NaN();
    CHECK(code_of(x, one_face({0, 1, 2, 3}), &message) == ErrorCode::non_finite);
    CHECK(message == "vertex 3 has a coordinate that is not finite");
}

TEST_CASE("An edge with three faces is refused by name") {
    Positions x(3, 5);
    x << 0, 1, 0, 0, 0,  //
        0, 0, 1, -1, 0,  //
        0, 0, 0, 0, 1;
    Faces faces;
    faces.add({0, 1, 2});
    faces.add({1, 0, 3});
    faces.add({0, 1, 4});
    std::string message;
    CHECK(code_of(x, faces, &message) == ErrorCode::non_manifold_edge);
    CHECK(message == "edge 0–1 has 3 faces, more than two");
}

TEST_CASE("Edges are unique, ordered, and as many as Euler says") {
    const int m = GENERATE(2, 5, 9), n = GENERATE(2, 4);
    const Net net = samples::patch(m, n);
    REQUIRE(net.vertex_count() - net.edge_count() + net.face_count() == 1);
    for (int e = 0; e < net.edge_count(); ++e) {
        CHECK(net.edges()(0, e) < net.edges()(1, e));
        if (e > 0) {
            const bool ascending =
                net.edges()(0, e - 1) < net.edges()(0, e) ||
                (net.edges()(0, e - 1) == net.edges()(0, e) && net.edges()(1, e - 1) < net.edges()(1, e));
            CHECK(ascending);
        }
    }
}

TEST_CASE("Rest lengths: one for a Chebyshev net, each edge its own otherwise") {
    const Net net = samples::patch(6, 5);
    CHECK(net.is_chebyshev());
    CHECK(net.rest_lengths().isApproxToConstant(1.0, 1e-14));

    const Net mixed = samples::mixed_mesh();
    CHECK_FALSE(mixed.is_chebyshev());
    CHECK(max_deviation(mixed, mixed.rest_positions()) == 0);

    const Net forced(mixed.rest_positions(), mixed.faces(), RestLengths::equal);
    CHECK(forced.rest_lengths().isApproxToConstant(mixed.mean_length(), 1e-14));
}

TEST_CASE("Topology of open, closed and separate pieces") {
    const Net open = samples::patch(5, 4);
    const Topology of_open(open);
    const auto loops = of_open.boundary_loops();
    REQUIRE(loops.size() == 1);
    CHECK(loops[0].size() == 2 * (5 + 4) - 4);
    CHECK(of_open.component_count() == 1);
    CHECK(of_open.singular_vertices().empty());

    const Net closed = samples::cube();
    const Topology of_closed(closed);
    CHECK(of_closed.boundary_loops().empty());
    CHECK(of_closed.singular_vertices() == std::map<int, int>{{3, 8}});

    Positions x(3, 8);
    x << unit_square(), unit_square().colwise() + Eigen::Vector3d(5, 0, 0);
    Faces faces = one_face({0, 1, 2, 3});
    faces.add({4, 5, 6, 7});
    const Net two(x, faces);
    const Topology of_two(two);
    CHECK(of_two.component_count() == 2);
    std::vector<bool> is_marked(8, false);
    CHECK(of_two.in_pieces_without(is_marked) == std::vector<bool>(8, true));
    is_marked[6] = true;
    CHECK(of_two.in_pieces_without(is_marked) == std::vector<bool>{true, true, true, true, false, false, false, false});
    CHECK(of_two.boundary_loops().size() == 2);
    CHECK(std::isinf(of_two.distances_from(0)[4]));
}

TEST_CASE("Two quads that touch in one vertex have a boundary loop each, and no net line in common") {
    Positions x(3, 7);
    x << 0, 1, 1, 0, 2, 2, 1,  //
        0, 0, 1, 1, 1, 2, 2,   //
        0, 0, 0, 0, 0, 0, 0;
    Faces faces = one_face({0, 1, 2, 3});
    faces.add({2, 4, 5, 6});
    const Net net(x, faces);
    const auto loops = Topology(net).boundary_loops();
    REQUIRE(loops.size() == 2);
    CHECK(loops[0].size() == 4);
    CHECK(loops[1].size() == 4);
    CHECK(net_lines(net).size() == 8);
}

TEST_CASE("Every edge of a net lies on exactly one net line") {
    const auto lies_on_one = [](const Net& net) {
        std::vector<std::pair<int, int>> steps, edges;
        for (const std::vector<int>& line : Topology(net).net_lines())
            for (std::size_t k = 1; k < line.size(); ++k) steps.push_back(std::minmax(line[k - 1], line[k]));
        for (int e = 0; e < net.edge_count(); ++e) edges.emplace_back(net.edges()(0, e), net.edges()(1, e));
        std::sort(steps.begin(), steps.end());
        return steps == edges;
    };
    for (const ShapeInfo& shape : shape_table()) {
        INFO(shape.name);
        CHECK(lies_on_one(make_shape(shape.name).net));
    }
    CHECK(lies_on_one(samples::mixed_mesh()));
}

TEST_CASE("The net lines of a patch are its rows and columns, from end to end") {
    const int m = GENERATE(2, 5), n = GENERATE(2, 4);
    Lines rows_and_columns;
    for (int j = 0; j < n; ++j) {
        std::vector<int> row;
        for (int i = 0; i < m; ++i) row.push_back(j * m + i);
        rows_and_columns.insert(row);
    }
    for (int i = 0; i < m; ++i) {
        std::vector<int> column;
        for (int j = 0; j < n; ++j) column.push_back(j * m + i);
        rows_and_columns.insert(column);
    }
    CHECK(net_lines(samples::patch(m, n)) == rows_and_columns);
}

TEST_CASE("Net lines around a tube and a torus are closed") {
    const int around = 6, along = 4;
    const auto lengths = [&](bool closed) {
        const Net net = samples::ring(around, along, closed);
        std::map<std::pair<bool, std::size_t>, int> counts;
        for (const std::vector<int>& line : Topology(net).net_lines()) {
            const bool is_closed = line.front() == line.back();
            ++counts[{is_closed, line.size() - 1}];
            // No vertex comes twice but the one that closes it.
            CHECK(std::set<int>(line.begin(), line.end()).size() == line.size() - is_closed);
        }
        return counts;
    };
    CHECK(lengths(false) ==
          std::map<std::pair<bool, std::size_t>, int>{{{true, around}, along}, {{false, along - 1}, around}});
    CHECK(lengths(true) ==
          std::map<std::pair<bool, std::size_t>, int>{{{true, around}, along}, {{true, along}, around}});
}

TEST_CASE("Net lines end at singular vertices and corners, and follow the boundary between") {
    // n faces around vertex 0: spokes to 1 … n, and, if they are quads, corners n + 1 … 2n between these.
    const auto fan = [](int n, bool quads) {
        Positions x = Positions::Zero(3, (quads ? 2 : 1) * n + 1);
        Faces faces;
        for (int i = 0; i < n; ++i) {
            const auto at = [&](double turn) { return Eigen::Vector3d(std::cos(turn), std::sin(turn), 0); };
            const int spoke = 1 + i, next_spoke = 1 + (i + 1) % n, corner = n + 1 + i;
            x.col(spoke) = at(2 * EIGEN_PI * i / n);
            if (quads) x.col(corner) = 1.5 * at(2 * EIGEN_PI * (i + 0.5) / n);
            if (quads)
                faces.add({0, spoke, corner, next_spoke});
            else
                faces.add({0, spoke, next_spoke});
        }
        return Net(x, faces);
    };
    CHECK(net_lines(fan(3, true)) == Lines{{0, 1}, {0, 2}, {0, 3}, {4, 1, 6}, {4, 2, 5}, {5, 3, 6}});
    // A regular vertex lets both lines through.
    CHECK(net_lines(fan(4, true)) == Lines{{1, 0, 3}, {2, 0, 4}, {5, 1, 8}, {5, 2, 6}, {6, 3, 7}, {7, 4, 8}});
    CHECK(net_lines(fan(5, true)).count({0, 1}) == 1);
    // Triangles: the boundary is one closed line.
    CHECK(net_lines(fan(6, false)) == Lines{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}, {0, 6}, {1, 2, 3, 4, 5, 6, 1}});
    // Triangles around a vertex: their outer edges are one line all round, all others end.
    const Net six = fan(6, false);
    const Topology around_six(six);
    for (const std::vector<int>& line : around_six.net_lines()) CHECK(around_six.is_closed(line) == (line.size() > 2));
    // On a cube every vertex is singular.
    for (const std::vector<int>& line : net_lines(samples::cube())) CHECK(line.size() == 2);
}

TEST_CASE("At an inward corner net lines end, or pass by the edge that has two faces") {
    // Three quads about vertex 4.
    Positions x(3, 8);
    x << 0, 1, 2, 0, 1, 2, 0, 1,  //
        0, 0, 0, 1, 1, 1, 2, 2,   //
        0, 0, 0, 0, 0, 0, 0, 0;
    Faces faces = one_face({0, 1, 4, 3});
    faces.add({1, 2, 5, 4});
    faces.add({3, 4, 7, 6});
    const Net net(x, faces);
    CHECK(net_lines(net) == Lines{{0, 1, 2}, {0, 3, 6}, {1, 4}, {2, 5}, {3, 4}, {4, 5}, {4, 7}, {6, 7}});
    const Topology topology(net);
    const auto passing = topology.net_lines(InwardCorners::pass);
    CHECK(Lines(passing.begin(), passing.end()) == Lines{{0, 1, 2}, {0, 3, 6}, {1, 4, 7}, {2, 5}, {3, 4, 5}, {6, 7}});

    // Folded along 3-4-5, two of the four pairs of edges through which lines go are bent.
    const double phi = 0.4;
    Positions folded = x;
    for (const int v : {6, 7}) folded.col(v) << x(0, v), 1 + std::cos(phi), std::sin(phi);
    CHECK(bend(net, topology, folded) == Approx(2 * std::sin(phi / 2) / std::sqrt(2.0)));
}

TEST_CASE("A line that passes an inward corner is closed there only if it goes straight on") {
    // A ring of quads, and outside of it first one at an edge, then another beside that: vertex 6 has three, then four.
    const int around = 6;
    Positions x = Positions::Zero(3, 16);
    Faces faces;
    for (int k = 0; k < around; ++k) {
        const double angle = 2 * EIGEN_PI * k / around;
        for (int row = 0; row < 2; ++row)
            x.col(row * around + k) << (1 + row) * std::cos(angle), (1 + row) * std::sin(angle), 0;
        const int next = (k + 1) % around;
        faces.add({k, next, around + next, around + k});
    }
    x.col(12) << 2, 3, 0;
    x.col(13) << 3, 1, 0;
    x.col(14) << 4, 0, 0;
    x.col(15) << 3, -1, 0;
    for (const bool has_second : {false, true}) {
        CAPTURE(has_second);
        Faces some = faces;
        some.add({6, 7, 12, 13});
        if (has_second) some.add({6, 13, 14, 15});
        const Net net(x.leftCols(has_second ? 16 : 14), some, RestLengths::own);
        const Topology topology(net);
        int loops = 0, closed = 0;
        for (const std::vector<int>& line : topology.net_lines(InwardCorners::pass)) {
            loops += line.front() == line.back() ? 1 : 0;
            closed += topology.is_closed(line, topology.straight_on(InwardCorners::pass)) ? 1 : 0;
        }
        CHECK(loops == 2);
        CHECK(closed == (has_second ? 1 : 2));
    }
}

TEST_CASE("Distance along a patch of unit edges is the number of steps") {
    const Net net = samples::patch(7, 5);
    const Topology topology(net);
    const std::vector<double> distance = topology.distances_from(0);
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 7; ++i) CHECK(distance[j * 7 + i] == Approx(i + j));
}

TEST_CASE("Deviation is eq. 1 without its cancellation") {
    CHECK(deviation(1) == 0);
    CHECK(deviation(2) == Approx(2 + 0.5 - 2));
    CHECK(deviation(1 + 1e-9) == Approx(1e-18).epsilon(1e-6));
    CHECK(std::isinf(deviation(0)));
}

TEST_CASE("Fairness and angles do not see rigid motions, and do see bending") {
    const Net net = samples::patch(6, 6, 0.3);
    const Topology topology(net);
    const Eigen::AngleAxisd turn(1.1, Eigen::Vector3d(1, 2, 3).normalized());
    const Positions moved = (turn.toRotationMatrix() * net.rest_positions()).colwise() + Eigen::Vector3d(4, -5, 6);
    CHECK(bend(net, topology, moved) == Approx(0).margin(1e-12));
    CHECK(max_deviation(net, moved) < 1e-24);
    const AngleRange before = corner_angle_range(net, net.rest_positions()), after = corner_angle_range(net, moved);
    CHECK(after.smallest == Approx(before.smallest));
    CHECK(after.largest == Approx(before.largest));

    // Folding a flat strip by an angle φ across one line changes ‖x_a − 2x + x_b‖ there from 0 to 2 sin(φ/2).
    const Net strip = samples::patch(3, 2, 0);
    const double phi = 0.4;
    Positions folded = strip.rest_positions();
    for (int v : {2, 5}) folded.col(v) = folded.col(v - 1) + Eigen::Vector3d(std::cos(phi), 0, std::sin(phi));
    // Both ends of the fold line have valence 3 and one straight pair each.
    CHECK(bend(strip, Topology(strip), folded) == Approx(2 * std::sin(phi / 2)));
}

TEST_CASE("The corner angle of a vertex is the one farthest from a right angle") {
    const double shear = GENERATE(0.3, 1.0, 2.5);
    Positions x = unit_square();
    x.col(2) = x.col(1) + Eigen::Vector3d(std::cos(shear), std::sin(shear), 0);
    x.col(3) = x.col(0) + Eigen::Vector3d(std::cos(shear), std::sin(shear), 0);
    const Net rhombus(x, one_face({0, 1, 2, 3}));
    const Eigen::VectorXd angles = vertex_corner_angles(rhombus, x);
    CHECK(angles[0] == Approx(shear));
    CHECK(angles[1] == Approx(EIGEN_PI - shear));
}

TEST_CASE("A triangle beside quads says nothing of shear") {
    Positions x(3, 5);
    x << unit_square(), Eigen::Vector3d(1.2, 0.5, 0);
    Faces faces = one_face({0, 1, 2, 3});
    faces.add({1, 4, 2});
    const Eigen::VectorXd angles = vertex_corner_angles(Net(x, faces, RestLengths::own), x);
    for (int v = 0; v < 5; ++v) CHECK(angles[v] == Approx(EIGEN_PI / 2));
    const Positions alone = x.rightCols(3);
    CHECK(vertex_corner_angles(Net(alone, one_face({0, 1, 2}), RestLengths::own), alone).maxCoeff() > 1.9);
}

TEST_CASE("A net tells its shortest and longest edge, and how far they are from the mean") {
    Positions kite = unit_square();
    kite.row(1) *= 3;
    const Net net(kite, one_face({0, 1, 2, 3}), RestLengths::own);
    const LengthRange range = edge_length_range(net, net.rest_positions());
    CHECK(range.shortest == 1);
    CHECK(range.longest == 3);
    CHECK(max_deviation_from_mean(net) == deviation(0.5));
    CHECK(max_deviation(net, net.rest_positions()) == 0);
    CHECK(max_deviation_from_mean(Net(unit_square(), one_face({0, 1, 2, 3}))) == 0);
    const LengthRange grown = edge_length_range(net, net.rest_positions() * 1e145);
    CHECK(grown.longest == Approx(3e145));
}

TEST_CASE("Faces are counted by their corners") {
    Faces faces = one_face({0, 1, 2, 3});
    CHECK(faces_by_arity(Faces{}).empty());
    faces.add({4, 3, 2});
    faces.add({4, 5, 6});
    CHECK(faces_by_arity(faces) == std::map<int, int>{{3, 2}, {4, 1}});
}

namespace {

/// Two squares that fold by so many degrees at their common edge.
Positions hinge(double fold) {
    const double c = std::cos(fold * k_degree), s = std::sin(fold * k_degree);
    Positions x(3, 6);
    x << 0, 1, 1, 0, 1 + c, 1 + c,  //
        0, 0, 1, 1, 0, 1,           //
        0, 0, 0, 0, s, s;
    return x;
}

}  // namespace

TEST_CASE("Edges are counted at which faces fold by more than an angle, however faces are wound") {
    for (const double fold : {0., 50., 60., 60.05, 70., 179.})
        for (const bool is_wound_alike : {true, false}) {
            const Positions x = hinge(fold);
            Faces faces;
            faces.add(std::vector{0, 1, 2, 3});
            faces.add(is_wound_alike ? std::vector{1, 4, 5, 2} : std::vector{2, 5, 4, 1});
            const Net net(x, faces);
            CHECK(sharp_folds(net, x, 60 * k_degree) == (fold > 60.1 ? 1 : 0));
        }
}

TEST_CASE("Folds are new where a net folds by 60 degrees more than before, and no less than where it was rough") {
    Faces faces = one_face({0, 1, 2, 3});
    faces.add({1, 4, 5, 2});
    const Net net(hinge(0), faces);
    CHECK(new_folds(net, hinge(0), hinge(59)) == 0);
    CHECK(new_folds(net, hinge(0), hinge(61)) == 1);
    CHECK(new_folds(net, hinge(70), hinge(110)) == 0);
    CHECK(new_folds(net, hinge(70), hinge(131)) == 1);
    CHECK(new_folds(net, hinge(90), hinge(0)) == 0);
}
