#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "constants.h"
#include "first_order.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "sample_surfaces.h"
#include "shapes/shapes.h"
#include "solve/method.h"

using namespace chebnet;

namespace {

/// Handles at some vertices of a net, and how far each moves.
struct Edit {
    std::string name;
    Net net;
    std::vector<int> vertices;
    std::vector<Eigen::Vector3d> moves;
};

/// A patch held at three corners, its fourth pulled inwards and up.
Edit corner_pull(double amount) {
    return {"corner pull",
            samples::patch(8, 7),
            {0, 7, 48, 55},
            {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
             amount * Eigen::Vector3d(-1, -1, 1)}};
}

/// A flat sheet whose four corners come in and whose middle is lifted.
Edit lifted_sheet(int n, double lift) {
    const int last = n - 1, middle = n / 2;
    const double in = 0.1 * n;
    return {"lifted sheet",
            samples::patch(n, n, 0),
            {0, last, n * last, n * n - 1, n * middle + middle},
            {{in, in, 0}, {-in, in, 0}, {in, -in, 0}, {-in, -in, 0}, {0, 0, lift}}};
}

/// An arched patch held at its corners, whose crown is moved aside and down.
Edit moved_crown() {
    return {"moved crown",
            samples::patch(9, 9),
            {0, 8, 72, 80, 40},
            {Eigen::Vector3d::Zero(),
             Eigen::Vector3d::Zero(),
             Eigen::Vector3d::Zero(),
             Eigen::Vector3d::Zero(),
             {0.8, 0.4, -0.5}}};
}

/// An arched patch held at its crown and pulled at two opposite corners, which shears it.
Edit pulled_diagonal() {
    return {"pulled diagonal", samples::patch(9, 9, 0.4), {0, 80, 40}, {{-0.9, -0.9, 0}, {0.9, 0.9, 0}, {0, 0, 0}}};
}

Editor at_rest(const Edit& edit) {
    Editor editor(edit.net);
    editor.set_method("equilibrium");
    editor.set_handles(samples::handles_at_rest(edit.net, edit.vertices));
    return editor;
}

/// Moves the handles in so many equal steps, each a frame of one iteration, and lets the net settle.
SolveReport drag(Editor& editor, const Edit& edit, int frames) {
    for (int frame = 1; frame <= frames; ++frame) {
        for (std::size_t i = 0; i < edit.vertices.size(); ++i)
            editor.move_handle(edit.vertices[i],
                               edit.net.rest_positions().col(edit.vertices[i]) + edit.moves[i] * frame / frames);
        if (frame < frames) editor.solve({.iterations = 1});
    }
    return editor.solve();
}

bool is_within_limit(const Editor& editor) {
    const double limit = editor.options().shear_limit - 0.1 * samples::k_degree;
    return corner_angle_range(editor.net(), editor.positions()).smallest > limit;
}

double rms_distance(const Edit& edit, const Positions& a, const Positions& b) {
    return std::sqrt((a - b).squaredNorm() / static_cast<double>(a.cols())) / edit.net.mean_length();
}

}  // namespace

TEST_CASE("A corner that is folded onto the one across opens") {
    const Net flat = samples::patch(11, 11, 0);
    Positions folded = flat.rest_positions();
    folded.col(0) = folded.col(12);
    Editor editor(Net(folded, flat.faces()));
    editor.set_handles(samples::handles_at_rest(editor.net(), {10, 110, 120}));
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.max_deviation < 1e-9);
    CHECK(is_within_limit(editor));
}

TEST_CASE("A quad whose edges keep a corner sharper than the limit does not keep the net from its rest") {
    const Net flat = samples::patch(8, 8, 0);
    Positions x = flat.rest_positions();
    x.col(0) << 0.85, 0.12,
        0;  // vertex 1 is at (1, 0), vertex 8 at (0, 1): a kite of two short edges and two long ones
    x.col(9) << 1.05, 0.17, 0;
    const Net kite(x, flat.faces());
    Editor editor(kite);
    editor.set_handles(samples::handles_at_rest(kite, {7, 56, 63}));
    editor.move_handle(63, {6.5, 6.5, 1});
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    CHECK(report.max_deviation < 1e-9);
}

TEST_CASE("The shape of rest is that of the threshold of now, whatever it was before") {
    const unsigned seed = 7;
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net even = samples::patch(9, 8);
    const Net net(samples::shaken(even.rest_positions(), 0.05, random), even.faces(), RestLengths::equal);
    const auto at_home = [&](const std::vector<const char*>& thresholds) {
        Editor editor(net);
        editor.set_handles(samples::handles_at_rest(net, {0, 8, 71}));
        for (const char* threshold : thresholds) {
            editor.set_option("threshold", threshold);
            editor.move_handle(71, net.rest_positions().col(71) + Eigen::Vector3d(-1, 0, 1));
            editor.solve();
        }
        editor.move_handle(71, net.rest_positions().col(71));
        CHECK(editor.solve().status == Status::converged);
        return editor.positions();
    };
    CHECK(samples::largest_move(at_home({"0.05", "1e-6"}), at_home({"1e-6"})) < 1e-3);
}

