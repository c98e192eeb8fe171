// Whatever numbers come in, what comes out are numbers, and the status says how good they are.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "../soak/invariants.h"
#include "base/error.h"
#include "constants.h"
#include "edit/near_targets.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

/// A dome of a few hundred vertices with its suggested handles at rest.
Editor held_dome(double factor = 1) {
    const Shape dome = make_shape("dome:vertices=300");
    Editor editor(dome.net.scaled(factor));
    editor.set_handles(samples::handles_at_rest(editor.net(), dome.suggested_handles));
    return editor;
}

ErrorCode code_of_scaled(double factor) {
    const Net net = samples::patch(4, 4);
    try {
        Net(factor * net.rest_positions(), net.faces());
    } catch (const Error& error) {
        return error.code();
    }
    return ErrorCode::bad_syntax;  // stands for none
}

/// Loses its numbers in the second iteration.
class FailingMethod : public Method {
public:
    void prepare(const Problem&) override {}
    Status start(const Problem&, Positions&, const Options&) override { return Status::running; }
    Status iterate(Positions& positions, TraceRow&) override {
        const bool first = m_iterations++ == 0;
        positions.col(5).z() = first ? 0.25 : std::nan("");
        return Status::running;
    }

private:
    int m_iterations = 0;
};

}  // namespace

TEST_CASE("A net of any size is edited alike, to the last bit") {
    const std::string method = GENERATE(from_range(std::vector<std::string>{
        "equilibrium", "projection", "li2022", "gauss_newton", "arap", "local_global", "lbfgs"}));
    const int exponent = GENERATE(-400, -37, 3, 400);
    CAPTURE(method, exponent);
    const double factor = std::ldexp(1, exponent);
    Editor here = held_dome(), there = held_dome(factor);
    for (Editor* editor : {&here, &there}) {
        editor->set_method(method);
        const Handle handle = editor->handles().back();
        editor->move_handle(handle.vertex, handle.target + editor->net().mean_length() * Eigen::Vector3d(1, 0.5, 2));
    }
    const SolveReport one = here.solve(), other = there.solve();
    CHECK(other.status == one.status);
    CHECK(other.iterations == one.iterations);
    CHECK(other.max_deviation == one.max_deviation);
    CHECK(there.positions() == factor * here.positions());
}

TEST_CASE("Nets beyond the range of numbers are refused by size") {
    CHECK(code_of_scaled(1e140) == ErrorCode::bad_syntax);
    CHECK(code_of_scaled(1e-140) == ErrorCode::bad_syntax);
    CHECK(code_of_scaled(1e155) == ErrorCode::bad_scale);
    CHECK(code_of_scaled(1e-155) == ErrorCode::bad_scale);
    CHECK(code_of_scaled(1e-300) == ErrorCode::bad_scale);  // not: an edge has length zero
    CHECK(code_of_scaled(1e307) == ErrorCode::bad_scale);
}

TEST_CASE("A handle that is sent away leaves the net finite, and comes back") {
    const std::string method = GENERATE(from_range([] {
        std::vector<std::string> names;
        for (const MethodInfo& info : method_table()) names.emplace_back(info.name);
        return names;
    }()));
    const double distance = GENERATE(1e3, 1e40, 1e200, 1e307);
    CAPTURE(method, distance);
    Editor editor = held_dome();
    editor.set_method(method);
    const Handle handle = editor.handles().back();
    const Positions before = editor.positions();
    editor.move_handle(handle.vertex, Eigen::Vector3d(distance, -distance, distance));
    const SolveReport away = editor.solve();
    CHECK(invariants::of_solve(editor, away, {}, before) == invariants::Violations{});
    CHECK(away.status == Status::unreachable);

    // What is not held follows as far as it would follow a handle nearby.
    const Positions& x = editor.positions();
    for (int v = 0; v < x.cols(); ++v)
        if (v != handle.vertex) REQUIRE((x.col(v) - before.col(v)).norm() < 1000);
    CHECK(vertex_corner_angles(editor.net(), x).allFinite());
    CHECK(edge_ratios(editor.net(), x).allFinite());

    editor.move_handle(handle.vertex, handle.target);
    CHECK(invariants::of_solve(editor, editor.solve(), {}, x) == invariants::Violations{});
    if (method == "projection" || method == "equilibrium") CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("A whole net sent where its edges have no digits is not said to have converged") {
    Editor editor = held_dome();
    std::vector<Handle> handles = editor.handles();
    const double distance = GENERATE(1e12, 1e17, 1e300);
    for (Handle& handle : handles) handle.target.x() += distance;
    const Positions before = editor.positions();
    editor.set_handles(handles);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::unreachable);
    CHECK(invariants::of_solve(editor, report, {}, before) == invariants::Violations{});
}

