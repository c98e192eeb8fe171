// Edits that somebody makes in the first minute, and what they end in with the usual method: a net somebody could
// weave, and one answer whatever the way to it.
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "edit/editor.h"
#include "edit/flip.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "shapes/shapes.h"

using namespace chebnet;

namespace {

constexpr double k_limit = 29.95;  // degrees: the usual limit of corners, but for its tolerance

double smallest_angle(const Net& net, const Positions& x) {
    return corner_angle_range(net, x).smallest * 180 / EIGEN_PI;
}
double smallest_angle(const Editor& editor) { return smallest_angle(editor.net(), editor.positions()); }

double rms(const Net& net, const Positions& a, const Positions& b) {
    return std::sqrt((a - b).squaredNorm() / static_cast<double>(a.cols())) / net.mean_length();
}

Editor at_rest(const Net& net, const std::vector<int>& vertices) {
    Editor editor(net);
    editor.set_handles(samples::handles_at_rest(net, vertices));
    editor.solve();
    return editor;
}

/// All handles to where `place` has them at each part of their way, in so many frames, and until the net rests.
template <class Place>
SolveReport drag(Editor& editor, int frames, Place place) {
    const std::vector<Handle> handles = editor.handles();
    for (int frame = 1; frame <= frames; ++frame) {
        for (const Handle& handle : handles)
            editor.move_handle(handle.vertex, place(handle.vertex, static_cast<double>(frame) / frames));
        if (frame < frames) editor.solve({.iterations = 1});
    }
    editor.set_option("max_iterations", "1000");
    return editor.solve();
}

/// One vertex by as much, the others where they are.
auto moving(const Editor& editor, int vertex, const Eigen::Vector3d& move) {
    return [from = editor.positions(), vertex, move](int v, double part) {
        return Eigen::Vector3d(from.col(v) + (v == vertex ? part : 0) * move);
    };
}

}  // namespace

TEST_CASE("Every shape of the gallery but the torus obeys the usual limit of corners as it comes") {
    for (const ShapeInfo& info : shape_table()) {
        INFO(info.name);
        if (std::string(info.name) == "torus") continue;  // 25 degrees: opened when it comes
        const Net net = make_shape(info.name).net;
        CHECK(smallest_angle(net, net.rest_positions()) > k_limit);
    }
}

TEST_CASE("A tube twisted by a right angle ends in one net, in however few frames") {
    const int around = 20, along = 16;
    Positions x(3, around * along);
    Faces faces;
    const double radius = 0.5 / std::sin(EIGEN_PI / around);
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const double u = 2 * EIGEN_PI * i / around;
            x.col(j * around + i) << radius * std::cos(u), radius * std::sin(u), j;
            const int next = (i + 1) % around;
            if (j > 0) faces.add({(j - 1) * around + i, (j - 1) * around + next, j * around + next, j * around + i});
        }
    const Net tube(x, faces);
    std::vector<int> rims;
    for (int i = 0; i < around; ++i) {
        rims.push_back(i);
        rims.push_back((along - 1) * around + i);
    }
    // The net lines between the rims lean, which brings these closer.
    const double chord = radius * std::sqrt(2), height = 0.97 * std::sqrt((along - 1) * (along - 1) - chord * chord);
    const auto twisted = [&](int v, double part) {
        Eigen::Vector3d place = x.col(v);
        if (v < around) return place;
        place = Eigen::AngleAxisd(part * EIGEN_PI / 2, Eigen::Vector3d::UnitZ()) * place;
        place.z() += part * (height - (along - 1));
        return place;
    };
    Editor slow = at_rest(tube, rims);
    CHECK(keeps_lengths(drag(slow, 40, twisted).status));
    CHECK(smallest_angle(slow) > k_limit);
    for (const int frames : {1, 2, 4, 8, 16}) {
        CAPTURE(frames);
        Editor editor = at_rest(tube, rims);
        CHECK(keeps_lengths(drag(editor, frames, twisted).status));
        CHECK(smallest_angle(editor) == Approx(smallest_angle(slow)).margin(0.5));
        CHECK(rms(tube, editor.positions(), slow.positions()) < 0.02);
    }
}

