// Lines of a net that exact handles pull straight, and so hold.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "edit/editor.h"
#include "edit/net_forces.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

constexpr int k_columns = 12, k_rows = 9, k_last = k_columns * k_rows - 1;
constexpr int k_sheet_corners[] = {0, k_columns - 1, k_last - k_columns + 1, k_last};
const Eigen::Vector3d k_inwards_and_up(-1.5, -1, 2);

/// A flat sheet that is held at its four corners.
Editor held_sheet() {
    Editor editor(samples::patch(k_columns, k_rows, 0));
    editor.set_method("equilibrium");
    editor.set_handles(
        samples::handles_at_rest(editor.net(), {std::begin(k_sheet_corners), std::end(k_sheet_corners)}));
    return editor;
}

/// Of a sheet whose last corner goes so far in so many frames.
Editor dragged_sheet(const Eigen::Vector3d& move, int frames) {
    Editor editor = held_sheet();
    const Eigen::Vector3d from = editor.handles().back().target;
    for (int frame = 1; frame <= frames; ++frame) {
        editor.move_handle(k_last, from + static_cast<double>(frame) / frames * move);
        CHECK(editor.solve().status == Status::converged);
    }
    return editor;
}

/// A flat sheet of rhombi whose handles are nearly as far apart as it lets them; a net, but not at rest.
Editor nearly_taut_sheet() {
    constexpr int k_side = 5;
    const double angle = -0.40119608161154535;
    Positions x(3, k_side * k_side);
    for (int v = 0; v < x.cols(); ++v) {
        const int row = v / k_side;
        x.col(v) << v % k_side + row * std::sin(angle), row * std::cos(angle), 0;
    }
    Editor editor(Net(x, samples::patch(k_side, k_side).faces()));
    editor.set_method("projection");
    editor.set_handles(samples::handles_at_rest(editor.net(), {14, 6, 9, 23}));
    editor.solve();
    editor.move_handle(14, {2.9940494056697262, 1.6800610414723229, -0.21083100047249678});
    REQUIRE(editor.solve().status == Status::converged);
    editor.set_method("equilibrium");
    return editor;
}

std::vector<int> vertices_of(std::span<const TautVertex> taut) {
    std::vector<int> vertices;
    for (const TautVertex& each : taut) vertices.push_back(each.vertex);
    std::sort(vertices.begin(), vertices.end());
    return vertices;
}

}  // namespace

TEST_CASE("Corners as far apart as the sheet is long hold the borders between them, evenly spaced") {
    Editor editor = held_sheet();
    REQUIRE(editor.solve().status == Status::converged);
    CHECK(editor.taut_vertices().size() == k_columns * k_rows - 4);  // the borders, and what they hold between them
    editor.move_handle(k_last, editor.handles().back().target + k_inwards_and_up);
    REQUIRE(editor.solve().status == Status::converged);
    std::vector<int> expected;
    for (int v = 1; v < k_columns - 1; ++v) expected.push_back(v);
    for (int row = 1; row < k_rows - 1; ++row) expected.push_back(row * k_columns);
    CHECK(vertices_of(editor.taut_vertices()) == expected);
    for (int v = 0; v < k_columns; ++v) CHECK((editor.positions().col(v) - Eigen::Vector3d(v, 0, 0)).norm() < 1e-12);
    CHECK(max_deviation(editor.net(), editor.positions()) < 1e-12);
}

TEST_CASE("All of a large sheet is held by its corners, too") {
    const Net net = samples::patch(110, 110, 0);
    Editor editor(net);
    editor.set_handles(samples::handles_at_rest(net, {0, 109, 110 * 109, 110 * 110 - 1}));
    editor.set_option("gravity", "0.01");
    CHECK(editor.solve().status == Status::converged);
    CHECK(static_cast<int>(editor.taut_vertices().size()) == net.vertex_count() - 4);
    CHECK(editor.positions() == net.rest_positions());
}

TEST_CASE("A sheet whose corner is drawn in has one shape, whatever the hand did") {
    const Editor slow = dragged_sheet(k_inwards_and_up, 30), quick = dragged_sheet(k_inwards_and_up, 1);
    CHECK((slow.positions() - quick.positions()).colwise().norm().maxCoeff() < 1e-3);
}

TEST_CASE("A line that is let go sags, and one that is drawn straight again is held again") {
    Editor editor = held_sheet();
    const Eigen::Vector3d corner = editor.handles()[1].target;
    editor.set_handles({editor.handles()[0], editor.handles()[1]});
    REQUIRE(editor.solve().status == Status::converged);
    CHECK(editor.taut_vertices().size() == k_columns - 2);
    editor.move_handle(k_columns - 1, corner - Eigen::Vector3d(0.5, 0, 0));
    CHECK(keeps_lengths(editor.solve().status));
    CHECK(editor.taut_vertices().empty());
    editor.move_handle(k_columns - 1, corner);
    REQUIRE(keeps_lengths(editor.solve().status));
    // Between the two the net is straight in any case; how soon it is known to be may depend on the way.
    for (int frame = 0; frame < 3; ++frame) {
        editor.move_handle(k_columns - 1, corner);
        editor.solve();
    }
    for (int v = 0; v < k_columns; ++v) CHECK((editor.positions().col(v) - Eigen::Vector3d(v, 0, 0)).norm() < 0.01);
    CHECK(editor.taut_vertices().size() == k_columns - 2);
}