TEST_CASE("Equilibrium: lengths, limit, and first-order conditions, reckoned again") {
    for (const Edit& edit : {corner_pull(1), moved_crown(), lifted_sheet(9, 2), pulled_diagonal()}) {
        INFO(edit.name);
        Editor editor = at_rest(edit);
        editor.set_option("shear_limit", "55");
        const SolveReport report = drag(editor, edit, 1);
        CHECK(report.status == Status::converged);
        CHECK(report.max_deviation < 1e-9);
        const Options& options = editor.options();
        CHECK(corner_angle_range(edit.net, editor.positions()).smallest >
              options.shear_limit - 0.01 * samples::k_degree);
        const samples::FirstOrder conditions =
            samples::first_order({edit.net, editor.handles(), options}, editor.positions());
        CHECK(conditions.gradient < 2 * options.rest_tolerance);
        if (edit.name == "pulled diagonal") CHECK(conditions.active > 0);
    }
}

TEST_CASE(
    "Equilibrium: near a guide, on it and outside of it the first-order conditions hold, and it acts as it says") {
    const Edit edit = moved_crown();
    const Positions& rest = edit.net.rest_positions();
    // A dome over the net, through its highest points.
    const auto dome = [&](double x, double y) { return rest.row(2).maxCoeff() - 0.02 * (x * x + y * y); };
    Mesh mesh = samples::graph(21, 12, dome);
    mesh.positions.topRows(2).colwise() += rest.topRows(2).rowwise().mean();
    const auto guide = std::make_shared<const Guide>(Surface(mesh));
    const auto height = [&](const Editor& editor) { return heights_over(*guide, editor.positions()); };

    Editor without = at_rest(edit), with = at_rest(edit);
    drag(without, edit, 1);
    const Eigen::VectorXd before = height(without);
    for (const auto mode : {GuideMode::near, GuideMode::on, GuideMode::outside}) {
        CAPTURE(static_cast<int>(mode));
        with.set_guide(guide);
        with.set_option("guide_mode", std::to_string(static_cast<int>(mode)));
        const SolveReport report = drag(with, edit, 1);
        CHECK(keeps_lengths(report.status));
        CHECK(report.max_deviation < 1e-9);
        CHECK(with.handle_error() == 0);
        const samples::FirstOrder conditions =
            samples::first_order({edit.net, with.handles(), with.options(), guide.get()}, with.positions());
        if (report.status == Status::converged) CHECK(conditions.gradient < 2 * with.options().rest_tolerance);
        if (mode == GuideMode::outside)
            CHECK(height(with).cwiseMin(0.0).squaredNorm() < before.cwiseMin(0.0).squaredNorm());
        else
            CHECK(height(with).squaredNorm() < before.squaredNorm());
    }
    with.set_option("guide_mode", "0");
    drag(with, edit, 1);
    CHECK(rms_distance(edit, with.positions(), without.positions()) < 1e-3);
    with.set_option("guide_mode", "1");
    with.set_guide(nullptr);
    CHECK(drag(with, edit, 1).status == Status::converged);
    CHECK(rms_distance(edit, with.positions(), without.positions()) < 1e-3);
}

TEST_CASE("Equilibrium: outside of a closed guide is outside, whichever way it winds, and of an open one above it") {
    const Edit edit = moved_crown();
    const Positions& rest = edit.net.rest_positions();
    const auto turned = [](const Mesh& mesh) {
        Mesh other{mesh.positions, {}};
        for (int f = 0; f < mesh.faces.size(); ++f) {
            std::vector<int> face(mesh.faces[f].begin(), mesh.faces[f].end());
            std::reverse(face.begin(), face.end());
            other.faces.add(face);
        }
        return other;
    };
    Mesh ball = samples::sphere(8);
    const double size = (rest.rowwise().maxCoeff() - rest.rowwise().minCoeff()).norm() / 2;
    ball.positions *= size;
    ball.positions.colwise() += rest.rowwise().mean() - Eigen::Vector3d(0, 0, size);
    const auto dragged = [&](const Mesh& mesh) {
        Editor editor = at_rest(edit);
        editor.set_guide(std::make_shared<const Guide>(Surface(mesh)));
        editor.set_option("guide_mode", std::to_string(static_cast<int>(GuideMode::outside)));
        drag(editor, edit, 1);
        return editor;
    };
    const Guide outwards{Surface(ball)};
    const Editor right = dragged(ball), wrong = dragged(turned(ball));
    const auto part_inside = [&](const Editor& editor) {
        return (heights_over(outwards, editor.positions()).array() < -0.1 * edit.net.mean_length())
            .cast<double>()
            .mean();
    };
    CHECK(part_inside(right) < 0.2);
    CHECK(rms_distance(edit, wrong.positions(), right.positions()) < 1e-6);

    Mesh half = samples::sphere(8, true);
    half.positions *= size;
    const Positions above = (2 * size) * Eigen::Vector3d::UnitZ();
    CHECK(heights_over(Guide(Surface(half)), above)[0] > 0);
    CHECK(heights_over(Guide(Surface(turned(half))), above)[0] < 0);
    CHECK(heights_over(Guide(Surface(turned(ball))), rest).isApprox(heights_over(outwards, rest), 1e-9));
}