TEST_CASE("Handles at one place, or on a line, are held there") {
    const std::string method = GENERATE("equilibrium", "projection", "li2022", "arap", "dp8");
    const bool all_at_one_place = GENERATE(true, false);
    CAPTURE(method, all_at_one_place);
    Editor editor(samples::patch(9, 9));
    editor.set_method(method);
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 1, 8, 40, 41, 80});
    for (Handle& handle : handles)
        handle.target = all_at_one_place ? Eigen::Vector3d(4, 4, 0) : Eigen::Vector3d(handle.target.x(), 4, 0);
    const Positions before = editor.positions();
    editor.set_handles(handles);
    const SolveReport report = editor.solve();
    CHECK(invariants::of_solve(editor, report, {}, before) == invariants::Violations{});
    CHECK(report.status != Status::non_finite);
    if (all_at_one_place) CHECK(report.status == Status::unreachable);  // 0 and 1 are joined by an edge
}

TEST_CASE("Where numbers fail, the last that were good stay") {
    Editor editor(samples::patch(4, 4));
    editor.set_method(std::make_unique<FailingMethod>(), "failing");
    editor.set_handles({{{0, editor.positions().col(0) + 0.5 * Eigen::Vector3d::UnitZ()}}});
    CHECK(editor.solve({.iterations = 1}).status == Status::running);
    const Positions good = editor.positions();
    CHECK(good(2, 5) == 0.25);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::non_finite);
    CHECK(editor.positions() == good);
}

TEST_CASE("Where numbers fail though no handle was moved, the net of before stays") {
    Editor editor(samples::patch(4, 4));
    editor.set_method(std::make_unique<FailingMethod>(), "failing");
    CHECK(editor.solve({.iterations = 1}).status == Status::running);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::non_finite);
    CHECK(report.max_deviation < 1e-20);
    CHECK(editor.positions() == editor.net().rest_positions());
}

TEST_CASE("A net with an edge beyond all others at rest stays a net") {
    // Whatever is beside an edge of 1e200 times its length is lost where both are reckoned with.
    Positions rest = 1.9363e-121 * samples::patch(5, 5, 0).rest_positions();
    rest(1, 4) = 3e-7;
    rest(0, 19) = 2e79;
    rest(2, 8) = 3e19;
    Editor editor(Net(rest, samples::patch(5, 5).faces(), RestLengths::own));
    editor.set_initialisation("arap:4");
    editor.set_handles(samples::handles_at_rest(editor.net(), {8, 20, 18}));
    editor.solve();
    CHECK(max_deviation(editor.net(), editor.positions()) < editor.options().threshold);
}

TEST_CASE("Positions as far as no net can be are refused") {
    Editor editor(samples::patch(4, 4));
    Positions far = editor.positions();
    far(0, 3) = 1e151;
    CHECK_THROWS_AS(editor.set_positions(far), Error);
    CHECK(editor.positions() == editor.net().rest_positions());
}

TEST_CASE("Only what is too far is drawn near, in its direction") {
    const Net net = samples::patch(5, 1 + 1, 0);
    const Topology topology(net);
    const std::vector<int> vertices = {0, 2, 4};  // a row: 2 bounds both others, which do not bound each other
    const HandleGraph graph(net, topology, vertices);
    Eigen::Matrix3Xd rest(3, 3);
    for (int i = 0; i < 3; ++i) rest.col(i) = net.rest_positions().col(vertices[i]);

    Eigen::Matrix3Xd targets = rest;
    targets.col(2) += Eigen::Vector3d(0, 3 * k_most_strain / 2, 0);
    CHECK(near_targets(graph, net.mean_length(), targets, rest) == targets);

    const double away = GENERATE(1e3, 1e160, 1.7e308);
    targets.col(2) = Eigen::Vector3d(0, 0, away);
    const Eigen::Matrix3Xd near = near_targets(graph, net.mean_length(), targets, rest);
    CHECK(near.leftCols(2) == rest.leftCols(2));
    CHECK((near.col(2) - rest.col(1)).norm() == Approx(2 * k_most_strain));
    CHECK((near.col(2) - rest.col(1)).normalized().z() > 0.99);
}

TEST_CASE("Lengths and angles of vectors whose squares leave the range of numbers") {
    const double size = GENERATE(1e-170, 1e-90, 1, 1e90, 1e170);
    CAPTURE(size);
    const Net net = samples::patch(3, 3, 0);
    const Positions x = size * net.rest_positions();
    CHECK(edge_ratios(net, x).maxCoeff() == Approx(size).epsilon(1e-14));
    CHECK(max_deviation(net, x) == Approx(std::max(size, 1 / size) - (size == 1 ? 1 : 0)).margin(1e-20));
    CHECK(corner_angle_range(net, x).smallest == Approx(EIGEN_PI / 2));
    CHECK(max_deviation(net, Positions::Zero(3, 9)) == samples::k_infinity);
}
