#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <random>

#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"
#include "solve/methods/methods.h"
#include "solve/parts/length_projection.h"
#include "solve/parts/local_global_step.h"
#include "solve/parts/spring_descent.h"

using namespace chebnet;

namespace {

/// Constraints c_e = ℓ_e / L_e − 1 and their Jacobian with respect to the free vertices, dense.
struct DenseConstraints {
    DenseConstraints(const Net& net, const Positions& x, const std::vector<bool>& is_free)
        : c(edge_ratios(net, x).array() - 1), J(Eigen::MatrixXd::Zero(net.edge_count(), x.size())) {
        for (int e = 0; e < net.edge_count(); ++e) {
            const int a = net.edges()(0, e), b = net.edges()(1, e);
            const Eigen::RowVector3d u = (x.col(a) - x.col(b)).normalized() / net.rest_lengths()[e];
            if (is_free[a]) J.block<1, 3>(e, 3 * a) = u;
            if (is_free[b]) J.block<1, 3>(e, 3 * b) = -u;
        }
    }
    Eigen::VectorXd c;
    Eigen::MatrixXd J;
};

Editor dragged_patch(const char* method) {
    Editor editor(samples::patch(15, 12));
    editor.set_method(method);
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 14, 165, 179}));
    return editor;
}

const Eigen::Vector3d k_far_pull(-1.5, -1.0, 2.0);

}  // namespace

TEST_CASE("A projection is the move of least norm that meets the linearised lengths") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = GENERATE(0, 1) == 0 ? samples::patch(6, 5) : samples::mixed_mesh();
    const Topology topology(net);
    const std::vector<bool> is_free = free_vertices(net.vertex_count(), std::vector<int>{0, 4});
    const Positions before = samples::shaken(net.rest_positions(), 0.02, random);
    const DenseConstraints dense(net, before, is_free);

    LengthProjection lengths(net, topology);
    lengths.set_free(is_free);
    Positions x = before;
    REQUIRE(lengths.project(x));
    const Eigen::VectorXd move = (x - before).reshaped();
    // What is asked of a Newton step, and that no part of the move is one that changes no length.
    CHECK((dense.J * move + dense.c).norm() <= 0.03 * dense.c.norm());
    const Eigen::VectorXd shortest = dense.J.completeOrthogonalDecomposition().solve(dense.J * move);
    CHECK((move - shortest).norm() < 1e-12 * move.norm());
}

TEST_CASE("Where feet slide a projection is the least move in the coordinates that they leave free") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = GENERATE(0, 1) == 0 ? samples::patch(6, 5) : samples::mixed_mesh();
    const Topology topology(net);
    const std::vector<bool> is_free = free_vertices(net.vertex_count(), std::vector<int>{0});
    const std::vector<Slide> slides{{4, 3}, {2, 4}, {net.vertex_count() - 1, 5}};
    const Positions before = samples::shaken(net.rest_positions(), 0.02, random);
    DenseConstraints dense(net, before, is_free);
    for (const auto& [vertex, along] : slides)
        for (int k = 0; k < 3; ++k)
            if (!has_axis(along, k)) dense.J.col(3 * vertex + k).setZero();

    LengthProjection lengths(net, topology);
    lengths.set_free(is_free, slides);
    Positions x = before;
    REQUIRE(lengths.project(x));
    for (const auto& [vertex, along] : slides) CHECK(across(along, x.col(vertex)) == across(along, before.col(vertex)));
    const Eigen::VectorXd move = (x - before).reshaped();
    CHECK((dense.J * move + dense.c).norm() <= 0.03 * dense.c.norm());
    // First-order condition: the move is a sum of constraint gradients.
    const Eigen::VectorXd shortest = dense.J.completeOrthogonalDecomposition().solve(dense.J * move);
    CHECK((move - shortest).norm() < 1e-12 * move.norm());
}

TEST_CASE("Projections converge quadratically and never move a held vertex") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = samples::patch(12, 12);
    const Topology topology(net);
    const std::vector<bool> is_free = free_vertices(net.vertex_count(), std::vector<int>{0, 143});
    Positions x = samples::shaken(net.rest_positions(), 0.01, random);
    const Positions before = x;
    LengthProjection lengths(net, topology);
    lengths.set_free(is_free);
    // dL is the square of the error, and the inexact later systems leave a hundredth of it.
    double deviation = max_deviation(net, x);
    for (int k = 0; k < 5 && deviation > 1e-20; ++k) {
        REQUIRE(lengths.project(x));
        const double next = max_deviation(net, x);
        CHECK(next < std::max(1e-20, 1e-2 * deviation));
        deviation = next;
    }
    CHECK(deviation < 1e-15);
    CHECK(x.col(0) == before.col(0));
    CHECK(x.col(143) == before.col(143));
}

TEST_CASE("A projection of exact lengths moves nothing") {
    const Net net = samples::cube();
    const Topology topology(net);
    LengthProjection projection(net, topology);
    projection.set_free(std::vector<bool>(8, true));
    Positions positions = net.rest_positions();
    for (int time = 0; time < 2; ++time) CHECK(projection.project(positions));
    CHECK(positions == net.rest_positions());
}