TEST_CASE("Equilibrium: a fine net leaves its guide with a handle rather than crumple on it", "[large]") {
    const int n = 40, middle = n / 2 * n + n / 2;
    const Net net = samples::patch(n, n);
    const Edit edit{"pulled off",
                    net,
                    {0, n - 1, n * n - n, n * n - 1, middle},
                    {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(),
                     Eigen::Vector3d(-6, -3, 9) * net.mean_length(), Eigen::Vector3d::Zero()}};
    const auto guide = std::make_shared<const Guide>(Surface(Mesh{net.rest_positions(), net.faces()}));
    Editor near = at_rest(edit), without = at_rest(edit);
    near.set_guide(guide);
    REQUIRE(keeps_lengths(drag(without, edit, 1).status));
    REQUIRE(keeps_lengths(drag(near, edit, 1).status));
    CHECK(sharp_folds(net, without.positions(), 45 * samples::k_degree) == 0);
    CHECK(sharp_folds(net, near.positions(), 45 * samples::k_degree) == 0);
    // It is near all the same where no handle takes it away.
    const auto distance = [&](const Editor& editor) {
        return heights_over(*guide, editor.positions()).cwiseAbs().mean();
    };
    CHECK(distance(near) < 0.5 * distance(without));
}

TEST_CASE("Equilibrium: without limit a net is sheared farther than with it") {
    const Edit edit = pulled_diagonal();
    Editor free = at_rest(edit);
    free.set_option("shear_limit", "0");
    CHECK(drag(free, edit, 1).status == Status::converged);
    CHECK(corner_angle_range(edit.net, free.positions()).smallest < 54 * samples::k_degree);
}

TEST_CASE("Equilibrium: where no net keeps the limit there is still one with exact lengths") {
    Edit edit = pulled_diagonal();
    for (Eigen::Vector3d& move : edit.moves) move *= 1.2;
    Editor editor = at_rest(edit);
    editor.set_option("shear_limit", "60");
    const SolveReport report = drag(editor, edit, 1);
    CHECK(report.status == Status::stalled);
    CHECK(report.max_deviation < 1e-6);
}

TEST_CASE("Equilibrium: where a sheet is pulled past the limit at once, its corners share what they lack") {
    const int cells = GENERATE(8, 14), last = (cells + 1) * (cells + 1) - 1;
    const double part = 0.98;  // of the way along edges between the two corners
    const double possible = 2 * std::acos(part);
    Editor editor(samples::patch(cells + 1, cells + 1, 0));
    editor.set_method("equilibrium");
    editor.set_option("shear_limit", GENERATE("30", "60"));
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, last}));
    const Positions& rest = editor.net().rest_positions();
    const Eigen::Vector3d diagonal = (rest.col(last) - rest.col(0)).normalized();
    editor.move_handle(last, rest.col(0) + part * 2 * cells * diagonal);
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::stalled);
    CHECK(report.max_deviation < 1e-9);
    CHECK(corner_angle_range(editor.net(), editor.positions()).smallest > 0.95 * possible);
    const std::vector<double> folds = fold_angles(editor.net(), editor.positions());
    CHECK(*std::max_element(folds.begin(), folds.end()) < 1 * samples::k_degree);
    // A limit that it can keep is kept.
    editor.set_option("shear_limit", "20");
    CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("Equilibrium: handles that move as one rigid body take the net along") {
    Edit edit = corner_pull(0);
    const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.6, Eigen::Vector3d(1, 2, 3).normalized()));
    const Positions moved = (turn * edit.net.rest_positions()).colwise() + Eigen::Vector3d(0.5, -1, 2);
    for (std::size_t i = 0; i < edit.vertices.size(); ++i)
        edit.moves[i] = moved.col(edit.vertices[i]) - edit.net.rest_positions().col(edit.vertices[i]);
    Editor editor = at_rest(edit);
    CHECK(drag(editor, edit, 10).status == Status::converged);
    CHECK(rms_distance(edit, editor.positions(), moved) < 1e-3);
}

TEST_CASE("Equilibrium: a fast, a slow and a middling drag end in one net, and back again") {
    const Edit edit = GENERATE(corner_pull(1), moved_crown(), pulled_diagonal());
    INFO(edit.name);
    Editor fast = at_rest(edit);
    drag(fast, edit, 1);
    for (const int frames : {4, 40}) {
        CAPTURE(frames);
        Editor slow = at_rest(edit);
        CHECK(drag(slow, edit, frames).status == Status::converged);
        CHECK(rms_distance(edit, slow.positions(), fast.positions()) < 1e-3);
    }
    Edit back = edit;
    for (Eigen::Vector3d& move : back.moves) move.setZero();
    drag(fast, back, 1);
    CHECK(rms_distance(edit, fast.positions(), edit.net.rest_positions()) < 1e-3);
}

