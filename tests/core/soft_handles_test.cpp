#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "base/error.h"
#include "counting_method.h"
#include "edit/editor.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"
#include "solve/methods/methods.h"
#include "solve/parts/laplacian_part.h"
#include "solve/parts/spring_descent.h"

using namespace chebnet;

namespace {

constexpr double k_rigid = std::numeric_limits<double>::infinity();
const Eigen::Vector3d k_soft_pull(-1.5, -1.0, 2.0);

/// A patch held at three corners; its fourth, 179, pulls with a weight.
Editor softly_held_patch(double weight) {
    Editor editor(samples::patch(15, 12));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 14, 165, 179});
    handles.back().weight = weight;
    editor.set_handles(handles);
    return editor;
}

double distance_from_target(const Editor& editor, const Handle& handle) {
    return (editor.positions().col(handle.vertex) - handle.target).norm();
}

/// Moves the last handle by `pull` in small steps.
void drag(Editor& editor, const Eigen::Vector3d& pull) {
    const int vertex = editor.handles().back().vertex;
    const Eigen::Vector3d from = editor.handles().back().target;
    for (int frame = 1; frame <= 20; ++frame) {
        editor.move_handle(vertex, from + frame / 20.0 * pull);
        REQUIRE(editor.solve().status == Status::converged);
    }
}

ErrorCode code_of_weight(double weight) {
    try {
        softly_held_patch(weight);
    } catch (const Error& error) {
        return error.code();
    }
    FAIL("nothing was refused");
    return {};
}

/// The norm of the gradient by central differences, over the free vertices.
template <typename Energy>
double differentiated(Energy energy, const Positions& at, const std::vector<int>& vertices) {
    const double h = 1e-6;
    double sum = 0;
    for (int v : vertices)
        for (int axis = 0; axis < 3; ++axis) {
            Positions above = at, below = at;
            above(axis, v) += h;
            below(axis, v) -= h;
            const double slope = (energy(above) - energy(below)) / (2 * h);
            sum += slope * slope;
        }
    return std::sqrt(sum);
}

}  // namespace

TEST_CASE("The heavier a soft handle, the closer it comes to its target, and every edge keeps its length") {
    double last = k_soft_pull.norm();
    for (const double weight : {0.01, 0.1, 1.0, 10.0, 100.0}) {
        CAPTURE(weight);
        Editor editor = softly_held_patch(weight);
        drag(editor, k_soft_pull);
        const double distance = distance_from_target(editor, editor.handles().back());
        CHECK(distance < last);
        CHECK(max_deviation(editor.net(), editor.positions()) < 1e-6);
        CHECK(editor.handle_error() == 0);
        last = distance;
    }
    CHECK(last < 0.01);
}

TEST_CASE("The limit of weights is the exact handle") {
    Editor exact = softly_held_patch(k_rigid), heavy = softly_held_patch(1e6);
    drag(exact, k_soft_pull);
    drag(heavy, k_soft_pull);
    CHECK(distance_from_target(heavy, heavy.handles().back()) < 1e-4);
    CHECK((heavy.positions() - exact.positions()).colwise().norm().maxCoeff() < 0.1 * k_soft_pull.norm());
    CHECK(bend(heavy.net(), heavy.topology(), heavy.positions()) ==
          Approx(bend(exact.net(), exact.topology(), exact.positions())).epsilon(0.1));
}

TEST_CASE("A net comes to rest however hard a handle pulls, and in few steps up to a hundred times an edge",
          "[large]") {
    const double weight = GENERATE(0.01, 1.0, 100.0, 1e4, 1e6);
    CAPTURE(weight);
    Editor editor = softly_held_patch(weight);
    const Eigen::Vector3d from = editor.handles().back().target;
    for (int frame = 1; frame <= 10; ++frame) {
        editor.move_handle(179, from + frame / 10.0 * k_soft_pull);
        const SolveReport report = editor.solve();
        REQUIRE(report.status == Status::converged);
        if (weight <= 100) CHECK(report.iterations < 20);
    }
}

