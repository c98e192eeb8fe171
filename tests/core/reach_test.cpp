#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "base/error.h"
#include "edit/editor.h"
#include "sample_nets.h"

using namespace chebnet;

TEST_CASE("The reach of a handle has a ball for each other exact handle, but for those with one in between") {
    Editor editor(samples::patch(9, 8));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {20, 8, 63, 71, 0});
    handles[1].weight = 2;
    editor.set_handles(handles);
    const std::vector<Ball> balls = editor.reach(71);
    REQUIRE(balls.size() == 2);
    CHECK(balls[0].vertex == 20);
    CHECK(balls[0].centre == handles[0].target);
    CHECK(balls[0].radius == Approx(11));
    CHECK(balls[1].centre == handles[2].target);
    CHECK(balls[1].radius == Approx(8));
    CHECK_THROWS_AS(editor.reach(5), Error);

    CHECK(balls[1].vertex == 63);
    CHECK(editor.reach(8).empty());

    const auto [vertex, centre, radius] = balls[1];
    const Eigen::Vector3d outwards = (handles[3].target - centre).normalized();
    editor.move_handle(71, centre + 0.99 * radius * outwards);
    CHECK(editor.unreachable_pairs().empty());
    editor.move_handle(71, centre + 1.01 * radius * outwards);
    CHECK(editor.unreachable_pairs().size() == 1);
    editor.move_handle(71, {100, 50, 0});
    CHECK(editor.unreachable_pairs().size() == 2);
}

TEST_CASE("With a locality the border of what may move limits the handles it is nearest to") {
    Editor editor(samples::patch(21, 21));
    editor.set_handles(samples::handles_at_rest(editor.net(), {0, 217, 223}));
    editor.set_locality(6, std::vector{217, 223});
    const std::vector<Ball> balls = editor.reach(217);
    REQUIRE(balls.size() > 10);
    for (const auto& [vertex, centre, radius] : balls) {
        if (vertex == 0 || vertex == 223) continue;
        CHECK(centre == editor.positions().col(vertex));
        CHECK(radius == Approx(editor.topology().distances_from(217)[vertex]));
        CHECK(radius <= editor.topology().distances_from(223)[vertex]);
    }

    const Eigen::Vector3d from = editor.handles()[1].target, up = Eigen::Vector3d::UnitZ();
    const auto is_within = [&](double height) {
        return std::ranges::all_of(
            balls, [&](const Ball& ball) { return (from + height * up - ball.centre).norm() <= ball.radius; });
    };
    double height = 0;
    while (is_within(height)) height += 0.01;
    REQUIRE(height > 0.02);
    editor.move_handle(217, from + (height - 0.02) * up);
    CHECK(editor.unreachable_pairs().empty());
    editor.move_handle(217, from + (height + 0.5) * up);
    CHECK_FALSE(editor.unreachable_pairs().empty());
}