TEST_CASE("Equilibrium: from a net pulled beyond its reach, or knotted, handles go home with it, turned or not") {
    Editor editor(GENERATE(samples::patch(9, 9), samples::patch(14, 6), samples::cube()));
    const Positions rest = editor.net().rest_positions();
    const int count = editor.net().vertex_count();
    const double L = editor.net().mean_length();
    const std::vector<int> vertices = {0, count / 3, 2 * count / 3, count - 1};
    const auto set_handles = [&](auto target) {
        std::vector<Handle> handles;
        for (const int v : vertices) handles.push_back({v, target(v)});
        editor.set_handles(handles);
    };
    const unsigned seed = GENERATE(range(1u, 7u));
    CAPTURE(count, seed);
    std::mt19937 random(seed);
    set_handles([&](int) {
        Eigen::Vector3d target = rest.col(count / 2);
        for (double& x : target) x += L * (3.6 * static_cast<double>(random()) / random.max() - 1.8);
        return target;
    });
    editor.solve();
    const double angle = GENERATE(0.0, 2.0);
    const Eigen::Matrix3d turn(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 1).normalized()));
    const Positions home = (turn * rest).colwise() + angle * 5 * L * Eigen::Vector3d::UnitX();
    set_handles([&](int v) -> Eigen::Vector3d { return home.col(v); });
    CHECK(editor.solve().status == Status::converged);
    CHECK((editor.positions() - home).colwise().norm().maxCoeff() < 1e-2 * L);
}

TEST_CASE(
    "Equilibrium: a net that had to be opened comes back from a knot to where it was, though it could buckle twice") {
    const Net patch = samples::patch(9, 9);
    Positions leaning = patch.rest_positions();
    leaning.row(0) += 0.9 * leaning.row(1);
    Editor editor(Net(leaning, patch.faces(), RestLengths::own));
    editor.set_method("equilibrium");
    editor.set_option("shear_limit", "55");
    const std::vector<Handle> at_rest = samples::handles_at_rest(editor.net(), {0, 8, 72, 80});
    editor.set_handles(at_rest);
    REQUIRE(editor.solve().status == Status::converged);
    const Positions home = editor.positions();
    const double L = editor.net().mean_length();
    const unsigned seed = GENERATE(range(1u, 9u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::vector<Handle> knotted = at_rest;
    for (Handle& handle : knotted)
        for (double& x : handle.target) x += L * (3.6 * static_cast<double>(random()) / random.max() - 1.8);
    editor.set_handles(knotted);
    editor.solve();
    editor.set_handles(at_rest);
    CHECK(editor.solve().status == Status::converged);
    CHECK((editor.positions() - home).colwise().norm().maxCoeff() < 1e-2 * L);
}

TEST_CASE("Equilibrium: a net that cannot be opened is not said to have converged, whatever holds it") {
    const bool is_box = GENERATE(true, false);
    const double leaning = GENERATE(0.9, 2.0, 3.0);
    const int held = GENERATE(1, 2, 4, 6, 8);
    CAPTURE(is_box, leaning, held);
    const Net upright = is_box ? samples::cube() : samples::patch(2, 4, 0);
    Positions x = upright.rest_positions();
    x.row(0) += leaning * x.row(is_box ? 2 : 1);
    Editor editor(Net(x, upright.faces(), RestLengths::own));
    editor.set_method("equilibrium");
    editor.set_option("shear_limit", "55");
    std::vector<int> vertices;
    for (int k = 0; k < held; ++k) vertices.push_back(7 - 7 * k / std::max(1, held - 1));
    editor.set_handles(samples::handles_at_rest(editor.net(), vertices));
    const Status status = editor.solve().status;
    CHECK(keeps_lengths(status) == is_within_limit(editor));
    if (held == 8) CHECK(status == Status::stalled);
    CHECK(keeps_lengths(editor.solve().status) == is_within_limit(editor));
}

TEST_CASE("Equilibrium: frames of a drag are nets within the limit, and the energy of a net at rest falls") {
    const Edit edit = pulled_diagonal();
    Editor editor = at_rest(edit);
    editor.set_option("shear_limit", "55");
    const int frames = 20;
    for (int frame = 1; frame <= frames; ++frame) {
        for (std::size_t i = 0; i < edit.vertices.size(); ++i)
            editor.move_handle(edit.vertices[i],
                               edit.net.rest_positions().col(edit.vertices[i]) + edit.moves[i] * frame / frames);
        const SolveReport report = editor.solve({.iterations = 1});
        CHECK(report.max_deviation < 1e-6);
        CHECK(corner_angle_range(edit.net, editor.positions()).smallest > 54.5 * samples::k_degree);
    }
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::converged);
    for (std::size_t k = 1; k < report.trace.size(); ++k)
        CHECK(report.trace[k].energy <= report.trace[k - 1].energy * (1 + 1e-6));
}

TEST_CASE("Equilibrium: what is at rest stays to the last bit") {
    const Edit edit = corner_pull(1);
    Editor editor = at_rest(edit);
    drag(editor, edit, 1);
    const Positions before = editor.positions();
    editor.set_option("max_iterations", "50");
    const SolveReport again = editor.solve();
    CHECK(again.status == Status::converged);
    CHECK(again.iterations == 0);
    CHECK(editor.positions() == before);
}

TEST_CASE("Equilibrium: a net of sharper corners than the limit is opened, rests there, and comes back to it") {
    const Edit sheared = pulled_diagonal();
    Editor without_limit = at_rest(sheared);
    without_limit.set_option("shear_limit", "0");
    drag(without_limit, sheared, 1);
    const Edit edit{"sharp", Net(without_limit.positions(), sheared.net.faces()), {0, 40}, {}};
    REQUIRE(corner_angle_range(edit.net, edit.net.rest_positions()).smallest < 54 * samples::k_degree);

    Editor editor(edit.net);
    editor.set_method("equilibrium");
    editor.set_option("shear_limit", "58");
    editor.set_handles(samples::handles_at_rest(edit.net, {0}));
    const SolveReport opened = editor.solve();
    CHECK(opened.status == Status::converged);
    CHECK(opened.max_deviation < 1e-9);
    CHECK(corner_angle_range(edit.net, editor.positions()).smallest > 57.99 * samples::k_degree);
    REQUIRE(!opened.trace.empty());
    CHECK(opened.trace.back().energy < 1e-9);
    CHECK(opened.trace.front().stage == 4);  // opening corners

    Editor interrupted(edit.net);
    interrupted.set_method("equilibrium");
    interrupted.set_option("shear_limit", "58");
    interrupted.set_handles(samples::handles_at_rest(edit.net, {0}));
    CHECK(interrupted.solve({.iterations = 1}).status == Status::running);
    interrupted.move_handle(0, edit.net.rest_positions().col(0) + Eigen::Vector3d(0, 0, 0.1));
    CHECK(interrupted.solve().trace.back().energy < 1e-9);

    const Positions before = editor.positions();
    const Eigen::Vector3d inwards = 0.2 * (before.col(0) - before.col(40));
    editor.set_handles({{0, before.col(0)}, {8, before.col(8)}, {40, before.col(40) + inwards}});
    CHECK(editor.solve().status == Status::converged);
    CHECK(rms_distance(edit, editor.positions(), before) > 0.1);
    editor.move_handle(40, before.col(40));
    CHECK(editor.solve().status == Status::converged);
    CHECK(rms_distance(edit, editor.positions(), before) < 1e-3);
}

TEST_CASE("Equilibrium: lengths are as exact as the threshold asks for, in every frame") {
    const Edit edit = moved_crown();
    Editor editor = at_rest(edit);
    editor.set_option("threshold", "1e-18");
    for (int frame = 1; frame <= 5; ++frame) {
        for (std::size_t i = 0; i < edit.vertices.size(); ++i)
            editor.move_handle(edit.vertices[i],
                               edit.net.rest_positions().col(edit.vertices[i]) + frame / 5.0 * edit.moves[i]);
        CHECK(editor.solve({.iterations = 1}).max_deviation < 1e-18);
    }
    CHECK(editor.solve().status == Status::converged);
}

TEST_CASE("Equilibrium: a symmetric edit gives a symmetric net") {
    const int n = 9;
    const Edit edit = lifted_sheet(n, 2);
    Editor editor = at_rest(edit);
    drag(editor, edit, 1);
    const Positions& x = editor.positions();
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Eigen::Vector3d mirrored(n - 1 - x(0, j * n + i), x(1, j * n + i), x(2, j * n + i));
            CHECK((x.col(j * n + n - 1 - i) - mirrored).norm() < 1e-3);
        }
}

