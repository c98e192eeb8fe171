#include <catch2/catch.hpp>
#include <vector>

#include "edit/editor.h"
#include "net/error.h"
#include "sample_nets.h"

using namespace chebnet;

TEST_CASE("The reach of a handle has a ball for each other exact handle that the net joins it to") {
    Editor editor(samples::patch(9, 8));
    std::vector<Handle> handles = samples::handles_at_rest(editor.net(), {0, 8, 63, 71});
    handles[1].weight = 2;
    editor.set_handles(handles);
    const std::vector<Ball> balls = editor.reach(71);
    REQUIRE(balls.size() == 2);
    CHECK(balls[0].centre == handles[0].target);
    CHECK(balls[0].radius == Approx(15));
    CHECK(balls[1].centre == handles[2].target);
    CHECK(balls[1].radius == Approx(8));
    CHECK_THROWS_AS(editor.reach(5), Error);

    const auto [centre, radius] = balls[1];
    const Eigen::Vector3d outwards = (handles[3].target - centre).normalized();
    editor.move_handle(71, centre + 0.99 * radius * outwards);
    CHECK(editor.unreachable_pairs().empty());
    editor.move_handle(71, centre + 1.01 * radius * outwards);
    CHECK(editor.unreachable_pairs().size() == 1);
    editor.move_handle(71, {100, 50, 0});
    CHECK(editor.unreachable_pairs().size() == 2);
}