TEST_CASE("A straight tube that is pressed together gives way as a whole, also at once", "[large]") {
    // By two edges: a rim that snaps there has all lengths, turned back through the next row.
    const double by = GENERATE(0.5, 2.0, 4.0, 5.0);
    CAPTURE(by);
    const int around = 20, along = 21, top = (along - 1) * around;
    const double radius = 0.5 / std::sin(EIGEN_PI / around);
    Positions x(3, around * along);
    Faces faces;
    for (int v = 0; v < around * along; ++v) {
        const double u = 2 * EIGEN_PI * v / around;
        x.col(v) << radius * std::cos(u), radius * std::sin(u), v / around;
        const int next = (v + 1) % around == 0 ? v + 1 - around : v + 1;
        if (v < top) faces.add({v, next, next + around, v + around});
    }
    const Net tube(x, faces);
    std::vector<Handle> handles;
    for (int i = 0; i < around; ++i) {
        handles.push_back({i, x.col(i)});
        handles.push_back({top + i, x.col(top + i) - by * Eigen::Vector3d::UnitZ()});
    }
    Editor editor(tube);
    editor.set_method("equilibrium");
    editor.set_handles(handles);
    editor.solve();
    CHECK(max_deviation(editor.net(), editor.positions()) < 1e-9);
    CHECK(sharp_folds(editor.net(), editor.positions(), k_fold) == 0);
    CHECK(smallest_angle(editor) > k_limit);
    for (const Handle& handle : handles) CHECK(editor.positions().col(handle.vertex) == handle.target);
}

TEST_CASE("The end of a strip that is turned at once takes the strip along without a fold") {
    const double degrees = GENERATE(90.0, 150.0, 180.0);
    CAPTURE(degrees);
    const int wide = 9, rows = 31, top = wide * (rows - 1);
    const Net strip = samples::patch(wide, rows, 0);
    const Positions x = strip.rest_positions();
    const Eigen::Vector3d middle(x.row(0).mean(), rows - 1, 0);
    // The longest net lines lie on a helix of this height.
    const double radius = (wide - 1) / 2.0, angle = degrees * EIGEN_PI / 180;
    const double height = 0.97 * std::sqrt((rows - 1) * (rows - 1) - radius * radius * angle * angle);
    std::vector<Handle> handles;
    for (int i = 0; i < wide; ++i) {
        handles.push_back({i, x.col(i)});
        const Eigen::Vector3d turned = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()) * (x.col(top + i) - middle);
        handles.push_back({top + i, turned + Eigen::Vector3d(middle.x(), height, 0)});
    }
    Editor editor(strip);
    editor.set_method("equilibrium");
    editor.set_handles(handles);
    CHECK(editor.solve().status == Status::converged);
    CHECK(max_deviation(editor.net(), editor.positions()) < 1e-9);
    CHECK(sharp_folds(editor.net(), editor.positions(), k_fold) == 0);
    CHECK(smallest_angle(editor) > k_limit);
}

TEST_CASE("A vault pushed three units aside is a net within the limit") {
    const Shape vault = make_shape("vault:vertices=600");
    Editor editor = at_rest(vault.net, vault.suggested_handles);
    const int frames = GENERATE(1, 12);
    CAPTURE(frames);
    const int v = vault.suggested_handles.back();
    const auto place = moving(editor, v, {3, 0, 0});  // farther than the net goes
    for (int frame = 1; frame <= frames; ++frame) {
        editor.drag_handle(v, place(v, static_cast<double>(frame) / frames));
        editor.solve({.iterations = 2});
        CHECK(smallest_angle(editor) > k_limit - 0.5);
    }
    CHECK(keeps_lengths(editor.solve().status));
    CHECK(smallest_angle(editor) > k_limit);
}

TEST_CASE("A flat sheet pulled in its plane by two corners shears evenly") {
    const int n = 21, last = n * n - 1;
    Editor editor = at_rest(samples::patch(n, n, 0), {0, last});
    // Diagonals of an evenly sheared sheet, whose corners have 52 degrees.
    const double longer = 2 * (n - 1) * std::cos(26 * EIGEN_PI / 180) - std::sqrt(2) * (n - 1);
    const Eigen::Vector3d outwards = Eigen::Vector3d(1, 1, 0).normalized();
    const int frames = GENERATE(1, 10);
    CAPTURE(frames);
    CHECK(keeps_lengths(drag(editor, frames, moving(editor, last, 0.99 * longer * outwards)).status));
    CHECK(smallest_angle(editor) > 45);
}

TEST_CASE("The page's dome pushed down a little is a smooth net within the limit") {
    const Shape dome = make_shape("dome:vertices=600");
    Editor editor = at_rest(dome.net, dome.suggested_handles);
    const int frames = GENERATE(1, 8);
    CAPTURE(frames);
    CHECK(keeps_lengths(drag(editor, frames, moving(editor, dome.suggested_handles.back(), {0, 0, -0.5})).status));
    CHECK(smallest_angle(editor) > k_limit);

    // No net line zigzags: nowhere does one bend by more than a third of what an edge is long.
    const Positions &x = editor.positions(), &rest = dome.net.rest_positions();
    double most = 0;
    for (const std::vector<int>& line : editor.topology().net_lines())
        for (std::size_t k = 1; k + 1 < line.size(); ++k) {
            const auto second = [&](const Positions& at) {
                return Eigen::Vector3d(at.col(line[k - 1]) - 2 * at.col(line[k]) + at.col(line[k + 1]));
            };
            most = std::max(most, second(x).norm() - second(rest).norm());
        }
    CHECK(most < dome.net.mean_length() / 3);
}