namespace {

/// A strip of quads along x: two lines of `count` edges of length `edge`, all in the plane y = 0 and y = edge.
Net strip(int count, double edge, const std::function<Eigen::Vector2d(int)>& place) {
    Positions x(3, 2 * (count + 1));
    Faces faces;
    for (int i = 0; i <= count; ++i)
        for (int side = 0; side < 2; ++side) {
            const Eigen::Vector2d at = place(i);
            x.col(2 * i + side) << at.x(), side * edge, at.y();
            if (side == 0 && i < count) faces.add({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
        }
    return Net(x, faces);
}

/// The strip held at its four corners, `span` apart.
Editor hung(const Net& net, double span, double edge) {
    const int last = net.vertex_count() - 1;
    Editor editor(net);
    editor.set_method("equilibrium");
    editor.set_handles({{0, {0, 0, 0}}, {1, {0, edge, 0}}, {last - 1, {span, 0, 0}}, {last, {span, edge, 0}}});
    return editor;
}

/// The edge between two vertices.
std::optional<int> edge_between(const Net& net, int a, int b) {
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edges()(0, e) == std::min(a, b) && net.edges()(1, e) == std::max(a, b)) return e;
    return std::nullopt;
}

/// t with f(t) = 0 between a and b, where f has different signs.
double root(const std::function<double(double)>& f, double a, double b) {
    const bool rises = f(b) > 0;
    for (int k = 0; k < 100; ++k) ((f((a + b) / 2) > 0) == rises ? b : a) = (a + b) / 2;
    return (a + b) / 2;
}

}  // namespace

TEST_CASE("Equilibrium: a heavy strip that hardly resists bending hangs as a catenary") {
    const int count = 40;
    const double edge = 1.0 / count, span = 0.8;
    const Net net = strip(count, edge, [&](int i) { return Eigen::Vector2d(i * edge, 0); });
    Editor editor = hung(net, span, edge);
    for (const auto& [key, value] : {std::pair{"gravity", "1"}, {"bending_weight", "1e-3"}, {"shear_weight", "0"}})
        editor.set_option(key, value);
    CHECK(editor.solve().status == Status::converged);
    // z = a cosh((x − span / 2) / a) + constant, as long as 1: 2 a sinh(span / 2a) = 1.
    const double a = root([&](double t) { return 2 * t * std::sinh(span / (2 * t)) - 1; }, 0.1, 10);
    for (int i = 0; i <= count; ++i) {
        const Eigen::Vector3d x = editor.positions().col(2 * i);
        const double z = a * (std::cosh((x.x() - span / 2) / a) - std::cosh(span / (2 * a)));
        CHECK(x.z() == Approx(z).margin(2e-3));
    }
    // Where the chain is level its tension is a times the weight of a unit of length. An edge of length L weighs 1 / L;
    // each line carries its own and half of those across.
    const int lowest = *edge_between(net, count, count + 2);
    CHECK(editor.edge_forces()[lowest] == Approx(1.5 * a / edge).epsilon(0.02));
    CHECK(editor.edge_forces()[*edge_between(net, 0, 2)] > editor.edge_forces()[lowest]);
}

TEST_CASE("Equilibrium: a net that nothing holds does not fall, and hangs as soon as something does") {
    const Net net = samples::patch(9, 9, 0);
    Editor editor(net);
    editor.set_option("gravity", "0.01");
    CHECK(editor.solve().status == Status::converged);
    CHECK(editor.positions() == net.rest_positions());
    // What slides up and down carries nothing.
    std::vector<Handle> handles = samples::handles_at_rest(net, {0, 8, 72, 80});
    for (Handle& handle : handles) handle.slides = 4;
    editor.set_handles(handles);
    CHECK(editor.solve().status == Status::converged);
    CHECK((editor.positions() - net.rest_positions()).norm() < 1e-6);

    for (Handle& handle : handles)
        handle = {handle.vertex, handle.target - 0.1 * (handle.target - net.rest_positions().col(40))};
    editor.set_handles(handles);
    CHECK(editor.solve().status == Status::converged);
    CHECK(editor.positions()(2, 40) < -1);
    editor.set_handles({});
    const double before = editor.positions()(2, 40);
    CHECK(keeps_lengths(editor.solve().status));
    CHECK(std::abs(editor.positions()(2, 40) - before) < 5);
}

TEST_CASE("Equilibrium: weight acts along y where y is up, and a net lying on its side hangs as it does upright") {
    const double tilt = GENERATE(-0.1, 0.0, 0.1);
    CAPTURE(tilt);
    const Net flat = samples::patch(9, 9, 0);
    const Eigen::Matrix3d tilted = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()).toRotationMatrix();
    const Net upright(tilted * flat.rest_positions(), flat.faces());
    Eigen::Matrix3d turn;  // z becomes y
    turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    const Net turned(turn * upright.rest_positions(), upright.faces());
    const auto hung = [](const Net& net, const char* y_up) {
        Editor editor(net);
        editor.set_option("gravity", "0.01");
        editor.set_option("y_up", y_up);
        std::vector<Handle> handles = samples::handles_at_rest(net, {0, 8, 72, 80});
        for (Handle& handle : handles) handle.target -= 0.1 * (handle.target - net.rest_positions().col(40));
        editor.set_handles(handles);
        CHECK(editor.solve().status == Status::converged);
        return editor.positions();
    };
    const Positions hanging = hung(turned, "on");
    CHECK(hanging(1, 40) < -1);
    CHECK(samples::largest_move(hanging, turn * hung(upright, "off")) < 1e-3);
}

