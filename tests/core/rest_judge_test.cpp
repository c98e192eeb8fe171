// What the soak and the fuzzers judge nets at rest by finds what it is to find.
#include "../soak/rest_judge.h"

#include <catch2/catch.hpp>

#include "sample_nets.h"

using namespace chebnet;

namespace {

/// What is said of a net that stands there, if it is said to be at rest.
std::string judged(Editor& editor, const Positions& positions) {
    editor.set_positions(positions);
    SolveReport report;
    report.status = Status::converged;
    const invariants::Violations violations = invariants::RestJudge().of_solve(editor, report);
    return violations.empty() ? "nothing" : violations.front();
}

}  // namespace

TEST_CASE("A net is judged to be at rest where no force is left, and no corner is beyond the limit") {
    Editor editor(samples::patch(9, 9));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 8, 72, 80});
    handles[3].target += Eigen::Vector3d(-1, -0.5, 0.5);
    editor.set_handles(handles);
    CHECK(editor.solve().status == Status::converged);
    const Positions at_rest = editor.positions();
    CHECK(judged(editor, at_rest) == "nothing");

    editor.set_method("projection");
    editor.set_positions(editor.net().rest_positions());
    editor.set_handles(handles);
    REQUIRE(editor.solve().status == Status::converged);
    const Positions only_exact = editor.positions();
    editor.set_method("equilibrium");
    CHECK_THAT(judged(editor, only_exact), Catch::Contains("a force is left"));

    editor.set_option("shear_limit", "60");
    Positions sheared = samples::patch(9, 9, 0).rest_positions();
    sheared.row(0) += std::cos(0.9) * sheared.row(1);
    sheared.row(1) *= std::sin(0.9);
    editor.set_handles({{0, sheared.col(0)}});
    CHECK_THAT(judged(editor, sheared), Catch::Contains("a corner is sharper"));
}

TEST_CASE("A net held at every vertex is at rest, as far as its corners are within the limit") {
    Editor editor(samples::cube());
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 1, 2, 3, 4, 5, 6, 7}));
    CHECK(editor.solve().status == Status::converged);
    CHECK(judged(editor, editor.net().rest_positions()) == "nothing");
}

TEST_CASE("A net that a soft handle draws from beyond all numbers is exact, and not said to be at rest") {
    Editor editor(samples::cube());
    editor.set_handles({{1, {1e300, 0, 0}, 5}});
    const SolveReport report = editor.solve();
    CHECK(report.status == Status::max_iterations);  // it is on its way
    CHECK(report.max_deviation < editor.options().threshold);
}
