#include "linear/limits.h"

#include <catch2/catch.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "base/error.h"
#include "edit/editor.h"
#include "linear/graph_system.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "solve/parts/length_projection.h"
#include "solve/parts/neighbour_pairs.h"

using namespace chebnet;

namespace {

/// What the error that `call` throws says; an empty text if it throws none of this code.
template <typename Call>
std::string too_large(Call call) {
    try {
        call();
    } catch (const Error& error) {
        if (error.code() == ErrorCode::too_large) return error.what();
    }
    return "";
}

/// Triangles round a hub, vertex 0, with edges of length 1 at it.
Net fan(int triangles) {
    Positions x = Positions::Zero(3, triangles + 1);
    Faces faces;
    for (int i = 1; i <= triangles; ++i) {
        const double angle = 2 * EIGEN_PI * i / triangles;
        x.col(i) << std::cos(angle), std::sin(angle), 0;
        faces.add({0, i, i % triangles + 1});
    }
    return Net(x, faces, RestLengths::own);
}

}  // namespace

TEST_CASE("A factor that would fill the memory is refused before it is made, with its size") {
    // The hub of a star eliminated first joins all others.
    const int n = 60'000;
    Eigen::Matrix2Xi links(2, n - 1);
    for (int i = 1; i < n; ++i) links.col(i - 1) << 0, i;
    std::vector<int> rank(static_cast<std::size_t>(n));
    std::iota(rank.begin(), rank.end(), 0);
    const std::string message = too_large([&] { BlockSystem(n, links, rank); });
    CAPTURE(message);
    CHECK(message.find("180000 unknowns") != std::string::npos);
    CHECK(message.find("4096 MB") != std::string::npos);
    CHECK(too_large([&] { BlockSystem(n, links); }).empty());
}

TEST_CASE("A million vertices: the method of the page goes to work, one that cannot says so and leaves the net usable",
          "[large]") {
    Editor editor(samples::patch(1000, 1000, 0));
    const Positions rest = editor.positions();
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 999, 999'000, 999'999}));
    editor.move_handle(999'999, rest.col(999'999) + Eigen::Vector3d(-1, -1, 1));
    const Positions before = editor.positions();
    editor.set_method("li2022");
    const std::string message = too_large([&] { editor.solve(); });
    CAPTURE(message);
    CHECK(message.find("1000000 vertices") != std::string::npos);
    CHECK(message.find(" MB") != std::string::npos);
    CHECK(message.find("projection needs less") != std::string::npos);
    CHECK(editor.positions() == before);

    editor.set_method("projection");
    const double deviation_before = max_deviation(editor.net(), editor.positions());
    const SolveReport report = editor.solve({.iterations = 1});
    CHECK(report.iterations > 0);
    CHECK(report.max_deviation < deviation_before);
    CHECK(editor.positions().allFinite());
    CHECK(editor.handle_error() == 0);

    // A factor for its rest fits, too: a frame of a drag takes a minute or two, and so is not made here.
    editor.set_method("equilibrium");
    CHECK(editor.solve({.iterations = 1}).iterations == 1);
    CHECK(editor.positions().allFinite());
    CHECK(editor.handle_error() == 0);
}

TEST_CASE("A net too large for equilibrium to be usual may be left at any iteration, and is a net then", "[large]") {
    Editor editor(samples::patch(121, 121));
    REQUIRE(editor.net().vertex_count() > k_most_vertices_at_rest);
    const int last = editor.net().vertex_count() - 1;
    editor.set_method("equilibrium");
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 120, last - 120, last}));
    const auto deviation = [&](const Positions& x) { return max_deviation(editor.net(), x); };
    REQUIRE(editor.solve().status == Status::converged);

    // Of a hand that drags every frame is a net.
    const Eigen::Vector3d from = editor.positions().col(last), way(-8, -8, 8);
    for (int frame = 1; frame <= 4; ++frame) {
        editor.drag_handle(last, from + frame / 4. * way);
        const SolveReport report = editor.solve({.milliseconds = 0});
        CHECK(report.status == Status::running);
        CHECK(report.iterations == 1);
        CHECK(deviation(editor.positions()) < editor.options().threshold);
    }

    // Of handles that jump the last net is kept until they are there.
    editor.move_handle(last, from - way);
    for (int iterations = 0; iterations < 6; ++iterations) {
        const SolveReport report = editor.solve({.milliseconds = 0});
        CHECK(report.iterations <= 1);
        CHECK(editor.positions().allFinite());
        CHECK(editor.handle_error() == 0);
        CHECK(deviation(editor.last_net()) < editor.options().threshold);
    }
}

TEST_CASE("Where tens of thousands of edges meet, every step stays bounded", "[large]") {
    const int valence = GENERATE(2'000, 20'000, 60'000);
    CAPTURE(valence);
    Editor editor(fan(valence));
    CHECK(editor.topology().boundary_loops().size() == 1);
    CHECK(editor.topology().net_lines().size() >= 1);
    CHECK(bend(editor.net(), editor.topology(), editor.positions()) == 0);
    const bool couples = too_large([&] { LengthProjection(editor.net(), editor.topology()); }).empty();
    CHECK(couples == (valence <= 2'000));
    CHECK(!too_large([&] { NeighbourPairs(editor.net(), editor.topology()); }).empty());

    const std::string method = GENERATE("projection", "li2022", "equilibrium");
    CAPTURE(method);
    editor.set_method(method);
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 1, 1 + valence / 3, 1 + 2 * valence / 3}));
    editor.move_handle(1, {0.9, 0, 0.3});
    const SolveReport report = editor.solve({.iterations = 20});
    CHECK(report.iterations > 0);
    CHECK(editor.positions().allFinite());
    CHECK(editor.handle_error() == 0);
}

TEST_CASE("Where rest is too large to be reckoned, a net with exact lengths is said to be that, not at rest",
          "[large]") {
    Editor editor(fan(3'000));
    editor.set_method("equilibrium");
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 1}));
    CHECK(editor.solve().status == Status::exact);
    const Positions before = editor.positions();
    CHECK(editor.solve().status == Status::exact);
    CHECK(editor.positions() == before);
}