TEST_CASE("Equilibrium: of two pieces the one that is held hangs, and the other does not fall") {
    const Net sheet = samples::patch(9, 9, 0), both = samples::twice(sheet, {20, 0, 0});
    const auto hung = [&](const Net& net) {
        Editor editor(net);
        editor.set_option("gravity", "0.01");
        std::vector<Handle> handles = samples::handles_at_rest(net, {0, 8, 72, 80});
        for (Handle& handle : handles) handle.target -= 0.1 * (handle.target - net.rest_positions().col(40));
        editor.set_handles(handles);
        CHECK(editor.solve().status == Status::converged);
        return editor.positions();
    };
    const Positions alone = hung(sheet), together = hung(both);
    CHECK((together.leftCols(81) - alone).colwise().norm().maxCoeff() < 1e-4);
    CHECK(alone(2, 40) < -1);
    CHECK((together.rightCols(81) - both.rest_positions().rightCols(81)).colwise().norm().maxCoeff() < 1e-6);
}

TEST_CASE("Equilibrium: a piece without handles stays where it is when those of another go home") {
    const Net net = samples::twice(samples::patch(7, 6), {20, 0, 0});
    Editor editor(net);
    std::vector<Handle> moved = samples::handles_at_rest(net, {42, 48, 83});
    for (Handle& handle : moved) handle.target.y() += 5;
    editor.set_handles(moved);
    REQUIRE(editor.solve().status == Status::converged);
    const Positions free = editor.positions().rightCols(42);

    const std::vector<Handle> home = samples::handles_at_rest(net, {0, 6, 35, 41});
    editor.set_handles(home);
    editor.solve();
    for (const double height : {0.5, 0.0}) {
        editor.move_handle(41, home.back().target + Eigen::Vector3d(0, 0, height));
        REQUIRE(editor.solve().status == Status::converged);
        CHECK((editor.positions().rightCols(42) - free).colwise().norm().maxCoeff() < 1e-6);
    }
    CHECK((editor.positions() - net.rest_positions()).leftCols(42).colwise().norm().maxCoeff() < 1e-6);
}

