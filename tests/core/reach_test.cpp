#include "edit/reach.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "edit/editor.h"
#include "net/error.h"
#include "sample_nets.h"

using namespace chebnet;

namespace {

bool lies_in_all(const std::vector<Ball>& balls, const Eigen::Vector3d& point, double tolerance) {
    return std::ranges::all_of(
        balls, [&](const Ball& ball) { return (point - ball.centre).norm() <= (1 + tolerance) * ball.radius; });
}

}  // namespace

TEST_CASE("The nearest point in all balls is in all of them, and none of many others is nearer") {
    const unsigned seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto point = [&](double size) {
        return Eigen::Vector3d(size * number(random), size * number(random), size * number(random));
    };
    for (int count = 1; count <= 6; ++count) {
        // All contain a ball of radius 0.3 about the origin.
        std::vector<Ball> balls;
        for (int i = 0; i < count; ++i) {
            const Eigen::Vector3d centre = point(3);
            balls.push_back({centre, centre.norm() + 0.3 + std::abs(number(random))});
        }
        const Eigen::Vector3d wish = point(10), nearest = nearest_in_all(balls, wish);
        CHECK(lies_in_all(balls, nearest, 1e-7));
        const double distance = (nearest - wish).norm();
        for (int i = 0; i < 20000; ++i) {
            // About the result, where a better one would be, and anywhere.
            const Eigen::Vector3d other = i % 2 == 0 ? nearest + point(0.1) : point(4);
            if (lies_in_all(balls, other, 0)) CHECK((other - wish).norm() > distance - 1e-6);
        }
    }
}

TEST_CASE("A point within all balls stays; without balls every point does") {
    const std::vector<Ball> balls{{{0, 0, 0}, 2}, {{1, 0, 0}, 2}};
    const Eigen::Vector3d inside(0.5, 0.3, -0.2), far(9, 9, 9);
    CHECK(nearest_in_all(balls, inside) == inside);
    CHECK(nearest_in_all({}, far) == far);
}

TEST_CASE("Balls that do not meet give a finite point between them") {
    const std::vector<Ball> balls{{{-3, 0, 0}, 1}, {{3, 0, 0}, 1}};
    const Eigen::Vector3d point = nearest_in_all(balls, {0, 5, 0});
    CHECK(point.allFinite());
    CHECK(std::abs(point.x()) < 2.001);
}

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

    editor.move_handle(71, nearest_in_all(balls, {100, 50, 0}));
    CHECK(editor.unreachable_pairs().empty());
    editor.move_handle(71, {100, 50, 0});
    CHECK(editor.unreachable_pairs().size() == 2);
}
