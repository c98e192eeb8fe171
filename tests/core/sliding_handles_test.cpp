#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "edit/editor.h"
#include "edit/length_adapter.h"
#include "first_order.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "solve/method.h"

using namespace chebnet;

namespace {

constexpr Axes k_x = 1, k_y = 2, k_z = 4, k_ground = k_x + k_y;

Handle pinned(const Net& net, int vertex) { return {vertex, net.rest_positions().col(vertex)}; }

Handle sliding(const Net& net, int vertex, Axes axes) {
    Handle handle = pinned(net, vertex);
    handle.slides = axes;
    return handle;
}

/// A flat sheet of n × n vertices whose border slides on the ground, and its middle.
struct Sheet {
    Net net;
    int n, middle;
    std::vector<Handle> handles;
};

Sheet sheet(int n) {
    Sheet sheet{samples::patch(n, n, 0), n, n * (n / 2) + n / 2, {}};
    for (int v = 0; v < n * n; ++v)
        if (v % n == 0 || v % n == n - 1 || v < n || v >= n * (n - 1))
            sheet.handles.push_back(sliding(sheet.net, v, k_ground));
    sheet.handles.push_back(pinned(sheet.net, sheet.middle));
    return sheet;
}

Editor editor_of(const Net& net, std::vector<Handle> handles) {
    Editor editor(net);
    editor.set_handles(std::move(handles));
    return editor;
}

/// Whether each handle holds its vertex bit for bit where it was wanted, and its target is where the vertex is.
bool holds(const Editor& editor, const std::vector<Handle>& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const Eigen::Vector3d at = editor.positions().col(wanted[i].vertex);
        if (!wanted[i].holds_at(at) || editor.handles()[i].target != at) return false;
    }
    return true;
}

double gradient(const Editor& editor) {
    return samples::first_order({editor.net(), editor.handles(), editor.options()}, editor.positions()).gradient;
}

/// The least max dL of samples::patch(columns, …) with these handles, by pairs of them that are farther apart, along
/// axes on which none of the two slides, than the edges between them are long; 0 if none is.
double least_deviation(std::span<const Handle> handles, int columns) {
    double least = 0;
    for (const Handle& a : handles)
        for (const Handle& b : handles) {
            const int way =
                std::abs(a.vertex % columns - b.vertex % columns) + std::abs(a.vertex / columns - b.vertex / columns);
            Eigen::Vector3d apart = a.target - b.target;
            for (int k = 0; k < 3; ++k)
                if (has_axis(a.slides, k) || has_axis(b.slides, k)) apart[k] = 0;
            if (apart.norm() > way) least = std::max(least, deviation(apart.norm() / way));
        }
    return least;
}

/// How far apart the feet in the middle of opposite sides stand.
double width(const Sheet& sheet, const Positions& x) {
    const int half = sheet.n / 2;
    return (x.col(sheet.middle - half) - x.col(sheet.middle + half)).norm();
}
double depth(const Sheet& sheet, const Positions& x) {
    const int half = sheet.n * (sheet.n / 2);
    return (x.col(sheet.middle - half) - x.col(sheet.middle + half)).norm();
}

}  // namespace

TEST_CASE("The border of a sheet whose crown is raised slides inwards, on the ground to the last bit, and back") {
    const Sheet flat = sheet(9);
    Editor editor = editor_of(flat.net, flat.handles);
    std::vector<Handle> wanted = flat.handles;
    for (const double lift : {0.5, 1.0, 2.0}) {
        CAPTURE(lift);
        const double before = width(flat, editor.positions());
        wanted.back().target.z() = lift;
        editor.move_handle(flat.middle, wanted.back().target);
        const SolveReport report = editor.solve();
        CHECK(report.status == Status::converged);
        CHECK(report.max_deviation < 1e-9);
        CHECK(holds(editor, wanted));
        CHECK(width(flat, editor.positions()) < before - 0.01);
        CHECK(gradient(editor) < 2 * editor.options().rest_tolerance);
        CHECK(editor.unreachable_pairs().empty());
    }
    CHECK(width(flat, editor.positions()) == Approx(depth(flat, editor.positions())).epsilon(1e-4));
    editor.move_handle(flat.middle, flat.net.rest_positions().col(flat.middle));
    CHECK(editor.solve().max_deviation < 1e-9);
    CHECK(width(flat, editor.positions()) == Approx(8).epsilon(1e-3));
}