TEST_CASE("Equilibrium: a flat sheet squeezed within its plane arches upwards, at once and in frames alike") {
    const int n = 15;
    const Net net = samples::patch(n, n, 0);
    const double L = net.mean_length(), size = (n - 1) * L;
    const std::vector<Handle> corners = samples::handles_at_rest(net, {0, n - 1, n * (n - 1), n * n - 1});
    const double taken = 0.1;
    const auto squeezed = [&](double part, bool all) {
        std::vector<Handle> handles = corners;
        for (Handle& handle : handles) {
            const Eigen::Vector3d inwards = net.rest_positions().rowwise().mean() - handle.target;
            handle.target.x() += part * taken * inwards.x();
            if (all) handle.target.y() += part * taken * inwards.y();
        }
        return handles;
    };
    for (const bool all : {false, true}) {
        INFO(all);
        Editor at_once(net), in_frames(net);
        at_once.set_handles(corners);
        in_frames.set_handles(corners);
        at_once.set_handles(squeezed(1, all));
        CHECK(at_once.solve().status == Status::converged);
        for (int frame = 1; frame <= 20; ++frame) {
            in_frames.set_handles(squeezed(frame / 20., all));
            in_frames.solve({.iterations = 1});
        }
        CHECK(in_frames.solve().status == Status::converged);
        CHECK((at_once.positions() - in_frames.positions()).norm() < 0.01 * L * n);
        CHECK(at_once.positions().row(2).minCoeff() > -0.01 * L);
        CHECK(corner_angle_range(net, at_once.positions()).smallest > 70 * std::numbers::pi / 180);
        if (all) continue;
        // Two sides stay straight: an elastica carried along them (Love 1927, article 263).
        const double k = root(
            [&](double t) { return 2 * std::comp_ellint_2(t) / std::comp_ellint_1(t) - 1 - (1 - taken); }, 0.01, 0.9);
        CHECK(at_once.positions().row(2).maxCoeff() == Approx(size * k / std::comp_ellint_1(k)).epsilon(0.01));
    }
}

TEST_CASE(
    "Equilibrium: a squeezed flat sheet bows to the side to which soft handles, bent rods or weight would have it") {
    const int n = 13, middle = n * n / 2;
    const Net net = samples::patch(n, n, 0);
    const double L = net.mean_length();
    const std::vector<Handle> corners = samples::handles_at_rest(net, {0, n - 1, n * (n - 1), n * n - 1});
    const auto squeezed = [&](double part) {
        std::vector<Handle> handles = corners;
        for (Handle& handle : handles)
            handle.target +=
                part * (net.rest_positions().col(middle) - handle.target).cwiseProduct(Eigen::Vector3d(1, 1, 0));
        return handles;
    };
    using Options = std::vector<std::pair<std::string, std::string>>;
    const auto height = [&](const Options& options, std::vector<Handle> handles, int frames) {
        Editor editor(net);
        for (const auto& [name, value] : options) editor.set_option(name, value);
        editor.set_handles(corners);
        const std::vector<Handle> ends = handles;
        for (int frame = 1; frame <= frames; ++frame) {
            for (std::size_t i = 0; i < corners.size(); ++i)
                handles[i].target = corners[i].target + frame / double(frames) * (ends[i].target - corners[i].target);
            editor.set_handles(handles);
            if (frame < frames) editor.solve({.iterations = 1});
        }
        CHECK(editor.solve().status == Status::converged);
        return (editor.positions()(2, middle) - net.rest_positions()(2, middle)) / L;
    };
    const auto drawn = [&](double to) {
        std::vector<Handle> handles = squeezed(0.05);
        handles.push_back({middle, net.rest_positions().col(middle) + Eigen::Vector3d(0, 0, to * L), 0.2});
        return handles;
    };
    for (const int frames : {1, 30}) {
        CAPTURE(frames);
        const double up = height({}, drawn(3), frames);
        CHECK(up > 1);
        CHECK(height({}, drawn(-3), frames) == Approx(-up).epsilon(1e-3));
        const double bent = height({{"rod_curvature", "0.05"}}, squeezed(0.1), frames);
        CHECK(std::abs(bent) > 2);
        CHECK(height({{"rod_curvature", "-0.05"}}, squeezed(0.1), frames) == Approx(-bent).epsilon(1e-3));
        // Weight decides where nothing else does, however little it is, and not against stiff rods.
        CHECK(height({{"gravity", "1e-4"}}, squeezed(0.1), frames) < -2);
        CHECK(height({{"rod_curvature", bent > 0 ? "0.05" : "-0.05"}, {"gravity", "1e-4"}}, squeezed(0.1), frames) > 2);
    }
}

