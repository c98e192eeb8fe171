#include "surface/segment_tree.h"

#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "sample_surfaces.h"

using namespace chebnet;

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// From a look at each segment in turn.
SegmentTree::Nearest nearest_by_all(const std::vector<Segment>& segments, const Eigen::Vector3d& point, double most,
                                    const std::function<bool(const Segment&)>& counts) {
    SegmentTree::Nearest best{-1, most};
    for (int k = 0; k < std::ssize(segments); ++k) {
        const double square = squared_distance(point, segments[k].from, segments[k].to);
        if (counts(segments[k]) && square < best.squared_distance) best = {k, square};
    }
    return best;
}

/// Checks that both say the same of this point, to the last bit.
void check_nearest(
    const SegmentTree& tree, const Eigen::Vector3d& point, double most = k_infinity,
    const std::function<bool(const Segment&)>& counts = [](const Segment&) { return true; }) {
    const SegmentTree::Nearest found = tree.nearest(point, most, counts);
    const SegmentTree::Nearest known = nearest_by_all(tree.segments(), point, most, counts);
    CHECK(found.segment == known.segment);
    CHECK(found.squared_distance == known.squared_distance);
}

/// A closed line through points anywhere, so that each is an end of two segments.
std::vector<Segment> tangled_loop(int count, std::mt19937& random) {
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < count; ++k) points.push_back(samples::random_point(1, random));
    std::vector<Segment> segments;
    for (std::size_t k = 0; k < points.size(); ++k) segments.push_back({points[k], points[(k + 1) % points.size()]});
    return segments;
}

}  // namespace

TEST_CASE("The nearest segment is the one that a look at all of them finds, to the last bit") {
    std::mt19937 random(7);
    for (const int count : {1, 3, 4, 5, 60, 1000}) {
        const SegmentTree tree(tangled_loop(count, random));
        for (int k = 0; k < 200; ++k) check_nearest(tree, samples::random_point(k % 2 == 0 ? 1.2 : 50, random));
    }
}

TEST_CASE("Of segments equally near to a point the first is the nearest") {
    std::mt19937 random(8);
    const SegmentTree tree(tangled_loop(300, random));
    for (const Segment& segment : tree.segments()) check_nearest(tree, segment.from);
    // All sides of a circle are equally near to its middle, but for rounding.
    const Surface disc(samples::sphere(12, true));
    const SegmentTree border = border_of(disc);
    REQUIRE(border.segments().size() == 48);
    check_nearest(border, Eigen::Vector3d::Zero());
    check_nearest(border, {0, 0, 1});
}

TEST_CASE("Segments that do not count, or are too far, are not found") {
    std::mt19937 random(9);
    const SegmentTree tree(tangled_loop(300, random));
    const auto is_steep = [](const Segment& s) { return std::abs((s.to - s.from).z()) > (s.to - s.from).norm() / 2; };
    for (int k = 0; k < 200; ++k) {
        check_nearest(tree, samples::random_point(1.2, random), k_infinity, is_steep);
        check_nearest(tree, samples::random_point(1.2, random), 0.001, is_steep);
    }
    CHECK(tree.nearest({9, 9, 9}, 1).segment == -1);
    CHECK(tree.nearest({9, 9, 9}, 1).squared_distance == 1);
    CHECK(SegmentTree().empty());
    CHECK(SegmentTree().nearest({0, 0, 0}).segment == -1);
    CHECK(SegmentTree().nearest({0, 0, 0}).squared_distance == k_infinity);
}

TEST_CASE("A surface without a boundary has no border, and that of another is all of its open sides") {
    CHECK(border_of(Surface(samples::sphere(3))).empty());
    const Surface plane(samples::plane(5, 1));
    const SegmentTree border = border_of(plane);
    CHECK(border.segments().size() == 16);
    CHECK(border.nearest({0.5, 0, 0}).squared_distance == Approx(0.25));
    CHECK(border.nearest({1, 0.3, 2}).squared_distance == Approx(4));
}
