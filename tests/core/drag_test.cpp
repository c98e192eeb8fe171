// A handle in hand (Editor::drag_handle): every frame a net, and held back where none leads to where the hand is.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "edit/editor.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

constexpr int k_handle = 60;
constexpr double k_a_net = 1e-6, k_at_rest = 1e-9;

/// An arched patch held at its corners and taken at its crown.
struct Taken {
    Net net = samples::patch(11, 11, 0.4);
    Editor editor{net};
    Eigen::Vector3d crown = net.rest_positions().col(k_handle);

    Taken() {
        editor.set_handles(samples::handles_at_rest(net, {0, 10, 110, 120, k_handle}));
        editor.solve();
    }

    /// Drags the crown up by as much, in frames of two iterations, and lets the net settle; all are nets.
    Status drag(double from, double to, int frames) {
        for (int frame = 1; frame <= frames; ++frame) {
            editor.drag_handle(k_handle, at(from + (to - from) * frame / frames));
            if (frame < frames) editor.solve({.iterations = 2});
            CHECK(max_deviation(net, editor.positions()) < k_a_net);
        }
        const Status status = editor.solve().status;
        CHECK(max_deviation(net, editor.positions()) < k_at_rest);
        return status;
    }

    Eigen::Vector3d at(double height) const { return crown + Eigen::Vector3d(0, 0, height); }
    Eigen::Vector3d now() const { return editor.positions().col(k_handle); }
    double distance(const Positions& a, const Positions& b) const {
        return (a - b).colwise().norm().maxCoeff() / net.mean_length();
    }
};

}  // namespace

TEST_CASE("Drag: within reach the handle goes where the hand is") {
    Taken taken;
    CHECK(keeps_lengths(taken.drag(0, 0.5, 5)));
    CHECK(!taken.editor.holds_back());
    CHECK(taken.now() == taken.at(0.5));
    CHECK(taken.editor.handle_error() == 0);
}

TEST_CASE("Drag: a hand that is kept to an axis or a plane leaves neither when it is held back") {
    constexpr Axes x = 1, xz = 5;
    Taken taken;
    const auto drag_to = [&](const Eigen::Vector3d& move, Axes along) {
        for (int frame = 1; frame <= 10; ++frame) {
            taken.editor.drag_handle(k_handle, taken.crown + move * frame / 10, along);
            taken.editor.solve({.iterations = 2});
            CHECK(max_deviation(taken.net, taken.editor.positions()) < k_a_net);
        }
        CHECK(keeps_lengths(taken.editor.solve().status));
        CHECK(taken.editor.holds_back());
        return Eigen::Vector3d(taken.now() - taken.crown);
    };
    const double L = taken.net.mean_length();
    const Eigen::Vector3d far(30, 0, 0), free_move = drag_to(far, k_all_axes);
    CHECK(std::abs(free_move.z()) > 0.1 * L);

    const Eigen::Vector3d on_axis = drag_to(far, x);
    CHECK(across(x, taken.now()) == across(x, taken.crown));
    CHECK(on_axis.x() > 0.5 * L);
    const Eigen::Vector3d in_plane = drag_to({30, 0, 30}, xz);
    CHECK(taken.now().y() == taken.crown.y());
    CHECK(in_plane.z() > on_axis.z() + 0.1 * L);

    taken.editor.drag_handle(k_handle, taken.crown + far, x);
    taken.editor.release_handles();
    taken.editor.solve();
    const Handle handle = taken.editor.handles().back();
    CHECK(across(x, handle.target) == across(x, taken.crown));
    CHECK(handle.target.x() > taken.crown.x() + 0.5 * L);
    CHECK(max_deviation(taken.net, taken.editor.positions()) < k_at_rest);
}