TEST_CASE("The feet of an arch of two edges stand where Pythagoras says when its crown is raised") {
    const Net net = samples::patch(3, 2, 0.4);
    std::vector<Handle> handles;
    for (int v : {0, 2, 3, 5}) handles.push_back(sliding(net, v, k_ground));
    for (int v : {1, 4}) handles.push_back(pinned(net, v));
    Editor editor = editor_of(net, handles);
    editor.set_option("threshold", "1e-16");
    const double crown = net.rest_positions()(0, 1);
    for (const double height : {0.6, 0.8, 0.3}) {
        CAPTURE(height);
        for (Handle& handle : handles)
            if (handle.slides == k_no_axes) {
                handle.target.z() = height;
                editor.move_handle(handle.vertex, handle.target);
            }
        CHECK(editor.solve().status == Status::converged);
        CHECK(holds(editor, handles));
        const double span = std::sqrt(1 - height * height);
        for (int v : {0, 3}) CHECK(editor.positions()(0, v) == Approx(crown - span).margin(1e-7));
        for (int v : {2, 5}) CHECK(editor.positions()(0, v) == Approx(crown + span).margin(1e-7));
    }
}

TEST_CASE("A sheet whose feet slide on the ground does not turn while a soft handle lifts its middle") {
    const double weight = GENERATE(1., 100., 1e4);
    CAPTURE(weight);
    const int n = 30, middle = n * n / 2 + n / 2;  // beside the centre
    const Net net = samples::patch(n, n, 0);
    Editor editor =
        editor_of(net, {sliding(net, 0, k_ground), sliding(net, n - 1, k_ground), sliding(net, n * (n - 1), k_ground),
                        sliding(net, n * n - 1, k_ground), pinned(net, middle)});
    std::vector<Handle> handles = editor.handles();
    handles.back().weight = weight;
    handles.back().target.z() += 3;
    editor.set_handles(handles);
    REQUIRE(editor.solve().status == Status::converged);
    // From foot to opposite foot, as before.
    for (const auto& [a, b] : {std::pair(0, n * n - 1), std::pair(n - 1, n * (n - 1))}) {
        const Eigen::Vector3d before = net.rest_positions().col(b) - net.rest_positions().col(a),
                              now = editor.positions().col(b) - editor.positions().col(a);
        CHECK(before.cross(now).norm() < std::sin(0.2 * samples::k_degree) * before.norm() * now.norm());
    }
    CHECK(new_folds(net, net.rest_positions(), editor.positions()) == 0);
}

TEST_CASE("A net on feet that slide goes to a guide that it is given only then") {
    const int n = 11;
    const Net net = samples::patch(n, n, 0);
    Editor editor = editor_of(net, {sliding(net, 0, k_ground), sliding(net, n - 1, k_ground),
                                    sliding(net, n * (n - 1), k_ground), sliding(net, n * n - 1, k_ground)});
    editor.move_handle(0, editor.handles()[0].target + Eigen::Vector3d(0, 0, 0.1));
    REQUIRE(editor.solve().status == Status::converged);
    const Eigen::Vector3d before = editor.positions().rowwise().mean();
    // A slope, which meets the ground beside the middle of the net.
    Mesh mesh = samples::graph(2, 40, [](double x, double) { return 0.2 * x; });
    mesh.positions.colwise() += before + Eigen::Vector3d(3, 0, 0);
    editor.set_guide(std::make_shared<const Guide>(Surface(mesh)));
    editor.set_option("guide_mode", std::to_string(static_cast<int>(GuideMode::near)));
    CHECK(editor.solve().status == Status::converged);
    CHECK(editor.positions().row(0).mean() > before.x() + 0.5);
}