TEST_CASE("A sheet whose crown is raised is the shape that a finer one takes") {
    // The same sheet, 12 units wide, of 12 and of 24 edges; what shear costs a quad counts for four finer ones.
    const auto raised = [](int cells) {
        const int n = cells + 1, middle = n * (cells / 2) + cells / 2;
        const double edge = 12.0 / cells;
        const Net net = samples::patch(n, n, 0).scaled(edge);
        Editor editor(net);
        std::vector<Handle> handles;
        for (const int v : {0, cells, n * cells, n * n - 1}) {
            handles.push_back({v, net.rest_positions().col(v)});
            handles.back().slides = 3;  // on the ground
        }
        handles.push_back({middle, net.rest_positions().col(middle)});
        editor.set_handles(handles);
        editor.set_option("shear_weight", std::to_string(0.05 * 144 / (cells * cells)));
        editor.set_option("rest_tolerance", "1e-6");
        editor.set_option("max_iterations", "2000");
        editor.move_handle(middle, net.rest_positions().col(middle) + 2 * Eigen::Vector3d::UnitZ());
        CHECK(editor.solve().status == Status::converged);
        return editor.positions();
    };
    // Of a sheet from one with twice as many edges, where it has vertices.
    const auto distance = [&](int cells) {
        const Positions coarse = raised(cells), fine = raised(2 * cells);
        double farthest = 0;
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i)
                farthest = std::max(
                    farthest, (coarse.col((cells + 1) * j + i) - fine.col((2 * cells + 1) * 2 * j + 2 * i)).norm());
        return farthest;
    };
    const double far = distance(6), near = distance(12);
    CHECK(near < 0.12);  // of 2 by which it is raised
    CHECK(near < 0.6 * far);
}

TEST_CASE("Within a frame of a drag the energy never rises") {
    const Shape dome = make_shape("dome:vertices=300");
    Editor editor = at_rest(dome.net, dome.suggested_handles);
    const auto place = moving(editor, dome.suggested_handles.back(), {0.8, 0.3, -1});
    const int frames = 15;
    int seen = 0;
    for (int frame = 1; frame <= frames; ++frame) {
        const int v = dome.suggested_handles.back();
        editor.move_handle(v, place(v, static_cast<double>(frame) / frames));
        const Trace trace = editor.solve({.iterations = 4}).trace;
        for (std::size_t k = 1; k < trace.size(); ++k)
            if (trace[k].stage == 3 && trace[k - 1].stage == 3) {
                CHECK(trace[k].energy <= trace[k - 1].energy * (1 + 1e-6));
                ++seen;
            }
    }
    CHECK(seen > 10);
}

TEST_CASE("Lengths are never worse than by the method that asks for nothing else") {
    const unsigned seed = GENERATE(range(1u, 25u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> move(-2.5, 2.5);
    const Net net = seed % 2 == 0 ? samples::patch(9, 9) : samples::ring(9, 7, false);
    std::vector<Handle> handles = samples::handles_at_rest(net, {0, 8, 30, 44, 62});
    for (Handle& handle : handles)
        for (double& x : handle.target) x += net.mean_length() * move(random);
    const auto solved = [&](const char* method) {
        Editor editor(net);
        editor.set_method(method);
        editor.set_handles(handles);
        return editor.solve();
    };
    const SolveReport only_lengths = solved("projection"), at_rest = solved("equilibrium");
    if (keeps_lengths(only_lengths.status))
        CHECK(at_rest.max_deviation < 1e-6);
    else
        CHECK(at_rest.max_deviation <= 1.01 * only_lengths.max_deviation);
}

TEST_CASE(
    "A net that was pushed through stays on its side while a hand moves by little, also over where it came from") {
    const Net net = samples::patch(13, 13, 0.5);
    const int corner = 168;
    Editor editor = at_rest(net, {0, 12, 156, corner});
    const Positions up = editor.positions();
    editor.set_positions(flipped(net, editor.handles(), up));
    REQUIRE(keeps_lengths(editor.solve().status));
    const Positions down = editor.positions();
    REQUIRE(rms(net, up, down) > 1);

    const Eigen::Vector3d home = net.rest_positions().col(corner), aside = home + 0.6 * Eigen::Vector3d(-1, 0.2, 0.3);
    for (const Eigen::Vector3d& target : {aside, home, aside, home}) {
        for (int frame = 1; frame <= 3; ++frame) {
            const Eigen::Vector3d from = editor.positions().col(corner);
            editor.drag_handle(corner, from + (target - from) * frame / 3.0);
            editor.solve({.iterations = 2});
        }
        editor.drag_handle(corner, target);
        editor.solve();
        CHECK(rms(net, editor.positions(), down) < rms(net, editor.positions(), up));
    }
    editor.release_handles();
    editor.solve();
    CHECK(rms(net, editor.positions(), down) < 0.1);
}