TEST_CASE("Drag: what a hand has pulled taut comes to rest where it is let go") {
    const Shape shape = make_shape("scroll:vertices=900");
    Editor editor(shape.net);
    editor.set_handles(samples::handles_at_rest(shape.net, shape.suggested_handles));
    editor.solve();
    const int vertex = shape.suggested_handles.back();
    const Eigen::Vector3d from = editor.positions().col(vertex);
    const Eigen::Vector3d way = shape.net.mean_length() * Eigen::Vector3d(3.7, 1.5, -0.8);
    for (int frame = 1; frame <= 30; ++frame) {
        editor.drag_handle(vertex, from + way * frame / 30);
        editor.solve({.iterations = 1});
    }
    REQUIRE(editor.holds_back());
    editor.release_handles();
    CHECK(editor.solve().status == Status::converged);
    CHECK((editor.positions().col(vertex) - from).norm() < 0.5 * way.norm());
}

TEST_CASE("Drag: hands that hold every vertex take the net along, also in the last frame") {
    const int frames = GENERATE(1, 5);
    const Net net = samples::patch(4, 4, 0.4);
    std::vector<int> all(16);
    std::iota(all.begin(), all.end(), 0);
    Editor editor(net);
    editor.set_handles(samples::handles_at_rest(net, all));
    editor.solve();
    const Eigen::Vector3d way(3, -2, 1);
    for (int frame = 1; frame <= frames; ++frame) {
        for (int v : all) editor.drag_handle(v, net.rest_positions().col(v) + way * frame / frames);
        if (frame == frames) editor.release_handles();
        CHECK(editor.solve().status == Status::converged);
    }
    CHECK(editor.positions() == net.rest_positions().colwise() + way);
    CHECK(editor.handles()[5].target == net.rest_positions().col(5) + way);
}

TEST_CASE("Drag: a net that one or two handles hold does not spin about them, in however many frames they move") {
    const std::vector<int> held = GENERATE(std::vector{60, 120}, std::vector{0, 120});
    const Net net = samples::patch(11, 11, 0.4);
    const auto moved_in = [&](int frames) {
        Editor editor(net);
        editor.set_handles(samples::handles_at_rest(net, held));
        editor.solve();
        const Eigen::Vector3d from = net.rest_positions().col(120),
                              way = 4 * net.mean_length() * Eigen::Vector3d(-1, -1, 1);
        for (int frame = 1; frame <= frames; ++frame) {
            editor.drag_handle(120, from + way * frame / frames);
            editor.solve({.iterations = 1});
        }
        editor.release_handles();
        CHECK(editor.solve().status == Status::converged);
        return editor.positions();
    };
    const Positions few = moved_in(8), many = moved_in(100);
    CHECK((few - many).colwise().norm().maxCoeff() < 0.1 * net.mean_length());
}

TEST_CASE("Handles that move together take a net along as it is, though one or two leave it free to turn") {
    const std::vector<int> held = GENERATE(std::vector{3}, std::vector{0, 5}, std::vector{0, 5, 10});
    const Net net = samples::patch(11, 11, 0.4);
    const Eigen::Vector3d way(3, -2, 1);
    Editor editor(net);
    std::vector<Handle> handles = samples::handles_at_rest(net, held);
    for (Handle& handle : handles) handle.target += way;
    editor.set_handles(handles);
    CHECK(editor.solve().status == Status::converged);
    CHECK((editor.positions() - (net.rest_positions().colwise() + way)).norm() < 1e-6 * net.mean_length());
}

TEST_CASE("Drag: along numbers that are no axes it is refused, and nothing has changed") {
    Taken taken;
    const Axes along = GENERATE(-1, 0, 8);
    CAPTURE(along);
    CHECK_THROWS_WITH(taken.editor.drag_handle(k_handle, taken.at(1), along), "a hand keeps to x, y or z");
    CHECK(taken.editor.standing_handles().back().target == taken.crown);
}

