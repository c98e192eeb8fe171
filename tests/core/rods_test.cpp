// What net lines and corners are like where nothing acts on them, and how stiff, in method `equilibrium`.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "change/change.h"
#include "edit/editor.h"
#include "first_order.h"
#include "net/families.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

Editor editor_of(const Net& net, const std::vector<int>& held, const Settings& settings) {
    Editor editor(net);
    editor.set_method("equilibrium");
    editor.set_handles(samples::handles_at_rest(net, held));
    editor.set_option("max_iterations", "2000");
    for (const auto& [key, value] : settings) editor.set_option(key, value);
    return editor;
}

/// A flat patch whose two families of net lines cross at this angle.
Net sheared_patch(int m, int n, double angle) {
    const Net square = samples::patch(m, n, 0);
    Positions x = square.rest_positions();
    x.row(0) += std::cos(angle) * square.rest_positions().row(1);
    x.row(1) *= std::sin(angle);
    return Net(x, square.faces());
}

/// How far the free end of a heavy patch hangs, whose first two columns are held level.
double droop(const Settings& settings) {
    const int m = 12, n = 3;
    const Net net = samples::patch(m, n, 0);
    std::vector<int> held;
    for (int j = 0; j < n; ++j) held.insert(held.end(), {j * m, j * m + 1});
    Settings all{{"straight_rods", "on"}, {"gravity", "1e-7"}, {"rest_tolerance", "1e-12"}};
    all.insert(all.end(), settings.begin(), settings.end());
    Editor editor = editor_of(net, held, all);
    editor.solve();
    return -editor.positions()(2, m - 1);
}

/// The radius of the circle through three points.
double radius(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const double twice_area = (b - a).cross(c - a).norm();
    return (a - b).norm() * (b - c).norm() * (c - a).norm() / (2 * twice_area);
}

}  // namespace

TEST_CASE("Net lines of a patch and of a torus are of two families, as warp and weft") {
    for (const Net& net : {samples::patch(5, 4), samples::ring(7, 5, true)}) {
        const std::vector<int> families = edge_families(net).value();
        CHECK(families.front() == 0);
        const Topology topology(net);
        for (int f = 0; f < net.face_count(); ++f) {
            const std::span<const int> q = net.faces()[f];
            const auto family = [&](int k) { return families[topology.edge_between(q[k], q[(k + 1) % 4])]; };
            CHECK(family(0) == family(2));
            CHECK(family(1) == family(3));
            CHECK(family(0) != family(1));
        }
    }
}

TEST_CASE("Warp stays warp, and weft weft, in every piece of a net that is cut apart") {
    for (const char* const recipe : {"sheet:vertices=100", "vault:vertices=150", "dome:vertices=150"}) {
        CAPTURE(recipe);
        const Net whole = make_shape(recipe).net;
        const std::vector<int> families = edge_families(whole).value();
        const Topology topology(whole);
        const std::vector<std::vector<int>> lines = topology.net_lines();
        int several = 0;
        for (std::size_t first = 0; first < lines.size(); ++first)
            for (std::size_t second = 0; second < first; second += 3) {
                ChangePlace place;
                for (const std::size_t i : {first, second})
                    for (std::size_t k = 1; k < lines[i].size(); ++k)
                        if (const int e = topology.edge_between(lines[i][k - 1], lines[i][k]);
                            whole.edge_face_counts()[e] == 2)
                            place.edges.push_back(e);
                if (place.edges.empty()) continue;
                const ChangedMesh cut = find_change("cut").make(whole, place);
                const Net parts(cut.mesh.positions, cut.mesh.faces, RestLengths::own);
                several += Topology(parts).component_count() > 2 ? 1 : 0;
                const std::vector<int> after = edge_families(parts).value();
                int swapped = 0;
                for (int e = 0; e < parts.edge_count(); ++e) {
                    const int a = cut.origins[parts.edges()(0, e)], b = cut.origins[parts.edges()(1, e)];
                    swapped += after[e] != families[topology.edge_between(a, b)] ? 1 : 0;
                }
                CHECK(swapped == 0);
            }
        CHECK(several > 10);
    }
}

TEST_CASE("The first edge is of the warp, also where faces begin with a side across it") {
    const Net net = samples::patch(4, 3);
    Faces turned = net.faces();
    for (int f = 0; f < turned.size(); ++f)
        std::rotate(turned.vertices.begin() + 4 * f, turned.vertices.begin() + 4 * f + 1,
                    turned.vertices.begin() + 4 * f + 4);
    CHECK(edge_families(Net(net.rest_positions(), turned)) == edge_families(net));
}