TEST_CASE("A soft handle with hardly any weight does not move the net") {
    Editor editor = softly_held_patch(1e-9);
    editor.move_handle(179, editor.net().rest_positions().col(179) + k_soft_pull);
    CHECK(editor.solve().status == Status::converged);
    CHECK((editor.positions() - editor.net().rest_positions()).colwise().norm().maxCoeff() < 1e-6);
}

TEST_CASE("A soft handle farther away than numbers reach draws as one nearer by, and leaves the net one") {
    for (const char* method : {"projection", "equilibrium"})
        for (const double away : {1e8, 1e10, 1e200}) {
            CAPTURE(method, away);
            Editor editor(samples::patch(10, 10, 0));
            editor.set_method(method);
            std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 99});
            handles.back().target *= away;
            handles.back().weight = 1;
            editor.set_handles(handles);
            const SolveReport report = editor.solve();
            CHECK(keeps_lengths(report.status));
            CHECK(report.max_deviation < editor.options().threshold);
            CHECK(editor.positions().col(99).norm() > 17);  // of 18, stretched towards it
        }
}

TEST_CASE("Two soft handles that pull too far apart end balanced on a taut net") {
    const double weight = GENERATE(1.0, 100.0, 1e6);
    CAPTURE(weight);
    Editor editor(samples::patch(15, 12));
    editor.set_method("projection");
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 179});
    const Eigen::Vector3d apart = 15 * (handles[1].target - handles[0].target).normalized();
    handles[0].target -= apart;
    handles[1].target += apart;
    for (Handle& handle : handles) handle.weight = weight;
    editor.set_handles(handles);
    CHECK(editor.unreachable_pairs().empty());
    REQUIRE(editor.solve().status == Status::converged);
    CHECK(max_deviation(editor.net(), editor.positions()) < 1e-6);

    const Eigen::Vector3d a = editor.positions().col(0), b = editor.positions().col(179);
    const Eigen::Vector3d pull_a = handles[0].target - a, pull_b = handles[1].target - b;
    CHECK((pull_a + pull_b).norm() < 1e-3 * pull_a.norm());
    const double reach = editor.topology().distances_from(0)[179];
    CHECK((a - b).norm() > 0.99 * reach);
    CHECK((a - b).norm() <= (1 + 1e-3) * reach);
}

TEST_CASE("Where soft handles and exact ones disagree, the exact ones and the edges win") {
    Editor editor = softly_held_patch(10);
    editor.move_handle(179, {100, 0, 0});
    CHECK(editor.unreachable_pairs().empty());
    CHECK(keeps_lengths(editor.solve().status));
    CHECK(editor.handle_error() == 0);
    editor.move_handle(179, editor.net().rest_positions().col(179));
    CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("A soft handle gives way to an exact one that is dragged, and every frame is exact") {
    Shape shape = make_shape("dome:vertices=600");
    Editor editor(std::move(shape.net));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), shape.suggested_handles);
    for (std::size_t i = 0; i + 1 < handles.size(); ++i) handles[i].weight = 1;
    editor.set_handles(handles);
    drag(editor, Eigen::Vector3d(0, 0, 10 * editor.net().mean_length()));
    CHECK(distance_from_target(editor, handles.front()) > 0);
}

TEST_CASE("Weights and targets of soft handles keep the symbolic work, softening a handle renews it") {
    int prepared = 0;
    Editor editor = softly_held_patch(1);
    editor.set_method(std::make_unique<samples::CountingMethod>(k_projection.make(), prepared), "counted");
    editor.solve();
    std::vector<Handle> handles = editor.handles();
    handles.back().weight = 5;
    handles.back().target += k_soft_pull;
    editor.set_handles(handles);
    CHECK(editor.solve().iterations > 0);
    CHECK(prepared == 1);
    handles.front().weight = 5;
    editor.set_handles(handles);
    editor.solve();
    CHECK(prepared == 2);
    CHECK(editor.solve().iterations == 0);
}

