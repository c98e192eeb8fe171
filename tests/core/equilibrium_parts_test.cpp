// What the method `equilibrium` is made of: the way of its handles, and the lengths and corners that it keeps.

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "constants.h"
#include "net/measures.h"
#include "sample_nets.h"
#include "solve/parts/free_motions.h"
#include "solve/parts/handle_walk.h"
#include "solve/parts/net_constraints.h"
#include "solve/parts/path_extrapolation.h"
#include "solve/parts/rigid_motion.h"
#include "solve/parts/tangent_newton.h"
#include "solve/terms/bending_term.h"

using namespace chebnet;

namespace {

Eigen::Quaterniond random_turn(std::mt19937& random) {
    std::normal_distribution<double> normal;
    Eigen::Vector4d parts;
    for (double& part : parts) part = normal(random);  // in one order: that of arguments is the compiler's
    return Eigen::Quaterniond(parts).normalized();
}

/// Handles at these vertices; the last of them slides along the given axes, if any.
HandleWalk walk_of(const Net& net, const Topology& topology, std::vector<int> handles, Axes along = k_no_axes) {
    std::vector<Slide> slides;
    if (along != k_no_axes) {
        slides.push_back({handles.back(), along});
        handles.pop_back();
    }
    HandleWalk walk;
    walk.set_handles(HeldVertices(net.vertex_count(), handles, slides), topology);
    walk.forget_moves(net.vertex_count());
    return walk;
}

/// In how many steps a handle goes so many edge lengths.
int steps_over(double edge_lengths) {
    const Net net = samples::patch(4, 4);
    const Topology topology(net);
    HandleWalk walk = walk_of(net, topology, {0, 15});
    Positions to = net.rest_positions();
    to.col(15).z() += edge_lengths;
    walk.begin(net.rest_positions(), to, 1);
    int steps = 0;
    for (; walk.walked() < 1; ++steps) walk.go_to(walk.next());
    return steps;
}

/// A point in the plane z = 0, at this angle on the unit circle about the origin.
Positions on_circle(double angle) { return Eigen::Vector3d(std::cos(angle), std::sin(angle), 0); }

Positions at(const PathExtrapolation& path, double t) {
    Positions x;
    path.go(t, x);
    return x;
}

/// How far from its place a path that goes round in such steps is after one more.
double error_on_circle(double step) {
    PathExtrapolation path;
    for (int k : {-2, -1, 0}) path.add(on_circle(k * step));
    return (at(path, 1) - on_circle(step)).norm();
}

/// A bent sheet of 6 by 9 vertices whose first row is held, as by hinges, with the norm of its bending.
struct HingedSheet {
    Net net = samples::patch(6, 9);
    Topology topology{net};
    FreePart part{net, free_vertices(net.vertex_count(), std::vector{0, 1, 2, 3, 4, 5})};
    TangentNewton newton{net, topology, part};
    Positions x = net.rest_positions();

    HingedSheet() {
        std::vector<std::unique_ptr<Term>> terms;
        terms.push_back(std::make_unique<BendingTerm>(net, topology, x, 1, BendingTerm::Reference::rest));
        newton.set_metric(terms);
        for (int v = 0; v < x.cols(); ++v) x.col(v).z() = std::sin(x.col(v).y());
    }
    Positions gone(double t, const Eigen::Matrix3Xd& move) {
        Positions to;
        newton.begin_way(x, move);
        newton.go(t, to);
        return to;
    }
};

}  // namespace