TEST_CASE("Around a vertex of three edges, and beside a triangle, there are no two families") {
    CHECK_FALSE(edge_families(samples::cube()).has_value());
    CHECK_FALSE(edge_families(samples::mixed_mesh()).has_value());
}

TEST_CASE("Rods ten times as stiff droop a tenth as far, and those across do not matter") {
    const double usual = droop({});
    // Three lines, hinged at columns 1 … 10 with springs of energy θ² and so of moment 2 θ, turn by what hangs beyond.
    // A column weighs five edges, three along and two across, the last one three and a half.
    double expected = 0;
    for (int hinge = 1; hinge <= 10; ++hinge) {
        double moment = 0;
        for (int column = hinge + 1; column <= 11; ++column)
            moment += 1e-7 * (column < 11 ? 5 : 3.5) / 3 * (column - hinge);
        expected += moment / 2 * (11 - hinge);
    }
    CHECK(usual == Approx(expected).epsilon(1e-2));
    CHECK(droop({{"warp_stiffness", "10"}}) == Approx(usual / 10).epsilon(1e-3));
    CHECK(droop({{"weft_stiffness", "10"}}) == Approx(usual).epsilon(1e-3));
    CHECK(droop({{"warp_stiffness", "10"}, {"weft_stiffness", "10"}}) ==
          Approx(droop({{"bending_weight", "10"}})).epsilon(1e-6));
}

TEST_CASE("First-order conditions hold for families of different stiffness, bent rods and square corners") {
    const Net net = samples::patch(8, 7);
    for (const Settings& settings :
         {Settings{{"warp_stiffness", "5"}, {"weft_stiffness", "0.2"}}, Settings{{"rod_curvature", "0.1"}},
          Settings{{"square_corners", "on"}}, Settings{{"straight_rods", "on"}, {"warp_stiffness", "3"}}}) {
        CAPTURE(settings.front().first);
        Editor editor = editor_of(net, {0, 7, 48, 55}, settings);
        editor.move_handle(55, net.rest_positions().col(55) + Eigen::Vector3d(-0.7, -0.7, 0.7));
        REQUIRE(editor.solve().status == Status::converged);
        const samples::FirstOrder conditions =
            samples::first_order({net, editor.handles(), editor.options()}, editor.positions());
        CHECK(conditions.gradient < 2 * editor.options().rest_tolerance);
    }
}

TEST_CASE("Where there are no two families their stiffness does not matter") {
    const Net net = samples::cube();
    Editor usual = editor_of(net, {0}, {}), other = editor_of(net, {0}, {{"warp_stiffness", "10"}});
    for (Editor* editor : {&usual, &other}) {
        editor->set_positions(net.rest_positions());
        editor->solve();
    }
    CHECK(usual.positions() == other.positions());
}

TEST_CASE("A free net of rods that were bent beforehand lies on a circle of their curvature, in any unit") {
    const int m = 16;
    for (const double unit : {1.0, 25.0})
        for (const double curvature : {0.12, -0.05}) {
            CAPTURE(unit, curvature);
            const Net strip = samples::patch(m, 2, 0);
            const Net net(unit * strip.rest_positions(), strip.faces());
            Editor editor = editor_of(net, {0}, {{"rod_curvature", std::to_string(curvature / unit)}});
            CHECK(editor.solve().status == Status::converged);
            const Positions& x = editor.positions();
            CHECK(radius(x.col(0), x.col(m / 2), x.col(m - 1)) == Approx(unit / std::abs(curvature)).epsilon(1e-3));
            // To the side that the sign says: faces show their front upwards.
            const Eigen::Vector3d up = Eigen::Vector3d(x.col(1) - x.col(0)).cross(Eigen::Vector3d(x.col(m) - x.col(0)));
            const double height = up.dot(x.col(m - 1) - x.col(0));
            CHECK((height < 0) == (curvature > 0));
        }
}

TEST_CASE("Corners that want to be square become so where nothing holds them") {
    const Net net = sheared_patch(6, 5, 60 * samples::k_degree);
    Editor as_at_rest = editor_of(net, {0}, {{"straight_rods", "on"}});
    as_at_rest.solve();
    CHECK(corner_angle_range(net, as_at_rest.positions()).smallest == Approx(60 * samples::k_degree));
    Editor square = editor_of(net, {0}, {{"straight_rods", "on"}, {"square_corners", "on"}});
    CHECK(square.solve().status == Status::converged);
    CHECK(corner_angle_range(net, square.positions()).smallest == Approx(90 * samples::k_degree).epsilon(1e-3));
}