TEST_CASE("Drag: beyond reach it is held back, as far as the net goes, and comes home with the hand") {
    Taken taken;
    const Positions rest = taken.editor.positions();
    CHECK(keeps_lengths(taken.drag(0, 30, 20)));
    CHECK(taken.editor.holds_back());
    CHECK(taken.editor.unreachable_pairs().size() > 0);
    CHECK(corner_angle_range(taken.net, taken.editor.positions()).smallest > 29.99 * EIGEN_PI / 180);
    const double reached = (taken.now() - taken.crown).z();
    CHECK(reached > 1.7);
    CHECK(reached < 1.8);
    for (int corner : {0, 10, 110, 120})
        CHECK(taken.editor.positions().col(corner) == taken.net.rest_positions().col(corner));
    // Farther out it goes hardly farther.
    taken.drag(30, 40, 2);
    CHECK((taken.now() - taken.crown).z() < reached + 1e-3);

    CHECK(taken.drag(40, 0, 20) == Status::converged);
    CHECK(!taken.editor.holds_back());
    CHECK(taken.now() == taken.crown);
    CHECK(taken.distance(taken.editor.positions(), rest) < 0.02);
}

TEST_CASE("Drag: hands that hold all of a heavy net carry it, also where they are held back", "[large]") {
    const std::string gravity = GENERATE("0.3", "1");
    const Net net = make_shape("dome:vertices=900").net;
    std::vector<int> feet;
    for (const double x : {-1, 1})
        for (const double y : {-1, 1}) {
            Eigen::Index foot = 0;
            (x * net.rest_positions().row(0) + y * net.rest_positions().row(1)).maxCoeff(&foot);
            feet.push_back(static_cast<int>(foot));
        }
    Editor editor(net);
    editor.set_handles(samples::handles_at_rest(net, feet));
    editor.set_option("gravity", gravity);
    const int frames = 4;
    for (int frame = 1; frame <= frames; ++frame) {
        for (const int foot : feet) {
            Eigen::Vector3d target = net.rest_positions().col(foot);
            target.head<2>() *= 1 - 0.06 * frame / frames;
            editor.drag_handle(foot, target);
        }
        editor.solve();
        // It hangs by its feet, and is not longer than it is wide.
        const Eigen::Vector3d size = editor.positions().rowwise().maxCoeff() - editor.positions().rowwise().minCoeff();
        CHECK(size.z() < size.x());
        CHECK(editor.positions().col(feet[0]).z() > -net.mean_length());
    }
}

TEST_CASE("Drag: a jump beyond reach ends where a slow hand does") {
    Taken slow, fast;
    slow.drag(0, 12, 60);
    fast.drag(0, 12, 1);
    CHECK(slow.editor.holds_back());
    CHECK(fast.editor.holds_back());
    CHECK(slow.distance(slow.editor.positions(), fast.editor.positions()) < 0.05);
}

TEST_CASE("Drag: a hand that is far beyond reach at once comes to rest in as many iterations as a solve has") {
    const auto [net, handles] = make_shape("dome:vertices=1300");
    Editor editor(net);
    editor.set_handles(samples::handles_at_rest(net, handles));
    editor.drag_handle(handles.back(), {0, 0, 20});
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.iterations < 100);
    CHECK(editor.holds_back());
    CHECK(max_deviation(net, editor.positions()) < k_at_rest);
}

TEST_CASE("Drag: what was held back stays, once it is let go, where it stands when the net has settled") {
    Taken taken;
    taken.editor.drag_handle(k_handle, taken.at(30));
    taken.editor.release_handles();
    Status status = taken.editor.solve({.iterations = 3}).status;
    while (status == Status::running && taken.editor.holds_back()) {
        CHECK(taken.editor.handles().back().target == taken.at(30));
        CHECK(taken.editor.standing_handles().back().target == taken.now());
        status = taken.editor.solve({.iterations = 3}).status;
    }
    CHECK(!taken.editor.holds_back());
    while (status == Status::running) status = taken.editor.solve().status;
    CHECK(taken.editor.handle_error() == 0);
    CHECK(taken.now().z() < taken.at(8).z());
    const Positions settled = taken.editor.positions();
    CHECK(keeps_lengths(taken.editor.solve().status));
    CHECK(taken.distance(taken.editor.positions(), settled) < 0.01);
}