TEST_CASE("A strip with one foot fixed and one that slides up and down hangs straight down") {
    const Net net = samples::patch(2, 7, 0.5);
    std::vector<Handle> handles;
    for (int v : {0, 1}) handles.push_back(pinned(net, v));
    for (int v : {12, 13}) handles.push_back(sliding(net, v, k_z));
    Editor editor = editor_of(net, handles);
    editor.set_option("straight_rods", "on");
    editor.set_option("gravity", "1");
    // The feet are brought below the others, and slide down as far as the strip is long.
    for (int step = 1; step <= 20; ++step) {
        for (std::size_t i : {2, 3}) {
            handles[i].target.y() = net.rest_positions()(1, handles[i].vertex) * (20 - step) / 20;
            editor.move_handle(handles[i].vertex, handles[i].target);
        }
        editor.solve();
    }
    CHECK(editor.solve().status == Status::converged);
    CHECK(holds(editor, handles));
    for (int v = 0; v < 14; ++v) {
        CHECK(editor.positions()(1, v) == Approx(0).margin(1e-3));
        CHECK(editor.positions()(2, v) == Approx(-(v / 2)).margin(1e-3));
    }
}

TEST_CASE("A symmetric arch whose crown is raised draws both feet in by as much") {
    const Net net = samples::patch(9, 3, 0.5);
    std::vector<Handle> handles;
    for (int j = 0; j < 3; ++j) {
        handles.push_back(sliding(net, 9 * j, k_ground));
        handles.push_back(sliding(net, 9 * j + 8, k_ground));
        handles.push_back(pinned(net, 9 * j + 4));
        handles.back().target.z() += 0.7;
    }
    Editor editor = editor_of(net, handles);
    CHECK(editor.solve().status == Status::converged);
    CHECK(holds(editor, handles));
    CHECK(gradient(editor) < 2 * editor.options().rest_tolerance);
    const Positions &x = editor.positions(), &rest = net.rest_positions();
    for (int j = 0; j < 3; ++j) {
        const double left = x(0, 9 * j) - rest(0, 9 * j), right = rest(0, 9 * j + 8) - x(0, 9 * j + 8);
        CHECK(left > 0.05);
        CHECK(left == Approx(right).margin(1e-3));
    }
}

TEST_CASE("A foot that slides is lifted by moving it, whatever is said of where it slides") {
    const Sheet flat = sheet(7);
    Editor editor = editor_of(flat.net, flat.handles);
    editor.move_handle(flat.middle, flat.handles.back().target + Eigen::Vector3d(0, 0, 1));
    editor.solve();
    std::vector<Handle> wanted = editor.handles();
    wanted[0].target.z() = 0.3;
    const double x = wanted[0].target.x();
    editor.drag_handle(wanted[0].vertex, wanted[0].target + Eigen::Vector3d(100, -100, 0));
    CHECK(editor.handles()[0].target.x() == x);
    CHECK(editor.solve().status == Status::converged);
    editor.release_handles();
    editor.solve();
    CHECK(holds(editor, wanted));
    CHECK(max_deviation(flat.net, editor.positions()) < 1e-9);
    CHECK(gradient(editor) < 2 * editor.options().rest_tolerance);
}

TEST_CASE("A foot that is dragged higher than the net goes is held back, and every frame is a net") {
    const Net net = samples::patch(5, 5, 0.3);
    std::vector<Handle> handles{pinned(net, 0), pinned(net, 4), sliding(net, 22, k_ground)};
    Editor editor = editor_of(net, handles);
    for (int frame = 1; frame <= 20; ++frame) {
        editor.drag_handle(22, handles[2].target + Eigen::Vector3d(0, 0, 0.5 * frame));
        CHECK(editor.solve({.iterations = 1}).max_deviation < 1e-6);
    }
    while (editor.solve({.iterations = 100}).status == Status::running) {
    }
    CHECK(editor.holds_back());
    editor.release_handles();
    while (editor.solve({.iterations = 100}).status == Status::running) {
    }
    CHECK(editor.handle_error() == 0);
    CHECK(max_deviation(net, editor.positions()) < 1e-6);
}