TEST_CASE(
    "The rigid motion that fits is the one by which points were moved, and of points in a line a turn is left open") {
    const unsigned seed = GENERATE(range(1u, 6u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Positions from = samples::shaken(Positions::Zero(3, 12), 1, random);
    const Eigen::Quaterniond turn = random_turn(random);
    const Eigen::Vector3d shift(1, -2, 3);
    const Positions to = (turn.toRotationMatrix() * from).colwise() + shift;
    const RigidMotion motion = fit_rigid_motion(from, to, Eigen::VectorXd::Ones(12));
    CHECK(motion.is_determined);
    for (int v = 0; v < 12; ++v) CHECK((motion.of(from.col(v)) - to.col(v)).norm() < 1e-9);

    Positions line = from;
    for (int v = 0; v < 12; ++v) line.col(v) = v * from.col(0);
    CHECK_FALSE(fit_rigid_motion(line, turn.toRotationMatrix() * line, Eigen::VectorXd::Ones(12)).is_determined);
}

TEST_CASE("Handles go an edge length at once, and farther in quarters of one or in fifty steps") {
    CHECK(steps_over(1) == 1);
    CHECK(steps_over(2) == 8);
    CHECK(steps_over(8) == 32);
    CHECK(std::abs(steps_over(10) - 40) <= 1);  // parts do not add up to a whole to the last bit
    CHECK(steps_over(1000) == 50);
}

TEST_CASE("Of what slides, the way is what it has to go across") {
    const Net net = samples::patch(4, 4);
    const Topology topology(net);
    HandleWalk walk = walk_of(net, topology, {0, 15}, 3);  // along x and y
    Positions to = net.rest_positions();
    to.col(15) += Eigen::Vector3d(5, 7, 0.5);
    walk.begin(net.rest_positions(), to, 1);
    CHECK(walk.length() == Approx(0.5));
    CHECK(walk.moves_to(1, net.rest_positions()).col(15) == Eigen::Vector3d(0, 0, 0.5));
    Positions x = net.rest_positions();
    walk.held().take_held(to, x);
    CHECK(x(0, 15) == net.rest_positions()(0, 15));
    CHECK(x(2, 15) == to(2, 15));
    CHECK(walk.way_left(x) == 0);
}

TEST_CASE("Handles joined by edges turn together on their way, others go straight") {
    const unsigned seed = GENERATE(range(1u, 4u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const std::vector<int> joined =
        GENERATE(std::vector<int>{0, 1, 4, 5}, std::vector<int>{0, 1, 2});  // a face, a line
    const Net net = samples::patch(4, 4, 0);
    const Topology topology(net);
    std::vector<int> handles = joined;
    handles.push_back(15);
    HandleWalk walk = walk_of(net, topology, handles);
    const Positions from = net.rest_positions();
    const Eigen::Quaterniond turn = random_turn(random);
    Positions to = from;
    for (int v : joined) to.col(v) = turn * from.col(v) + Eigen::Vector3d(1, 2, 3);
    to.col(15) += Eigen::Vector3d(0, 3, 4);
    walk.begin(from, to, 1);
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
        const Positions x = from + walk.moves_to(part, from);
        CHECK((x.col(15) - from.col(15) - part * Eigen::Vector3d(0, 3, 4)).norm() < 1e-12);
        for (int a : joined)
            for (int b : joined)
                CHECK((x.col(a) - x.col(b)).norm() == Approx((from.col(a) - from.col(b)).norm()).margin(1e-12));
    }
    const Positions end = from + walk.moves_to(1, from);
    CHECK((end - to).cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("Handles joined by edges that change their shape come to their places evenly") {
    const Net net = samples::patch(4, 4, 0);
    const Topology topology(net);
    HandleWalk walk = walk_of(net, topology, {0, 1, 4, 5});
    const Positions from = net.rest_positions();
    Positions to = from;
    for (int v : {0, 1, 4, 5}) to.col(v) = 2 * Eigen::Vector3d(3 - from(1, v), from(0, v), 0);
    walk.begin(from, to, 1);
    CHECK((from + walk.moves_to(1, from) - to).norm() < 1e-12);
    const Positions half = from + walk.moves_to(0.5, from);
    CHECK((half.col(0) - half.col(1)).norm() == Approx(1.5));
    CHECK((half.col(0) - half.col(5)).norm() == Approx(1.5 * std::sqrt(2)));
}

TEST_CASE("A step that is like the last one repeats it, one across it does not") {
    const Net net = samples::patch(4, 4);
    const Topology topology(net);
    HandleWalk walk = walk_of(net, topology, {0, 15});
    Eigen::Matrix3Xd last = Eigen::Matrix3Xd::Zero(3, 16);
    last.col(15) = Eigen::Vector3d(0, 0, 0.2);
    walk.note_move(last);
    Eigen::Matrix3Xd same = last, across = Eigen::Matrix3Xd::Zero(3, 16);
    across.col(15) = Eigen::Vector3d(0.2, 0, 0);
    const double repeated = walk.take_off_repeated(same);
    CHECK(repeated > 0.9);
    CHECK(repeated < 1);
    CHECK((same + repeated * last - last).norm() < 1e-15);
    const Eigen::Matrix3Xd before = across;
    CHECK(walk.take_off_repeated(across) == 0);
    CHECK(across == before);
}

TEST_CASE("A shape is placed where handles have it, and turned as the last net where they leave that open") {
    const unsigned seed = GENERATE(range(1u, 4u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = samples::patch(5, 5);
    const Topology topology(net);
    const Positions& shape = net.rest_positions();
    const Positions moved = (random_turn(random).toRotationMatrix() * shape).colwise() + Eigen::Vector3d(3, 1, 2);
    HandleWalk by_three = walk_of(net, topology, {0, 4, 20});
    by_three.begin(shape, moved, 1);
    CHECK((by_three.placed(shape, shape) - moved).norm() < 1e-9);
    CHECK(by_three.ends_as_in(shape, shape));

    HandleWalk by_two = walk_of(net, topology, {0, 24});
    by_two.begin(shape, moved, 1);
    CHECK((by_two.placed(shape, moved) - moved).norm() < 1e-3);  // the last net counts for little
    Positions pulled = moved;
    pulled.col(24) *= 1.1;
    by_two.begin(shape, pulled, 1);
    CHECK_FALSE(by_two.ends_as_in(shape, moved));
}

TEST_CASE("What is projected has every length and no corner beyond the limit, and what was held can be held again") {
    const unsigned seed = GENERATE(range(1u, 6u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    const Net net = samples::patch(8, 8, 0);
    const Topology topology(net);
    const std::vector<bool> is_free(64, true);
    NetConstraints constraints(net, topology, CornerLimit(net, 60 * samples::k_degree), is_free, {}, {},
                               net.rest_positions());
    // Corners of 55°, shaken.
    Positions x = net.rest_positions();
    x.row(0) += std::cos(55 * samples::k_degree) * x.row(1);
    x.row(1) *= std::sin(55 * samples::k_degree);
    x = samples::shaken(x, 0.02, random);
    REQUIRE(constraints.lack(x) > 0.05);
    const std::vector<double> none = constraints.held();
    REQUIRE(constraints.project(x, 1e-12));
    CHECK(max_deviation(net, x) < 1e-12);
    CHECK(corner_angle_range(net, x).smallest > 59.9 * samples::k_degree);
    CHECK(constraints.lack(x) < 1e-3);
    CHECK(constraints.held() != none);
    constraints.hold(none);
    CHECK(constraints.held() == none);
}

TEST_CASE("A corner that was far from its limit when corners were last looked at stops no move: it is held") {
    const Net net = samples::patch(4, 4, 0);
    const Topology topology(net);
    NetConstraints constraints(net, topology, CornerLimit(net, 60 * samples::k_degree), std::vector<bool>(16, true), {},
                               {}, net.rest_positions());
    const auto sheared = [&](double angle) {
        Positions x = net.rest_positions();
        x.row(0) += std::cos(angle) * x.row(1);
        x.row(1) *= std::sin(angle);
        return x;
    };
    const Positions x = sheared(60.01 * samples::k_degree);
    const Eigen::Matrix3Xd move = sheared(50 * samples::k_degree) - x;
    REQUIRE(constraints.part_until_short(x, move) < 0.01);
    CHECK(constraints.hold_blocking_ones(x, move));
    CHECK(constraints.part_until_short(x, move) == 1);
}

TEST_CASE("A path goes on through its last three points, whatever lies between them") {
    const unsigned seed = GENERATE(range(1u, 6u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    PathExtrapolation path;
    std::vector<Positions> points;
    for (int k = 0; k < 5; ++k) {
        CHECK(path.is_known() == (k > 2));
        points.push_back(samples::shaken(Positions::Zero(3, 7), 1, random));
        path.add(points.back());
    }
    const double last = (points[4] - points[3]).norm(), before = (points[3] - points[2]).norm();
    CHECK((at(path, 0) - points[4]).norm() == 0);
    CHECK(path.farthest(points[3]) == Approx((points[4] - points[3]).colwise().norm().maxCoeff()));
    CHECK((at(path, -1) - points[3]).norm() < 1e-14);
    CHECK((at(path, -1 - before / last) - points[2]).norm() < 1e-13);

    path.add(points.back());
    CHECK(!path.is_known());
    path.clear();
    path.add(points.front());
    CHECK(!path.is_known());
}

TEST_CASE("What stands in all points of a path stays where it is to the last bit") {
    PathExtrapolation path;
    Positions x(3, 2);
    x.col(0) << 0.1, 1 / 3.0, 19.5;
    for (double way : {0.0, 0.7, 1.9}) {
        x.col(1) << way, way * way, 3;
        path.add(x);
    }
    for (double t : {0.3, 1.0, 16.0}) CHECK(at(path, t).col(0) == x.col(0));
}

TEST_CASE("A straight path goes on straight, and a bent one errs by the third power of its steps") {
    PathExtrapolation path;
    for (double x : {0.0, 1.0, 4.0}) path.add(Eigen::Vector3d(x, 2 * x, -x));
    CHECK((at(path, 2) - Positions(Eigen::Vector3d(10, 20, -10))).norm() < 1e-13);

    CHECK(error_on_circle(0.1) < 1.1e-3);
    CHECK(error_on_circle(0.1) / error_on_circle(0.05) == Approx(8).epsilon(0.01));
}

TEST_CASE("A sheet that turns about its hinges keeps its shape however far it turns at once") {
    HingedSheet sheet;
    const Eigen::Vector3d axis = (sheet.x.col(5) - sheet.x.col(0)).normalized(), on_axis = sheet.x.col(0);
    Eigen::Matrix3Xd move(3, sheet.x.cols());
    for (int v = 0; v < move.cols(); ++v) move.col(v) = axis.cross(sheet.x.col(v) - on_axis);
    for (const double angle : {0.1, 0.5, 1.5}) {
        CAPTURE(angle);
        const Positions to = sheet.gone(2 * std::tan(angle / 2), move);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
        const Positions turned = (turn * (sheet.x.colwise() - on_axis)).colwise() + on_axis;
        CHECK((to - turned).cwiseAbs().maxCoeff() < 5e-3);
        CHECK(max_deviation(sheet.net, sheet.x + angle * move) > max_deviation(sheet.net, to));
    }
}

TEST_CASE("A short part of any move is that part of it, but for its square, and what is fixed stays") {
    const unsigned seed = GENERATE(range(1u, 4u));
    CAPTURE(seed);
    std::mt19937 random(seed);
    HingedSheet sheet;
    Eigen::Matrix3Xd move = samples::shaken(Positions::Zero(3, sheet.x.cols()), 1, random);
    for (int v = 0; v < 6; ++v) move.col(v).setZero();
    const auto off = [&](double part) {
        return (sheet.gone(part, move) - sheet.x - part * move).cwiseAbs().maxCoeff();
    };
    CHECK(sheet.gone(1, move).leftCols(6) == sheet.x.leftCols(6));
    CHECK(off(1) > 0.01);
    CHECK(off(0.01) < 1.3e-2 * off(0.1));
}

TEST_CASE("What nothing resists is taken out of moves: turns about what is held, and shifts on the ground") {
    const Net net = samples::patch(5, 4);
    const Topology topology(net);
    const Positions& x = net.rest_positions();
    const std::vector<Slide> feet{{0, 3}, {4, 3}, {15, 3}}, on_rails{{0, 1}, {4, 1}};
    const std::vector<Pull> pull{{12, x.col(12), 1}}, pulls{{12, x.col(12), 1}, {3, x.col(3), 1}};
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const Eigen::Matrix3Xd any = Eigen::Matrix3Xd::NullaryExpr(3, 20, [&] { return normal(random); });
    Eigen::Matrix3Xd turn(3, 20), shift(3, 20);
    for (int v = 0; v < 20; ++v) turn.col(v) = Eigen::Vector3d::UnitZ().cross(x.col(v) - x.col(12));
    shift.colwise() = Eigen::Vector3d::UnitX();
    const auto rest = [&](const Eigen::Matrix3Xd& move, const std::vector<Slide>& slides,
                          const std::vector<Pull>& drawn, const Options& options = {}) {
        FreeMotions motions(net, topology, {}, slides);
        motions.set_forces(drawn, options);
        motions.begin(x);
        Eigen::Matrix3Xd left = move;
        motions.take_out(left);
        return left;
    };
    CHECK(rest(turn, feet, pull).norm() < 1e-12 * turn.norm());
    CHECK(rest(turn, feet, {}).norm() < 1e-12 * turn.norm());
    CHECK(rest(shift, feet, {}).norm() < 1e-12 * shift.norm());
    CHECK(rest(shift, on_rails, {}).norm() < 1e-12 * shift.norm());
    const Eigen::Matrix3Xd left = rest(any, feet, pull);
    CHECK(std::abs((left.array() * turn.array()).sum()) < 1e-12 * turn.norm());
    CHECK((rest(left, feet, pull) - left).norm() < 1e-12 * left.norm());
    // What is resisted stays whole.
    CHECK(rest(any, feet, pulls) == any);
    CHECK(rest(any, on_rails, pull) == any);
    Options heavy;
    heavy.gravity = 1;
    CHECK(rest(turn, feet, pull, heavy).norm() < 1e-12 * turn.norm());
    heavy.y_up = true;
    CHECK(rest(turn, feet, pull, heavy) == turn);
}