TEST_CASE("A hand draws nothing out of a sheet that is held taut, however small the steps") {
    Editor editor = held_sheet();
    constexpr int k_middle = 4 * k_columns + 5;
    std::vector<Handle> handles = editor.handles();
    const Eigen::Vector3d from = editor.net().rest_positions().col(k_middle);
    handles.push_back({k_middle, from});
    editor.set_handles(handles);
    REQUIRE(editor.solve().status == Status::converged);
    double deviation = 0, height = 0;
    for (int frame = 1; frame <= 40; ++frame) {
        editor.drag_handle(k_middle, from + Eigen::Vector3d(0, 0, 0.05 * frame));
        CHECK(keeps_lengths(editor.solve().status));
        deviation = std::max(deviation, max_deviation(editor.net(), editor.positions()));
        height = std::max(height, editor.positions().row(2).cwiseAbs().maxCoeff());
    }
    CHECK(deviation < 1e-9);
    CHECK(height < 0.01);
}

TEST_CASE("What a taut line bears stands on the handles that hold it") {
    Editor editor = dragged_sheet(k_inwards_and_up, 1);
    editor.set_option("gravity", "0.01");
    editor.set_option("rest_tolerance", "1e-6");
    REQUIRE(editor.solve().status == Status::converged);
    REQUIRE_FALSE(editor.taut_vertices().empty());
    const std::optional<NetForces> forces = net_forces(editor);
    REQUIRE(forces);
    const Eigen::Vector3d sum = forces->handles.rowwise().sum(), weight(0, 0, 0.01 * editor.net().edge_count());
    CHECK((sum - weight).norm() < 1e-4);
}

TEST_CASE("A line with a soft handle on it is not held, nor are lines of methods that know nothing of rest") {
    Editor editor = held_sheet();
    std::vector<Handle> handles = editor.handles();
    handles.push_back({k_columns / 2, Eigen::Vector3d(k_columns / 2, 0, 1), 1});
    editor.set_handles(handles);
    editor.solve();
    for (const TautVertex& taut : editor.taut_vertices()) CHECK(taut.vertex >= k_columns);
    editor.set_handles({handles.begin(), handles.end() - 1});
    editor.set_method("projection");
    editor.solve();
    CHECK(editor.taut_vertices().empty());
}

TEST_CASE("A hand that takes a corner of a sheet where nothing may move moves it") {
    Editor editor = held_sheet();
    REQUIRE(editor.solve().status == Status::converged);
    const Eigen::Vector3d from = editor.handles().back().target;
    editor.drag_handle(k_last, from);
    CHECK(editor.solve().status == Status::converged);
    CHECK_FALSE(editor.holds_back());
    editor.drag_handle(k_last, from + Eigen::Vector3d(-0.5, -0.3, 0.4));
    CHECK(editor.solve().status == Status::converged);
    CHECK(editor.handle_error() == 0);
    editor.drag_handle(k_last, from + Eigen::Vector3d(1, 1, 0));  // out of reach: as far as it goes
    const SolveReport beyond = editor.solve();
    CHECK(keeps_lengths(beyond.status));
    CHECK(beyond.iterations < 30);
    editor.drag_handle(k_last, from);
    CHECK(editor.solve().status == Status::converged);
    CHECK((editor.positions() - editor.net().rest_positions()).cwiseAbs().maxCoeff() < 1e-6);
}

TEST_CASE("A net that has its handles in place is not given up for lines that are all but taut") {
    Editor editor = nearly_taut_sheet();
    const bool in_frames = GENERATE(false, true);
    editor.set_option("max_iterations", "1000");
    SolveReport report = editor.solve({in_frames ? 7 : 2000});
    while (report.status == Status::running) report = editor.solve({7});
    CHECK(report.status == Status::exact);
    CHECK(report.max_deviation < editor.options().threshold);
    CHECK(max_deviation(editor.net(), editor.positions()) < editor.options().threshold);
    CHECK(editor.handle_error() == 0);
    CHECK(editor.last_net() == editor.positions());
    REQUIRE(report.to_rest);
    CHECK(std::isfinite(report.to_rest->gradient_norm));
    CHECK(net_forces(editor)->handles.allFinite());
    // Forces are of this net: in the solver's unit it has the same lengths.
    const Positions& rests = editor.rest_state()->positions;
    const double unit = editor.positions().norm() / rests.norm();
    CHECK((unit * rests - editor.positions()).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("Beside lines that are all but taut a net comes to rest, also where a jump has led it there") {
    Shape shape = make_shape("canopy:vertices=1200");
    Editor editor(std::move(shape.net));
    editor.set_method("equilibrium");
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), shape.suggested_handles);
    // As far as the net reaches, nearly: edges pull with a hundred times what shear and bending push back with.
    handles.back().target = {-0.18371546787087148, 7.0140892741619268, 2.212554495200597};
    editor.set_handles(handles);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.max_deviation < 1e-9);
    REQUIRE(report.to_rest);
    CHECK(report.to_rest->gradient_norm < editor.options().rest_tolerance);
    CHECK(net_forces(editor)->edges.maxCoeff() > 100);
}

TEST_CASE(
    "A handle beside the lines that others pull straight is out of reach, and the sheet is stretched as a whole") {
    Editor editor = held_sheet();
    constexpr int k_middle = 4 * k_columns + 5;
    std::vector<Handle> handles = editor.handles();
    handles.push_back({k_middle, editor.positions().col(k_middle) + Eigen::Vector3d(0, 0, 2)});
    editor.set_handles(handles);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::unreachable);
    CHECK(editor.taut_vertices().empty());
    CHECK(editor.positions().col(k_middle) == handles.back().target);
    // No spike: what is beside it goes along, and no edge is much longer than others.
    CHECK(editor.positions()(2, k_middle + 1) > 0.5);
    CHECK(report.max_deviation < 0.1);

    // Where the lines pass it stays a net at rest.
    editor.move_handle(k_middle, editor.net().rest_positions().col(k_middle));
    CHECK(keeps_lengths(editor.solve().status));
}