TEST_CASE("Equilibrium: where little may move, a net that would be opened up stays a net") {
    const int n = 9;
    Positions sharp(3, n * n);
    for (int v = 0; v < n * n; ++v) {
        const double angle = 20 * std::numbers::pi / 180, i = v % n, j = v / n;
        sharp.col(v) << i + j * std::cos(angle), j * std::sin(angle), 0;
    }
    const Net net(sharp, samples::patch(n, n).faces());
    for (const double radius : {1.0, 2.0, 3.0}) {
        Editor editor(net);
        editor.set_locality(radius, std::array{40});
        Status status = Status::running;
        while (status == Status::running) {
            status = editor.solve({.iterations = 1}).status;
            CHECK(max_deviation(net, editor.positions()) < 1e-6);
        }
    }
}

TEST_CASE("Equilibrium: a flat sheet that soft handles squeeze is not at rest before it has left its plane") {
    const int n = 15;
    const Net net = samples::patch(n, n, 0);
    const double L = net.mean_length();
    const std::vector<Handle> corners = samples::handles_at_rest(net, {0, n - 1, n * (n - 1), n * n - 1});
    const auto squeezed = [&](double part, double weight) {
        std::vector<Handle> handles = corners;
        const Eigen::Vector3d centre = net.rest_positions().rowwise().mean();
        for (Handle& handle : handles)
            handle = {handle.vertex, handle.target + 0.1 * part * (centre - handle.target), weight};
        return handles;
    };
    for (const double weight : {1.0, 10.0, 100.0}) {
        INFO(weight);
        Editor at_once(net), in_frames(net);
        at_once.set_handles(squeezed(1, weight));
        CHECK(at_once.solve().status == Status::converged);
        CHECK(at_once.positions().row(2).maxCoeff() - at_once.positions().row(2).minCoeff() > 0.5 * L);
        CHECK(corner_angle_range(net, at_once.positions()).smallest > 70 * std::numbers::pi / 180);
        for (int frame = 1; frame <= 20; ++frame) {
            in_frames.set_handles(squeezed(frame / 20., weight));
            in_frames.solve({.iterations = 1});
        }
        CHECK(in_frames.solve().status == Status::converged);
        CHECK((at_once.positions() - in_frames.positions()).norm() < 0.01 * L * n);
    }
    // What pulls it straight leaves it flat.
    Editor pulled(net);
    pulled.set_handles(squeezed(-1, 1));
    CHECK(pulled.solve().status == Status::converged);
    CHECK(pulled.positions().row(2).cwiseAbs().maxCoeff() < 1e-6 * L);
}

TEST_CASE("Equilibrium: straight rods between two supports that have come nearer bend into the elastica") {
    const int count = 40;
    const double edge = 1.0 / count;
    const double span = 0.8;
    // An arch of a circle, to say to which side.
    const double turn = 1.0 / count;
    std::vector<Eigen::Vector2d> arch{Eigen::Vector2d::Zero()};
    for (int i = 0; i < count; ++i) {
        const double direction = turn * (count / 2.0 - i - 0.5);
        arch.push_back(arch.back() + edge * Eigen::Vector2d(std::cos(direction), std::sin(direction)));
    }
    const Net net = strip(count, edge, [&](int i) { return arch[i]; });
    Editor editor = hung(net, span, edge);
    editor.set_option("straight_rods", "on");
    CHECK(editor.solve().status == Status::converged);
    // With k = sin(θ / 2), θ the angle at the ends: span = 2 E(k) / K(k) − 1, height = k / K(k) (Love 1927, article
    // 263).
    const double k =
        root([&](double t) { return 2 * std::comp_ellint_2(t) / std::comp_ellint_1(t) - 1 - span; }, 0.01, 0.9);
    CHECK(editor.positions()(2, count) == Approx(k / std::comp_ellint_1(k)).epsilon(0.01));
}

TEST_CASE("What costs energy may change while handles are out of reach") {
    const auto made = [](bool changes_out_of_reach) {
        Editor editor(samples::patch(7, 6, 0.5));
        editor.set_handles(samples::handles_at_rest(editor.net(), {0, 41}));
        CHECK(editor.solve().status == Status::converged);
        if (changes_out_of_reach) {
            editor.move_handle(41, editor.net().rest_positions().col(41) + Eigen::Vector3d(50, 0, 0));
            CHECK(editor.solve().status == Status::unreachable);
        }
        editor.set_option("straight_rods", "on");
        if (changes_out_of_reach) CHECK(editor.solve().status == Status::unreachable);
        editor.reset();
        editor.set_handles(samples::handles_at_rest(editor.net(), {0, 41}));
        CHECK(editor.solve().status == Status::converged);
        return editor;
    };
    CHECK((made(true).positions() - made(false).positions()).colwise().norm().maxCoeff() < 1e-3);
}