TEST_CASE("Drag: the state in the middle of one is that of a net, its handles where they stand") {
    Taken taken, other;
    taken.editor.drag_handle(k_handle, taken.at(30));
    taken.editor.solve({.iterations = 5});
    const EditState state = taken.editor.state();
    CHECK(state.handles.back().target == taken.now());
    other.editor.set_state(state);
    CHECK(other.editor.positions() == taken.editor.positions());
    CHECK(max_deviation(other.net, other.editor.positions()) < k_a_net);
    // Any other change lets go.
    taken.editor.set_option("gravity", "0");
    CHECK(!taken.editor.holds_back());
    CHECK(taken.editor.handle_error() == 0);
}

TEST_CASE("Drag: methods that do not go from net to net stretch the net, as ever") {
    Taken taken;
    taken.editor.set_method("projection");
    taken.editor.drag_handle(k_handle, taken.at(30));
    CHECK(taken.editor.solve().status == Status::unreachable);
    CHECK(!taken.editor.holds_back());
    CHECK(taken.now() == taken.at(30));
}

TEST_CASE("Drag: where other handles leave no net, none is asked for") {
    Taken taken;
    taken.editor.move_handle(0, taken.net.rest_positions().col(0) - Eigen::Vector3d(100, 0, 0));
    CHECK(taken.editor.solve().status == Status::unreachable);
    taken.editor.drag_handle(k_handle, taken.at(1));
    CHECK(taken.editor.solve().status == Status::unreachable);
    CHECK(taken.now() == taken.at(1));
}

TEST_CASE("A net that is pulled far and comes to no rest has its lengths to the last digits all the same", "[large]") {
    Shape shape = make_shape("dome:vertices=800");
    const Net& net = shape.net;
    std::vector<Handle> handles;
    for (const int vertex : shape.suggested_handles)
        handles.push_back({.vertex = vertex, .target = net.rest_positions().col(vertex)});
    const Handle last = handles.back();
    Editor editor(net);
    editor.set_method("equilibrium");
    editor.set_handles(handles);
    editor.solve();
    // There lengths are come to slowly, and the descent ends with an error of 3e-11.
    const Eigen::Vector3d way =
        Eigen::Vector3d(-16.426059524531464, -40.243084381111878, -18.500957704055693) * net.mean_length();
    for (int frame = 1; frame < 6; ++frame) {
        editor.drag_handle(last.vertex, last.target + frame / 6. * way);
        editor.solve({.iterations = 3});
    }
    editor.drag_handle(last.vertex, last.target + way);
    editor.release_handles();
    const SolveReport end = editor.solve();
    REQUIRE(keeps_lengths(end.status));
    CHECK(end.max_deviation < 1e-12);
}

/// The crown is moved to where no walk leads; the solve stops as it draws the crown there.
Taken drawn_to(const Eigen::Vector3d& target) {
    Taken taken;
    taken.editor.move_handle(k_handle, target);
    while (!taken.editor.draws_handles()) REQUIRE(taken.editor.solve({.iterations = 1}).status == Status::running);
    REQUIRE(taken.now() != target);
    return taken;
}

TEST_CASE("Drag: a handle that a solve is drawing to its target can be taken out of its hand") {
    Taken calm;
    const Eigen::Vector3d place = calm.at(0.1);
    Taken taken = drawn_to(calm.crown + Eigen::Vector3d(-2, 0, 0));
    taken.editor.drag_handle(k_handle, place);
    CHECK(!taken.editor.draws_handles());
    CHECK(taken.editor.solve().status == Status::converged);
    CHECK(max_deviation(taken.net, taken.editor.positions()) < k_a_net);
    CHECK(taken.now() == place);
    CHECK(taken.editor.handle_error() == 0);
}

