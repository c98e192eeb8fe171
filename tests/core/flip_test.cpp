#include "edit/flip.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "base/error.h"
#include "edit/editor.h"
#include "net/measures.h"
#include "sample_nets.h"

using namespace chebnet;

namespace {

double rms(const Positions& a, const Positions& b) {
    return std::sqrt((a - b).squaredNorm() / static_cast<double>(a.cols()));
}

SolveReport settle(Editor& editor) {
    editor.set_option("max_iterations", "1000");
    return editor.solve();
}

/// A flat strip whose ends have come nearer to each other: it has buckled, upwards.
Editor buckled_strip() {
    const int m = 21, n = 5;
    Editor editor(samples::patch(m, n, 0));
    std::vector<Handle> handles;
    for (int j = 0; j < n; ++j)
        for (int i : {0, m - 1}) handles.push_back({j * m + i, Eigen::Vector3d(i == 0 ? 1 : m - 2, j, 0)});
    Positions arched = editor.net().rest_positions();
    for (int v = 0; v < arched.cols(); ++v) arched(2, v) = std::sin(EIGEN_PI * (v % m) / (m - 1));
    editor.set_method("equilibrium");
    editor.set_positions(arched);
    editor.set_handles(handles);
    return editor;
}

}  // namespace

TEST_CASE("A strip that has buckled upwards flips to its mirror image") {
    Editor editor = buckled_strip();
    REQUIRE(settle(editor).status == Status::converged);
    const Positions up = editor.positions();
    CHECK(up.row(2).maxCoeff() > 2);
    CHECK(up.row(2).minCoeff() > -1e-6);

    editor.set_positions(flipped(editor.net(), editor.handles(), up));
    CHECK(settle(editor).status == Status::converged);
    Positions mirrored = up;
    mirrored.row(2) *= -1;
    CHECK(rms(editor.positions(), mirrored) < 1e-5);

    editor.set_positions(flipped(editor.net(), editor.handles(), editor.positions()));
    settle(editor);
    CHECK(rms(editor.positions(), up) < 1e-5);
}

TEST_CASE("Handles that lie in no plane stay where they are, and what is between them goes to the other side") {
    Editor editor(samples::patch(9, 9, 0.4));
    editor.set_method("equilibrium");
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 8, 72, 80});
    handles[0].target.z() += 0.5;
    editor.set_handles(handles);
    REQUIRE(settle(editor).status == Status::converged);
    const Positions before = editor.positions();
    const Positions start = flipped(editor.net(), editor.handles(), before);
    for (const Handle& handle : editor.handles()) CHECK(start.col(handle.vertex) == handle.target);
    CHECK((start(2, 40) < 0.25 && before(2, 40) > 0.25));
    // What is mirrored twice is what it was.
    CHECK(rms(flipped(editor.net(), editor.handles(), start), before) < 1e-8);
    editor.set_positions(start);
    CHECK(keeps_lengths(settle(editor).status));
    CHECK(max_deviation(editor.net(), editor.positions()) < 1e-6);
}

TEST_CASE("Of one handle, or of handles in a line, the plane is that of the net, and without any there is none") {
    const Net net = samples::patch(6, 6, 0);
    Positions bulge = net.rest_positions();
    for (int v = 0; v < bulge.cols(); ++v) bulge(2, v) = 0.01 * bulge(0, v) * bulge(1, v);
    for (const std::vector<int>& vertices : {std::vector{0}, std::vector{0, 3, 5}}) {
        std::vector<Handle> handles;
        for (int v : vertices) handles.push_back({v, bulge.col(v)});
        const Positions other = flipped(net, handles, bulge);
        CHECK(rms(other, bulge) > 0.01);
        // Handles in a plane: a mirror image, with the same edges.
        CHECK((edge_ratios(net, other) - edge_ratios(net, bulge)).lpNorm<Eigen::Infinity>() < 1e-5);
    }
    CHECK_THROWS_AS(flipped(net, {}, bulge), Error);
    const std::vector<Handle> soft = {{0, bulge.col(0), 1.0}};
    CHECK_THROWS_AS(flipped(net, soft, bulge), Error);
}