TEST_CASE("The first step of the spring descent is a local-global iteration, and its energy never rises") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = samples::patch(8, 7);
    LaplacianPart part(net, free_vertices(net.vertex_count(), std::vector<int>{0, 7, 55}));
    Positions x = samples::shaken(net.rest_positions(), 0.2, random), y = x;
    SpringDescent springs(part);
    springs.start(x, x);
    LocalGlobalStep local_global(part);
    const double start = springs.energy();
    REQUIRE(springs.iterate(x));
    local_global.iterate(y);
    CHECK((x - y).norm() < 1e-10);

    double energy = springs.energy();
    CHECK(energy < start);
    for (int k = 0; k < 30; ++k) {
        springs.iterate(x);
        local_global.iterate(y);
        CHECK(springs.energy() <= energy);
        energy = springs.energy();
    }
    // What it learns is worth having: the plain iteration is far behind by now.
    local_global.project(y);
    CHECK(energy < 0.1 * local_global.energy(y));
}

TEST_CASE("The projection method converges with handles exact, and bends the net no more than the paper's") {
    Editor ours = dragged_patch("projection"), paper = dragged_patch("li2022");
    for (Editor* editor : {&ours, &paper}) {
        editor->move_handle(179, editor->net().rest_positions().col(179) + k_far_pull);
        REQUIRE(editor->solve().status == Status::converged);
        CHECK(editor->handle_error() == 0);
    }
    CHECK(bend(ours.net(), ours.topology(), ours.positions()) <=
          bend(paper.net(), paper.topology(), paper.positions()));
}

TEST_CASE("A drag in small steps ends about as fair as one large step, every frame exact") {
    Editor slow = dragged_patch("projection"), fast = dragged_patch("projection");
    const Eigen::Vector3d rest = slow.net().rest_positions().col(179);
    for (int frame = 1; frame <= 40; ++frame) {
        slow.move_handle(179, rest + frame / 40.0 * k_far_pull);
        REQUIRE(slow.solve().status == Status::converged);
    }
    fast.move_handle(179, rest + k_far_pull);
    REQUIRE(fast.solve().status == Status::converged);
    const double slow_bend = bend(slow.net(), slow.topology(), slow.positions());
    const double fast_bend = bend(fast.net(), fast.topology(), fast.positions());
    CHECK(slow_bend < 1.2 * fast_bend);
}

TEST_CASE("A drag may begin where a solve had nothing to do") {
    Editor editor = dragged_patch("projection");
    REQUIRE(editor.solve().iterations == 0);
    editor.move_handle(179, editor.net().rest_positions().col(179) + 0.1 * k_far_pull);
    CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("Somebody else moving the net does not make the projection method jump back") {
    Editor editor = dragged_patch("projection");
    editor.move_handle(179, editor.net().rest_positions().col(179) + k_far_pull);
    editor.solve();
    const Positions shaped = editor.positions();
    // Undo far away and back again: the copy that remembers the drag must not be trusted any more.
    editor.set_positions(editor.net().rest_positions());
    editor.solve();
    editor.set_positions(shaped);
    CHECK(editor.solve().iterations == 0);
    CHECK(editor.positions() == shaped);
}

TEST_CASE("A locality about a net that has its lengths gives the projection method nothing to do") {
    Editor editor = dragged_patch("projection");
    editor.move_handle(179, editor.net().rest_positions().col(179) + k_far_pull);
    REQUIRE(editor.solve().status == Status::converged);
    const Positions shaped = editor.positions();
    editor.set_locality(5, std::vector{179});
    REQUIRE(!editor.region()->pulls.empty());
    CHECK(editor.solve().iterations == 0);
    CHECK(editor.positions() == shaped);
}

/// The stages that a solve goes through, one after the other.
std::vector<int> stages(const SolveReport& report) {
    std::vector<int> passed;
    for (const TraceRow& row : report.trace)
        if (passed.empty() || passed.back() != row.stage) passed.push_back(row.stage);
    return passed;
}

/// A staircase pulled up: flat parts between folds, whose lengths hardly any small move can change.
Editor pulled_stairs(double edge_lengths) {
    Shape shape = make_shape("steps:vertices=300");
    Editor editor(std::move(shape.net));
    editor.set_method("projection");
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), shape.suggested_handles);
    handles.back().target += Eigen::Vector3d(0, 0, edge_lengths * editor.net().mean_length());
    editor.set_handles(handles);
    return editor;
}

TEST_CASE("Where projecting fails, the net becomes smoother first") {
    Editor editor = pulled_stairs(2.5);
    editor.set_option("threshold", "1e-9");  // beyond what springs get to by themselves
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    const std::vector<int> passed = stages(report);
    REQUIRE(passed.size() >= 5);
    CHECK(std::vector<int>(passed.begin(), passed.begin() + 5) == std::vector{1, 2, 3, 2, 3});
}

TEST_CASE("Where springs do not help, Gauss-Newton has the last word, and an honest one") {
    Editor editor = pulled_stairs(4);
    const SolveReport report = editor.solve();
    CHECK(stages(report).back() == 4);
    CHECK(report.status != Status::converged);
    CHECK(report.max_deviation < 0.01);
    CHECK(editor.handle_error() == 0);
}

TEST_CASE("Out of reach, the projection method says so and stays finite") {
    Editor editor = dragged_patch("projection");
    editor.move_handle(179, {100, 0, 0});
    CHECK(editor.solve().status == Status::unreachable);
    CHECK(editor.positions().allFinite());
    CHECK(editor.handle_error() == 0);
    editor.move_handle(179, editor.net().rest_positions().col(179));
    CHECK(editor.solve().status == Status::converged);
}
