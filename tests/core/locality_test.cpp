#include "edit/locality.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "edit/editor.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

constexpr double k_everything = std::numeric_limits<double>::infinity();

Editor elephant() {
    Shape shape = make_shape("elephant:vertices=900");
    Editor editor(std::move(shape.net));
    editor.set_handles(samples::handles_at_rest(editor.net(), shape.suggested_handles));
    return editor;
}

/// Moves the last handle up by so many edge lengths in small steps, the net within the locality; the worst status of
/// all frames.
Status lift(Editor& editor, double edge_lengths, double locality) {
    const Handle handle = editor.handles().back();
    editor.set_locality(locality, std::vector{handle.vertex});
    Status worst = Status::converged;
    for (int frame = 1; frame <= 10; ++frame) {
        const double height = frame / 10.0 * edge_lengths * editor.net().mean_length();
        editor.move_handle(handle.vertex, handle.target + height * Eigen::Vector3d::UnitZ());
        const Status status = editor.solve().status;
        if (status != Status::converged && keeps_lengths(worst)) worst = status;
    }
    return worst;
}

/// How far along the net from the last handle, in edge lengths, the farthest vertex is that is not where it was.
double farthest_moved(const Editor& editor, const Positions& before) {
    const std::vector<double> distance = editor.topology().distances_from(editor.handles().back().vertex);
    double farthest = 0;
    for (int v = 0; v < editor.net().vertex_count(); ++v)
        if (editor.positions().col(v) != before.col(v)) farthest = std::max(farthest, distance[v]);
    return farthest / editor.net().mean_length();
}

}  // namespace

TEST_CASE("A locality counts edges, whatever their lengths have grown to") {
    const auto around = [](double scale) {
        Editor editor(samples::patch(21, 21, 0));
        editor.set_option("length_scale", std::to_string(scale));
        editor.set_handles(samples::handles_at_rest(editor.net(), {220}));
        editor.set_locality(5, std::vector{220});
        return editor;
    };
    const Editor as_it_was = around(1), twice = around(2);
    CHECK(twice.region()->outside == as_it_was.region()->outside);
    CHECK(twice.mobility(5, std::vector{220}) == as_it_was.mobility(5, std::vector{220}));
    const std::vector<Ball> balls = twice.reach(220);
    REQUIRE(balls.size() == as_it_was.reach(220).size());
    for (std::size_t k = 0; k < balls.size(); ++k) CHECK(balls[k].radius == Approx(2 * as_it_was.reach(220)[k].radius));
    CHECK(twice.unreachable_pairs().empty());
}

TEST_CASE("A region is what lies within its radius, held the more the closer to its border") {
    const Net net = samples::patch(21, 21, 0);
    const Topology topology(net);
    const Region region = region_around(net, topology, net.rest_positions(), std::vector{220}, 8);
    const std::vector<double> distance = topology.distances_from(220);
    CHECK(std::ranges::is_sorted(region.outside));
    for (int v : region.outside) CHECK(distance[v] >= 8 - 1e-6);
    CHECK(region.outside.size() == 21 * 21 - 113u);  // 1 + 4 · (1 + … + 7)
    CHECK(region.border.size() == 32);
    for (const Region::BorderVertex& border : region.border) {
        CHECK(border.origin == 220);
        CHECK(border.distance == Approx(8));
    }

    std::vector<double> weight_at(8, 0);
    for (const Pull& pull : region.pulls) {
        CHECK(pull.target == net.rest_positions().col(pull.vertex));
        weight_at[std::lround(distance[pull.vertex])] = pull.weight;
    }
    for (int d = 0; d <= 4; ++d) CHECK(weight_at[d] == 0);
    for (int d = 5; d < 8; ++d) CHECK(weight_at[d] > weight_at[d - 1]);

    const Eigen::VectorXf freely = mobility(net, topology, std::vector{220}, 8);
    for (int v = 0; v < net.vertex_count(); ++v) {
        const double w = weight_at[std::min(std::lround(distance[v]), 7L)];
        if (region.is_outside(v))
            CHECK(freely[v] == 0);
        else if (w < 1)
            CHECK(freely[v] == Approx(1 / (1 + std::sqrt(w) * 4)));
    }
}

TEST_CASE("What lies beyond the locality stays where it is, bit for bit, and every edge keeps its length", "[large]") {
    const double radius = GENERATE(8.0, 16.0);
    Editor editor = elephant();
    const Positions before = editor.positions();
    CHECK(keeps_lengths(lift(editor, 1.5, radius)));
    CHECK(max_deviation(editor.net(), editor.positions()) < 1e-6);
    CHECK(farthest_moved(editor, before) < radius);
    CHECK(farthest_moved(editor, before) > radius / 2);
    // The border is no handle: it can be anywhere.
    CHECK(editor.handle_error() == 0);
}