TEST_CASE("Weights out of range, and methods that know none, are refused by name") {
    for (const double weight : {0.0, -1.0, std::nan("")}) CHECK(code_of_weight(weight) == ErrorCode::bad_option);
    Editor soft = softly_held_patch(1);
    CHECK_THROWS_WITH(soft.set_method("li2022"), Catch::Contains("li2022") && Catch::Contains("179"));
    CHECK(soft.method() == k_default_method);
    Editor exact = softly_held_patch(k_rigid);
    exact.set_method("li2022");
    CHECK_THROWS_WITH(exact.set_handles(soft.handles()), Catch::Contains("li2022"));
    CHECK(exact.handles().back().is_exact());
}

TEST_CASE("The gradients of pulls are those of their energies, and a fit is the minimum") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = samples::patch(5, 4);
    const bool floating = GENERATE(false, true);
    LaplacianPart part(net, free_vertices(net.vertex_count(), floating ? std::vector<int>{} : std::vector<int>{0, 4}));
    const std::vector<Pull> pulls{{7, {1, 2, 3}, 0.5}, {12, {0, -1, 2}, 20}};
    part.set_pulls(pulls);
    Positions x = samples::shaken(net.rest_positions(), 0.2, random);
    const Positions centres = samples::shaken(x, 1, random);

    SpringDescent springs(part);
    const auto springs_energy = [&](const Positions& at) {
        springs.start(at, centres);
        return springs.energy();
    };
    const double by_differences = differentiated(springs_energy, x, part.part().vertices());
    springs_energy(x);
    CHECK(springs.gradient_norm() == Approx(by_differences).epsilon(1e-5));

    const Eigen::Matrix3Xd vectors = Eigen::Matrix3Xd::Random(3, net.edge_count());
    const auto fit_energy = [&](const Positions& at) {
        double sum = 0;
        for (int e = 0; e < net.edge_count(); ++e)
            sum += (at.col(net.edges()(0, e)) - at.col(net.edges()(1, e)) - vectors.col(e)).squaredNorm();
        for (const Pull& pull : pulls) sum += pull.weight * (at.col(pull.vertex) - pull.target).squaredNorm();
        return sum;
    };
    const double slope = differentiated(fit_energy, x, part.part().vertices());
    CHECK(part.fit(vectors, x) == Approx(slope).epsilon(1e-5));
    CHECK(part.fit(vectors, x) < 1e-4 * slope);  // single precision
}

TEST_CASE("A net that hangs on one soft handle alone goes along with it, however stiff that is") {
    const double weight = GENERATE(1.0, 100.0, 1e6, 1e30, 1e308);
    CAPTURE(weight);
    const Net net = samples::patch(11, 11, 0.4);
    Editor editor(net);
    Handle handle = samples::handles_at_rest(net, {1}).front();
    handle.weight = weight;
    editor.set_handles({handle});
    const Eigen::Vector3d way(1, -2, 8);
    for (int frame = 1; frame <= 4; ++frame) {
        editor.move_handle(1, handle.target + frame / 4.0 * way);
        const SolveReport report = editor.solve();
        CHECK(report.status == Status::converged);
        CHECK(report.iterations <= 2);
    }
    CHECK((editor.positions() - net.rest_positions()).colwise().norm().maxCoeff() == Approx(way.norm()));
    CHECK(distance_from_target(editor, editor.handles().front()) < 1e-9);
}

TEST_CASE("What hangs on one soft handle and comes to rest there stays, though nearer to it there is less pull") {
    Editor editor(samples::patch(11, 11, 0.4));
    Handle handle = samples::handles_at_rest(editor.net(), {60}).front();
    handle.weight = 20;
    handle.target.x() += 3;
    editor.set_handles({handle});
    editor.set_option("gravity", "0.05");
    REQUIRE(keeps_lengths(editor.solve().status));
    const double below = handle.target.z() - editor.positions()(2, 60);
    CHECK(below == Approx(0.05 * editor.net().edge_count() / (2 * handle.weight)).epsilon(1e-3));
    Editor other(editor.net());
    other.set_state(editor.state());
    other.solve();
    CHECK((other.positions() - editor.positions()).colwise().norm().maxCoeff() < 1e-3);
}

