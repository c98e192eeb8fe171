// RestSearch: of several equilibria, one with less energy.
#include "edit/rest_search.h"

#include <array>
#include <catch2/catch.hpp>

#include "base/error.h"
#include "net/measures.h"
#include "sample_nets.h"

using namespace chebnet;

namespace {

constexpr int k_long = 21, k_wide = 5, k_middle = k_wide / 2 * k_long + k_long / 2;

/// A strip whose ends have come nearer to each other, with weight: it stands as an arch, though it might hang.
Editor arch() {
    Editor editor(samples::patch(k_long, k_wide, 0));
    std::vector<Handle> handles;
    for (int j = 0; j < k_wide; ++j)
        for (int i : {0, k_long - 1})
            handles.push_back({j * k_long + i, Eigen::Vector3d(i == 0 ? 1 : k_long - 2, j, 0)});
    Positions arched = editor.net().rest_positions();
    for (int v = 0; v < arched.cols(); ++v) arched(2, v) = std::sin(EIGEN_PI * (v % k_long) / (k_long - 1));
    editor.set_option("gravity", "1e-4");
    editor.set_option("max_iterations", "1000");
    editor.set_positions(arched);
    editor.set_handles(handles);
    editor.solve();
    return editor;
}

}  // namespace

TEST_CASE("A strip that stands as an arch against its weight hangs where less energy is looked for") {
    Editor editor = arch();
    REQUIRE(editor.positions()(2, k_middle) > 2);
    RestSearch search(editor);
    CHECK_THROWS_AS(search.state(), Error);
    const RestSearchReport report = search.solve();
    REQUIRE(report.status == Status::converged);
    CHECK(report.done == 1);
    const EditState before = editor.state();
    // Under little weight it hangs as it stood, mirrored: the energy less is that of its weight on the way down.
    double height = 0;
    for (const auto& edge : editor.net().edges().colwise())
        height += (before.positions(2, edge[0]) + before.positions(2, edge[1])) / 2;
    CHECK(report.energy_before - report.energy == Approx(2 * editor.options().gravity * height).epsilon(0.05));

    editor.set_state(search.state());
    CHECK(editor.solve().status == Status::converged);
    CHECK(editor.positions()(2, k_middle) < -2);
    CHECK(max_deviation(editor.net(), editor.positions()) < 1e-9);
    CHECK(editor.handles() == before.handles);
    CHECK(editor.options() == before.options);

    SECTION("from there no less is found, and nothing is to be set") {
        RestSearch again(editor);
        const RestSearchReport none = again.solve();
        CHECK(none.status == Status::unreachable);
        CHECK(none.energy == Approx(report.energy).epsilon(1e-3));
        CHECK_THROWS_AS(again.state(), Error);
    }
}

TEST_CASE("A net that lies as its rest shape does has no less energy anywhere, whatever rounding says") {
    Editor editor(samples::patch(9, 9, 0.4));
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 8, 72, 80}));
    editor.solve();
    CHECK(RestSearch(editor).solve().status == Status::unreachable);
}

TEST_CASE("Interrupted anywhere, the same net is found") {
    const Editor editor = arch();
    RestSearch at_once(editor), in_slices(editor);
    at_once.solve();
    double done = 0;
    for (RestSearchReport report; report.status == Status::running;) {
        report = in_slices.solve({.iterations = 3});
        CHECK(report.done >= done);
        done = report.done;
    }
    CHECK(in_slices.state() == at_once.state());
}

TEST_CASE("What a locality holds stays where it is while less energy is looked for") {
    Editor editor = arch();
    editor.set_locality(4, std::array{k_middle});
    const Positions before = editor.positions();
    RestSearch search(editor);
    const Status status = search.solve().status;
    const Positions after = status == Status::converged ? search.state().positions : before;
    for (const int vertex : editor.region()->outside) CHECK(after.col(vertex) == before.col(vertex));
}

TEST_CASE("Only a method that brings nets to rest has energies to compare") {
    Editor editor = arch();
    editor.set_method("projection");
    CHECK_THROWS_WITH(RestSearch(editor), Catch::Matchers::Contains("method projection brings no net to rest"));
}