TEST_CASE("Without a limit, locality changes nothing") {
    Editor plain = elephant(), narrowed = elephant();
    narrowed.set_locality(5, std::vector{narrowed.handles().back().vertex});
    CHECK(lift(plain, 2, k_everything) == Status::converged);
    CHECK(lift(narrowed, 2, k_everything) == Status::converged);
    CHECK(plain.positions() == narrowed.positions());
}

TEST_CASE("A region too small for the drag ends as an honest status, and only it has moved") {
    Editor editor = elephant();
    const Positions before = editor.positions();
    CHECK(lift(editor, 6, 4) == Status::unreachable);
    CHECK(editor.positions().allFinite());
    CHECK(editor.handle_error() == 0);
    CHECK(farthest_moved(editor, before) < 4);
    const std::vector<UnreachablePair> pairs = editor.unreachable_pairs();
    REQUIRE_FALSE(pairs.empty());
    CHECK(pairs.back().vertex_a == editor.handles().back().vertex);
    CHECK(pairs.back().distance > pairs.back().reach);
    editor.move_handle(pairs.back().vertex_a, before.col(pairs.back().vertex_a));
    CHECK(editor.unreachable_pairs().empty());
    CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("Every method keeps to the locality") {
    for (const MethodInfo& method : method_table()) {
        CAPTURE(method.name);
        Editor editor = elephant();
        editor.set_method(method.name);
        editor.set_option("max_iterations", "5");
        const Positions before = editor.positions();
        lift(editor, 1, 8);
        CHECK(editor.positions().allFinite());
        CHECK(farthest_moved(editor, before) < 8);
    }
}

TEST_CASE("Each drag begins where the net stands, other edits free everything", "[large]") {
    Editor editor = elephant();
    CHECK(keeps_lengths(lift(editor, 1, 12)));
    const Positions once = editor.positions();
    CHECK(keeps_lengths(lift(editor, 1, 8)));
    CHECK(farthest_moved(editor, once) < 8);

    const Handle first = editor.handles().front();
    const Positions twice = editor.positions();
    editor.move_handle(first.vertex, first.target + 0.5 * editor.net().mean_length() * Eigen::Vector3d::UnitX());
    CHECK(keeps_lengths(editor.solve().status));
    CHECK(farthest_moved(editor, twice) > 8);
}

TEST_CASE("Several handles move what is near any of them") {
    const Net net = samples::patch(21, 21, 0);
    const Topology topology(net);
    const std::vector<int> both{22, 418};
    const Region region = region_around(net, topology, net.rest_positions(), both, 3);
    const Region one = region_around(net, topology, net.rest_positions(), std::vector{22}, 3);
    const int moving_with_one = net.vertex_count() - static_cast<int>(one.outside.size());
    CHECK(net.vertex_count() - static_cast<int>(region.outside.size()) == 2 * moving_with_one);
    for (const Region::BorderVertex& border : region.border) CHECK(border.origin == (border.vertex < 220 ? 22 : 418));
}

TEST_CASE("Soft handles within a region pull, those beyond it stay") {
    Editor editor = elephant();
    std::vector<Handle> handles = editor.handles();
    for (Handle& handle : handles) handle.weight = 1;
    handles.back().weight = 50;
    editor.set_handles(handles);
    REQUIRE(editor.solve().status == Status::converged);
    const Positions before = editor.positions();
    CHECK(keeps_lengths(lift(editor, 1, 10)));
    CHECK(farthest_moved(editor, before) > 0);
    CHECK(farthest_moved(editor, before) < 10);
}

TEST_CASE("Without a limit every piece of a net may move") {
    const Editor editor(samples::twice(samples::patch(4, 3), {10, 0, 0}));
    CHECK(editor.mobility(k_everything, std::vector{0}) == Eigen::VectorXf::Ones(24));
    CHECK(editor.mobility(100, std::vector{0}).tail(12) == Eigen::VectorXf::Zero(12));
}

TEST_CASE("A locality that is no length, or is nowhere, is refused") {
    Editor editor = elephant();
    for (const double radius : {0.0, -1.0, std::nan("")})
        CHECK_THROWS_AS(editor.set_locality(radius, std::vector{3}), Error);
    CHECK_THROWS_AS(editor.set_locality(3, std::vector{-1}), Error);
}