TEST_CASE("Handles that a solve is drawing are at their targets once another one is moved") {
    const Eigen::Vector3d target = Taken().crown + Eigen::Vector3d(-2, 0, 0);
    Taken taken = drawn_to(target);
    taken.editor.move_handle(0, taken.net.rest_positions().col(0) + Eigen::Vector3d(0, 0, 0.1));
    CHECK(taken.now() == target);
    CHECK(taken.editor.handle_error() == 0);
    taken = drawn_to(target);
    taken.editor.set_method(make_method("projection"), "projection");
    CHECK(taken.now() == target);
    CHECK(taken.editor.handle_error() == 0);
}

TEST_CASE("Handles that slide are where their vertices stand while a solve is drawing others") {
    Taken taken;
    std::vector<Handle> handles = taken.editor.handles();
    handles[0].slides = 0b011;
    taken.editor.set_handles(handles);
    taken.editor.move_handle(k_handle, taken.crown + Eigen::Vector3d(-2, 0, 0));
    int drawn = 0;
    for (SolveReport report; report.status == Status::running;) {
        report = taken.editor.solve({.iterations = 1});
        drawn += static_cast<int>(taken.editor.draws_handles());
        CHECK(taken.editor.handle_error() == 0);
    }
    CHECK(drawn > 0);
}

TEST_CASE("The present state is no other while a solve is drawing handles, and the net grows from where it is") {
    const Eigen::Vector3d target = Taken().crown + Eigen::Vector3d(-2, 0, 0);
    Taken taken = drawn_to(target);
    const Positions now = taken.editor.positions();
    taken.editor.set_option("shear_limit", "30");
    taken.editor.set_state(taken.editor.state());
    CHECK(taken.editor.draws_handles());
    CHECK(taken.editor.positions() == now);

    taken.editor.set_option("length_scale", "1.25");
    CHECK(!taken.editor.draws_handles());
    CHECK(taken.now() == target);
    const auto edge = [&](const Positions& x) { return (x.col(27) - x.col(28)).norm(); };  // away from all handles
    CHECK(edge(taken.editor.positions()) == Approx(1.25 * edge(now)));
}

TEST_CASE("Drag: what is done to the positions before a solve does not keep a hand from where it goes") {
    Taken taken;
    taken.editor.set_initialisation("arap:3");
    for (const double height : {0.1, 0.2}) {
        taken.editor.drag_handle(k_handle, taken.at(height));
        CHECK(taken.editor.solve().status == Status::converged);
        CHECK(!taken.editor.holds_back());
        CHECK(taken.now() == taken.at(height));
    }
}

TEST_CASE("Drag: a soft handle that is dragged along an axis keeps none to it that a solve draws") {
    const auto drawn = [](Axes along) {
        Taken taken;
        std::vector<Handle> handles = taken.editor.handles();
        handles[0].weight = 1;
        taken.editor.set_handles(handles);
        taken.editor.solve();
        taken.editor.move_handle(k_handle, taken.crown + Eigen::Vector3d(-2, 0, 0));
        taken.editor.drag_handle(0, handles[0].target, along);
        taken.editor.solve();
        return taken.editor.positions();
    };
    CHECK(drawn(1) == drawn(k_all_axes));
}

TEST_CASE("A trace tells of a net only once handles that a solve draws to their targets are there") {
    Taken taken;
    const Eigen::Vector3d target = taken.crown + Eigen::Vector3d(-2, 0, 0);  // where no walk leads
    taken.editor.move_handle(k_handle, target);
    int drawn = 0;
    for (SolveReport report; report.status == Status::running;) {
        report = taken.editor.solve({.iterations = 1});
        CHECK((taken.now() == target || taken.editor.draws_handles()));
        if (report.trace.empty() || taken.now() == target) continue;
        ++drawn;
        CHECK(report.trace.back().max_deviation > k_a_net);
    }
    CHECK(drawn > 0);
}

