// Options::length_scale, and the smallest one with which a net meets its handles (LengthAdapter).
#include "edit/length_adapter.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/number.h"
#include "net/measures.h"
#include "sample_nets.h"

using namespace chebnet;

namespace {

constexpr double k_settled = 1e-9;
constexpr int k_middle = 60, k_far_corner = 120;

Editor editor_of(Net net, const std::vector<int>& vertices) {
    Editor editor(std::move(net));
    editor.set_handles(samples::handles_at_rest(editor.net(), vertices));
    editor.solve();
    return editor;
}

/// What a hand that is held back there asks for.
Editor held_back(Net net, const std::vector<int>& vertices, const Handle& wanted) {
    Editor editor = editor_of(std::move(net), vertices);
    editor.drag_handle(wanted.vertex, wanted.target);
    editor.solve();
    CHECK(editor.holds_back());
    return editor;
}

Handle crown_lifted(const Net& net, double height) {
    return {k_middle, net.rest_positions().col(k_middle) + height * Eigen::Vector3d::UnitZ()};
}

/// Sets the editor to what is found for `wanted`, and judges that.
double adapt(Editor& editor, const Handle& wanted) {
    LengthAdapter adapter(editor, {wanted});
    REQUIRE(adapter.solve().status == Status::converged);
    editor.set_state(adapter.state());
    CHECK(editor.positions().col(wanted.vertex) == wanted.target);
    CHECK(max_deviation(editor.net(), editor.positions()) < k_settled);
    CHECK(corner_angle_range(editor.net(), editor.positions()).smallest > 29.9 * std::numbers::pi / 180);
    CHECK(keeps_lengths(editor.solve().status));
    CHECK(editor.positions().col(wanted.vertex) == wanted.target);
    CHECK(max_deviation(editor.net(), editor.positions()) < k_settled);
    return editor.options().length_scale;
}

/// Whether a hand gets there.
bool reaches(Editor& editor, const Handle& wanted) {
    editor.drag_handle(wanted.vertex, wanted.target);
    editor.solve();
    return !editor.holds_back();
}

void set_scale(Editor& editor, double scale) { editor.set_option("length_scale", number_text(scale, 17)); }

}  // namespace

TEST_CASE("All edges are longer by the length scale, and as long as before without it") {
    Editor editor = editor_of(samples::patch(11, 11), {0, 10, 110, 120});
    const Positions before = editor.positions();
    set_scale(editor, 1.05);
    CHECK(editor.net().rest_lengths().isApprox(1.05 * editor.original().rest_lengths(), 1e-15));
    CHECK(keeps_lengths(editor.solve().status));
    CHECK(max_deviation(editor.net(), editor.positions()) < k_settled);
    CHECK(editor.handle_error() == 0);
    set_scale(editor, 1);
    CHECK(keeps_lengths(editor.solve().status));
    CHECK(editor.net().rest_lengths() == editor.original().rest_lengths());
    CHECK((editor.positions() - before).colwise().norm().maxCoeff() < 0.02);
}

TEST_CASE("A net from before its edges grew is what handles are walked from") {
    Editor editor = editor_of(samples::patch(11, 11, 0.4), {0, 10, 110, 120, k_middle});
    const Handle near = crown_lifted(editor.net(), 0.2), far = crown_lifted(editor.net(), 0.5);
    editor.move_handle(near.vertex, near.target);
    editor.solve();
    const EditState before = editor.state();
    set_scale(editor, 1.3);
    editor.solve();
    editor.set_state(before);
    editor.move_handle(far.vertex, far.target);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.trace.front().stage == 2);  // following its handles
}

TEST_CASE("A net at rest is a larger one with longer edges") {
    Editor editor(samples::patch(6, 5));
    set_scale(editor, 2);
    editor.reset();
    const Positions &rest = editor.original().rest_positions(), &now = editor.positions();
    CHECK((now.rowwise().mean() - rest.rowwise().mean()).norm() < 1e-12);
    CHECK((now.col(29) - now.col(0)).isApprox(2 * (rest.col(29) - rest.col(0)), 1e-12));
    CHECK(editor.solve().iterations == 0);
}

TEST_CASE("Every method knows the length scale") {
    const std::string method = GENERATE(as<std::string>{}, "equilibrium", "projection", "li2022", "gauss_newton");
    INFO(method);
    Editor editor = editor_of(samples::patch(11, 11), {0, 10, 110, 120});
    editor.set_method(method);
    set_scale(editor, 1.02);
    CHECK(keeps_lengths(editor.solve().status));
    const double longest = edge_length_range(editor.net(), editor.positions()).longest;
    CHECK(longest == Approx(1.02).epsilon(2e-3));
}

TEST_CASE("A length scale out of range is refused by name") {
    Editor editor(samples::patch(4, 4));
    CHECK_THROWS_WITH(set_scale(editor, 0.4), Catch::Contains("length_scale must be a number from 0.5 to 4"));
    CHECK_THROWS_AS(set_scale(editor, 5), Error);
    CHECK(editor.options().length_scale == 1);
}

TEST_CASE("Within reach lengths stay as they are") {
    Editor editor = editor_of(samples::patch(11, 11, 0.4), {0, 10, 110, 120, k_middle});
    CHECK(adapt(editor, crown_lifted(editor.net(), 0.5)) == 1);
}