TEST_CASE("A soft handle that jumps leads the net where a hand would, however stiff it is, and it stays there",
          "[large]") {
    const double weight = GENERATE(1., 30., 1000., 1e5);
    CAPTURE(weight);
    const Net net = samples::patch(21, 21);
    std::vector<Handle> handles = samples::handles_at_rest(net, {0, 20, 220, 440});
    handles.back().weight = weight;
    Editor dragged(net), jumped(net);
    for (Editor* editor : {&dragged, &jumped}) editor->set_handles(handles);
    const Eigen::Vector3d pull(-1, -2, 4);
    drag(dragged, pull);
    jumped.move_handle(440, handles.back().target + pull);
    REQUIRE(jumped.solve().status == Status::converged);
    CHECK(new_folds(net, net.rest_positions(), jumped.positions()) == 0);
    const double apart = (jumped.positions() - dragged.positions()).norm() / std::sqrt(net.vertex_count());
    CHECK(apart < 1e-3 * net.mean_length());
    Editor opened(net);
    opened.set_state(jumped.state());
    const SolveReport again = opened.solve();
    CHECK(again.status == Status::converged);
    CHECK(again.iterations <= 2);
    CHECK((opened.positions() - jumped.positions()).cwiseAbs().maxCoeff() < 1e-5);
}

TEST_CASE("A soft handle that jumps is on its way when a budget ends, and goes on from there") {
    const Net net = samples::patch(21, 21);
    std::vector<Handle> handles = samples::handles_at_rest(net, {0, 20, 220, 440});
    handles.back().weight = 1000;
    Editor at_once(net), in_pieces(net);
    for (Editor* editor : {&at_once, &in_pieces}) {
        editor->set_handles(handles);
        editor->move_handle(440, handles.back().target + Eigen::Vector3d(0, -1, 4));
    }
    REQUIRE(at_once.solve().status == Status::converged);
    in_pieces.set_option("max_iterations", "2");
    double distance = 4;
    for (int piece = 0; piece < 2; ++piece) {
        const SolveReport report = in_pieces.solve();
        CHECK(report.status == Status::max_iterations);
        CHECK(report.max_deviation < 1e-6);
        const double left = distance_from_target(in_pieces, in_pieces.handles().back());
        CHECK(left < distance - 0.5);
        distance = left;
    }
    in_pieces.set_option("max_iterations", "200");
    REQUIRE(in_pieces.solve().status == Status::converged);
    CHECK((in_pieces.positions() - at_once.positions()).norm() < 1e-3 * std::sqrt(net.vertex_count()));
}

TEST_CASE("A flat sheet that a soft handle pushes together bows out of its plane, however stiff that is") {
    const double weight = GENERATE(1., 100., 1e4);
    CAPTURE(weight);
    const Net net = samples::patch(16, 16, 0);
    std::vector<Handle> handles = samples::handles_at_rest(net, {15, 240, 0, 255});
    handles.back().weight = weight;
    Editor pushed(net), dragged(net);
    for (Editor* editor : {&pushed, &dragged}) editor->set_handles(handles);
    const Eigen::Vector3d push = -2 / std::sqrt(2.0) * net.mean_length() * Eigen::Vector3d(1, 1, 0);
    pushed.move_handle(255, handles.back().target + push);
    CHECK(pushed.solve().status == Status::converged);
    drag(dragged, push);
    for (const Editor* editor : {&pushed, &dragged}) {
        const auto heights = editor->positions().row(2);
        CHECK(heights.maxCoeff() - heights.minCoeff() > 2 * net.mean_length());
        CHECK(distance_from_target(*editor, editor->handles().back()) < net.mean_length());
    }
}