TEST_CASE("A foot that slides is at rest along the ground once it is let go, though it had been held back") {
    const Net net = samples::patch(11, 6);
    Editor editor = editor_of(net, {pinned(net, 0), pinned(net, 55), sliding(net, 10, k_ground), pinned(net, 65)});
    REQUIRE(editor.solve().status == Status::converged);
    for (const double height : {4.0, 8.0, 30.0}) {
        editor.drag_handle(10, {0, 0, height});
        editor.solve({.iterations = 3});
    }
    for (int frame = 0; frame < 200 && !editor.holds_back(); ++frame) editor.solve({.iterations = 1});
    REQUIRE(editor.holds_back());
    editor.release_handles();
    REQUIRE(editor.solve().status == Status::converged);
    CHECK(!editor.holds_back());
    CHECK(gradient(editor) < 1.1 * editor.options().rest_tolerance);
}

TEST_CASE("With projection too the border of a sheet slides inwards, and holds its height to the last bit") {
    const Sheet flat = sheet(9);
    Editor editor = editor_of(flat.net, flat.handles);
    editor.set_method("projection");
    std::vector<Handle> wanted = flat.handles;
    for (const double lift : {0.5, 1.0, 2.0}) {
        CAPTURE(lift);
        const double before = width(flat, editor.positions());
        wanted.back().target.z() = lift;
        editor.move_handle(flat.middle, wanted.back().target);
        const SolveReport report = editor.solve();
        CHECK(report.status == Status::converged);
        CHECK(report.max_deviation < editor.options().threshold);
        CHECK(holds(editor, wanted));
        CHECK(width(flat, editor.positions()) < before - 0.01);
    }
    wanted[0].target.z() = 0.2;
    editor.move_handle(wanted[0].vertex, wanted[0].target);
    CHECK(editor.solve().status == Status::converged);
    CHECK(holds(editor, wanted));
}

TEST_CASE("With projection feet that slide along one axis or two find where lengths are, from anywhere nearby") {
    const unsigned seed = 20'240;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int round = 0; round < 12; ++round) {
        CAPTURE(round);
        const Net net = samples::patch(7 + round % 3, 6, 0.3);
        const Axes axes[] = {k_ground, k_x, k_y + k_z, k_z};
        const int last = net.vertex_count() - 1;
        std::vector<Handle> handles{pinned(net, 0), sliding(net, last, axes[round % 4]),
                                    sliding(net, 3, axes[(round + 1) % 4])};
        Editor editor = editor_of(net, handles);
        editor.set_method("projection");
        Positions x = net.rest_positions();
        for (double& each : x.reshaped()) each += 0.15 * number(random);
        editor.set_positions(x);
        CHECK(editor.solve().status == Status::converged);
        CHECK(max_deviation(net, editor.positions()) < editor.options().threshold);
        CHECK(holds(editor, handles));
    }
}

TEST_CASE("Methods that do not let handles slide keep them where they stand") {
    for (const MethodInfo& info : method_table()) {
        CHECK(make_method(info.name)->heeds() == info.heeds);
        if (info.heeds.slides) continue;
        CAPTURE(info.name);
        const Sheet flat = sheet(5);
        Editor editor = editor_of(flat.net, flat.handles);
        editor.set_method(info.name);
        editor.set_option("max_iterations", "30");
        editor.move_handle(flat.middle, flat.handles.back().target + Eigen::Vector3d(0.1, 0, 0.2));
        editor.solve();
        for (std::size_t i = 0; i + 1 < flat.handles.size(); ++i)
            CHECK(editor.positions().col(flat.handles[i].vertex) == flat.handles[i].target);
    }
}

TEST_CASE("What slides is as an editor set to the same state has it") {
    const Sheet flat = sheet(7);
    Editor editor = editor_of(flat.net, flat.handles);
    editor.move_handle(flat.middle, flat.handles.back().target + Eigen::Vector3d(0.2, 0, 1));
    editor.solve();
    const EditState state = editor.state();
    Editor other(flat.net);
    other.set_state(state);
    CHECK(other.state() == state);
    // Where it has slid counts, not where its target says.
    EditState stale = state;
    stale.handles[0].target.x() -= 1;
    other.set_state(stale);
    CHECK(other.state() == state);
    CHECK(other.solve().max_deviation < 1e-9);
}