TEST_CASE("A net line pulled straight grows by its distance over its reach") {
    const double factor = GENERATE(1.05, 1.9, 3.0);
    Editor editor = editor_of(samples::patch(11, 3, 0), {0, 10});
    const Handle wanted{10, editor.positions().col(0) + 10 * factor * Eigen::Vector3d::UnitX()};
    CHECK(adapt(editor, wanted) == Approx(factor).epsilon(1e-9));
}

TEST_CASE("A sheet pulled by its diagonal grows until its corners are at their limit") {
    // All diagonals of n × n cells with edges of length s, sheared to 30°, are 2 s cos 15° long.
    const double factor = GENERATE(1.1, 1.9);
    Editor editor = editor_of(samples::patch(11, 11, 0), {0, k_far_corner});
    const double reach = 20 * std::cos(std::numbers::pi / 12);
    const Eigen::Vector3d along = Eigen::Vector3d(1, 1, 0).normalized();
    const double scale = adapt(editor, {k_far_corner, editor.positions().col(0) + factor * reach * along});
    CHECK(scale > factor * (1 - 1e-4));
    CHECK(scale < factor * (1 + LengthAdapter::k_precision));
}

TEST_CASE("What a hand asked for beyond reach is met by the smallest scale that does") {
    const Net net = samples::patch(11, 11, 0.4);
    const Handle wanted = crown_lifted(net, GENERATE(2.5, 6.0));
    const std::vector<int> vertices{0, 10, 110, 120, k_middle};
    Editor editor = held_back(net, vertices, wanted);
    const double scale = adapt(editor, wanted);
    CHECK(scale > 1.01);
    for (int corner : {0, 10, 110, 120}) CHECK(editor.positions().col(corner) == net.rest_positions().col(corner));
    // With 0.3 % less a hand is held back, from near there and from rest.
    set_scale(editor, scale / 1.003);
    CHECK_FALSE(reaches(editor, wanted));
    Editor other = editor_of(net, vertices);
    set_scale(other, scale / 1.003);
    other.solve();
    CHECK_FALSE(reaches(other, wanted));
}

TEST_CASE("Lengths that differ keep their ratios") {
    const Positions x = Eigen::Vector3d(1, 1.5, 1).asDiagonal() * samples::patch(9, 9, 0.3).rest_positions();
    Editor editor = editor_of(Net(x, samples::patch(9, 9).faces(), RestLengths::own), {0, 8, 72, 80, 40});
    const double scale = adapt(editor, {40, x.col(40) + 5 * Eigen::Vector3d::UnitZ()});
    CHECK(scale > 1.01);
    CHECK(editor.net().rest_lengths().isApprox(scale * editor.original().rest_lengths(), 1e-15));
}

TEST_CASE("Where no scale does, that is said") {
    Editor editor = editor_of(samples::patch(6, 6), {0, 1, 35});
    const Eigen::Vector3d far = editor.positions().col(35) + 20 * Eigen::Vector3d::UnitZ();
    SECTION("since two handles hold an edge") {
        CHECK(LengthAdapter(editor, {{35, far}}).solve().status == Status::unreachable);
    }
    SECTION("since that is too far for any") {
        editor.set_handles(samples::handles_at_rest(editor.net(), {0, 35}));
        CHECK(LengthAdapter(editor, {{35, 100 * far}}).solve().status == Status::unreachable);
    }
    CHECK_THROWS_AS(LengthAdapter(editor, {{7, far}}), Error);
}

TEST_CASE("While a locality holds edges do not grow, and it is said why") {
    const Net net = samples::patch(11, 11, 0.4);
    const Handle wanted = crown_lifted(net, 3);
    Editor editor = editor_of(net, {0, k_middle, k_far_corner});
    editor.set_locality(3 * net.mean_length(), std::array{k_middle});
    CHECK_THROWS_WITH(LengthAdapter(editor, {wanted}), Catch::Matchers::Contains("with a locality edges do not grow"));
}

TEST_CASE("Interrupted anywhere, the scale found is the same") {
    const Net net = samples::patch(11, 11, 0.4);
    const Handle wanted = crown_lifted(net, 3);
    const Editor editor = held_back(net, {0, 10, 110, 120, k_middle}, wanted);
    LengthAdapter at_once(editor, {wanted}), in_slices(editor, {wanted});
    at_once.solve();
    while (in_slices.solve({.iterations = 3}).status == Status::running) {
    }
    CHECK(in_slices.state() == at_once.state());
}

TEST_CASE("What is found is a net, also where it comes to no rest since lines are all but taut") {
    const Net net = samples::patch(8, 5, 0);
    Editor editor(net);
    editor.set_handles({{33, {3.0851443540513426, 3.4372565898392851, -0.03057478918448385}},
                        {29, {6.5805097173974172, 2.5498998084654891, 0}},
                        {16, {1.1046930685815659, 1.9356951609908191, 0.029080964123738003}},
                        {39, {9.1073462898632229, 3.3998664112873191, 0}}});
    REQUIRE_FALSE(keeps_lengths(editor.solve().status));
    LengthAdapter adapter(editor, {});
    REQUIRE(adapter.solve().status == Status::converged);
    Editor other(net);
    other.set_state(adapter.state());
    CHECK(max_deviation(other.net(), other.positions()) < k_settled);
    CHECK(other.handle_error() == 0);
}