TEST_CASE("Drag: a tube that was twisted by hand is at rest once its handles are home and let go") {
    constexpr int around = 12, rows = 9;
    Positions rest(3, around * rows);
    for (int v = 0; v < rest.cols(); ++v) {
        const double angle = 2 * EIGEN_PI * v / around, radius = 0.5 / std::sin(EIGEN_PI / around);
        rest.col(v) << radius * std::cos(angle), radius * std::sin(angle), v / around;
    }
    const Net tube(rest, samples::ring(around, rows, false).faces());
    const double L = tube.mean_length();
    std::vector<int> held, turned;
    for (int i = 0; i < around; ++i) {
        held.push_back(i);
        turned.push_back((rows - 1) * around + i);
    }
    held.insert(held.end(), turned.begin(), turned.end());
    Editor editor(tube);
    editor.set_handles(samples::handles_at_rest(tube, held));
    editor.solve();
    const auto turn_to = [&](double part) {
        const Eigen::AngleAxisd turn(2 * EIGEN_PI * part, Eigen::Vector3d::UnitZ());
        for (const int v : turned)
            editor.drag_handle(v, turn * Eigen::Vector3d(rest.col(v)) - Eigen::Vector3d(0, 0, 2.5 * L * part));
        editor.solve({.iterations = 3});
        CHECK(max_deviation(tube, editor.positions()) < k_a_net);
    };
    for (int frame = 1; frame <= 16; ++frame) turn_to(frame / 16.);
    for (int frame = 15; frame > 0; --frame) turn_to(frame / 16.);
    for (const int v : turned) editor.drag_handle(v, rest.col(v));
    editor.release_handles();
    CHECK(editor.solve().status == Status::converged);
    CHECK((editor.positions() - rest).colwise().norm().maxCoeff() < 1e-3 * L);
    // What is there already stays.
    const Positions home = editor.positions();
    CHECK(editor.solve().iterations == 0);
    CHECK((editor.positions() - home).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("Drag: every frame of a hand is a net, wherever its budget ends") {
    const Net strip = samples::patch(5, 2, 0);
    const int budget = GENERATE(1, 2, 3, 4, 5, 6, 7, 8);
    Editor editor(strip);
    editor.set_handles(samples::handles_at_rest(strip, {0, 4, 7}));
    editor.solve();
    const Eigen::Vector3d from = editor.positions().col(7), step(0.2317, 0.0509, 0.0689);
    for (int frame = 1; frame <= 6; ++frame) {
        editor.drag_handle(7, from + frame * step);
        for (int call = 0; call < 4; ++call) {
            editor.solve({.iterations = budget});
            CAPTURE(budget, frame, call);
            CHECK(max_deviation(strip, editor.positions()) < k_a_net);
        }
    }
}

TEST_CASE("Drag: while the corners of a rest shape are being opened the hand has the last net") {
    const double lean = 20 * EIGEN_PI / 180;
    Net flat = samples::patch(9, 9, 0);
    Positions leaning = flat.rest_positions();
    const double L = flat.mean_length();
    for (auto x : leaning.colwise())
        x.head(2) = Eigen::Vector2d(x.x() + x.y() * std::cos(lean), x.y() * std::sin(lean));
    const Net net(leaning, flat.faces());
    REQUIRE(corner_angle_range(net, leaning).smallest < 30 * EIGEN_PI / 180);
    Editor editor(net);
    editor.set_handles(samples::handles_at_rest(net, {0, 80}));
    constexpr int opening = 4;
    int frames = 0;
    Status status = Status::running;
    for (int frame = 1; status == Status::running; ++frame) {
        if (frame <= 5) editor.drag_handle(80, leaning.col(80) + Eigen::Vector3d(0, 0, 0.1 * L * frame));
        const SolveReport report = editor.solve({.iterations = 1});
        status = report.status;
        if (report.trace.back().stage != opening) continue;
        ++frames;
        CHECK(max_deviation(net, editor.positions()) < k_a_net);
    }
    CHECK(frames > 1);
    CHECK(max_deviation(net, editor.positions()) < k_a_net);
    CHECK(corner_angle_range(net, editor.positions()).smallest > 29.5 * EIGEN_PI / 180);
}