TEST_CASE("Handles that slide never are out of reach along their axes, and bound no other") {
    const Net net = samples::patch(4, 4, 0);
    Editor editor = editor_of(net, {pinned(net, 0), sliding(net, 3, k_ground), sliding(net, 1, k_x)});
    CHECK(editor.unreachable_pairs().empty());
    CHECK(editor.reach(3).empty());
    CHECK(editor.reach(0).empty());
    editor.move_handle(0, Eigen::Vector3d(-100, 0, 0));
    CHECK(editor.unreachable_pairs().empty());
    CHECK(editor.solve().max_deviation < 1e-6);  // all of it has slid along
}

TEST_CASE("Handles that slide along everything, or softly, are refused and change nothing") {
    const Net net = samples::patch(3, 3);
    Editor editor = editor_of(net, {pinned(net, 0)});
    const EditState before = editor.state();
    for (const Axes axes : {-1, 7, 8}) {
        Handle handle = sliding(net, 4, axes);
        CHECK_THROWS_AS(editor.set_handles({handle}), Error);
    }
    Handle soft = sliding(net, 4, k_x);
    soft.weight = 1;
    CHECK_THROWS_WITH(editor.set_handles({soft}), Catch::Contains("handle 4 is soft"));
    CHECK(editor.state() == before);
}

TEST_CASE("Lengths adapt to handles beside some that slide") {
    const Net net = samples::patch(5, 5, 0.3);
    std::vector<Handle> handles{pinned(net, 0), pinned(net, 4), sliding(net, 22, k_ground)};
    const Editor editor = editor_of(net, handles);
    handles[1].target.x() += 1;
    LengthAdapter adapter(editor, {handles[1]});
    while (adapter.solve({.iterations = 50}).status == Status::running) {
    }
    const EditState found = adapter.state();
    CHECK(found.options.length_scale > 1);
    CHECK(found.handles[2].slides == k_ground);
    CHECK(found.positions(2, 22) == handles[2].target.z());
}

TEST_CASE("Lengths adapt to handles that slide, by the distance that they keep") {
    const Net net = samples::patch(11, 11, 0);
    std::vector<Handle> handles{sliding(net, 0, k_x), sliding(net, 1, k_x)};
    handles[1].target.z() += 2;
    Editor editor = editor_of(net, handles);
    REQUIRE_FALSE(keeps_lengths(editor.solve().status));
    LengthAdapter adapter(editor, {});
    REQUIRE(adapter.solve().status == Status::converged);
    const EditState found = adapter.state();
    CHECK(found.options.length_scale > 2 - 1e-6);
    CHECK(found.options.length_scale < 2 * (1 + LengthAdapter::k_precision));
    CHECK(found.positions(2, 1) == handles[1].target.z());
    Editor other(net);
    other.set_state(found);
    CHECK(max_deviation(other.net(), other.positions()) < 1e-9);
}

TEST_CASE("Whatever slides along whatever: lengths, held coordinates and first-order conditions") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    int converged = 0;
    constexpr int k_rounds = 12;
    for (int round = 0; round < k_rounds; ++round) {
        CAPTURE(round);
        const Net net = samples::patch(7, 6, 0.5);
        std::vector<int> vertices{0, 6, 35, 41, 17};
        std::shuffle(vertices.begin(), vertices.end(), random);
        std::vector<Handle> handles;
        for (int v : vertices) handles.push_back(sliding(net, v, std::uniform_int_distribution(0, 6)(random)));
        Editor editor = editor_of(net, handles);
        for (int drag = 0; drag < 3; ++drag) {
            std::uniform_real_distribution<double> move(-0.25, 0.25);
            for (Handle& handle : handles) {
                handle.target += Eigen::Vector3d(move(random), move(random), move(random));
                editor.move_handle(handle.vertex, handle.target);
            }
            const SolveReport report = editor.solve();
            CHECK(holds(editor, handles));
            if (!keeps_lengths(report.status)) continue;
            CHECK(report.max_deviation < editor.options().threshold);
            if (report.status != Status::converged) continue;
            ++converged;
            // Handles out of reach by less than the threshold tells pull a line taut, which no multiplier holds in
            // place.
            const double least = least_deviation(handles, 7);
            CHECK(report.max_deviation < least + 1e-9);
            if (least == 0) CHECK(gradient(editor) < 2 * editor.options().rest_tolerance);
        }
    }
    CHECK(converged > k_rounds);  // of three times as many
}
