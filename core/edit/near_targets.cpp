#include "edit/near_targets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace chebnet {

namespace {

/// The handle `to` has to be within `distance` of `from`; its target is `strain` times as far.
struct Bound {
    double strain;
    int from, to;
    double distance;
    bool operator>(const Bound& other) const { return strain > other.strain; }
};

/// (distance from rest, handle), ascending.
std::vector<std::pair<double, int>> by_distance_moved(const Eigen::Matrix3Xd& targets, const Eigen::Matrix3Xd& rest) {
    std::vector<std::pair<double, int>> moved;
    moved.reserve(static_cast<std::size_t>(targets.cols()));
    for (int i = 0; i < targets.cols(); ++i) moved.emplace_back((targets.col(i) - rest.col(i)).stableNorm(), i);
    std::sort(moved.begin(), moved.end());
    return moved;
}

}  // namespace

Eigen::Vector3d drawn_near(const Eigen::Vector3d& point, const Eigen::Vector3d& centre, double radius) {
    // Neither the difference of the halves nor the square of the direction can overflow.
    const Eigen::Vector3d half_way = point / 2 - centre / 2;
    const double largest = half_way.lpNorm<Eigen::Infinity>();
    if (!(largest > radius / 4)) return point;
    const Eigen::Vector3d direction = half_way / largest;
    const double fraction = radius / direction.norm();
    return fraction / 2 < largest ? Eigen::Vector3d(centre + fraction * direction) : point;
}

Eigen::Matrix3Xd near_targets(const HandleGraph& graph, double mean_length, const Eigen::Matrix3Xd& targets,
                              const Eigen::Matrix3Xd& rest) {
    Eigen::Matrix3Xd near = targets;
    std::vector<bool> is_placed(static_cast<std::size_t>(targets.cols()), false);
    std::priority_queue<Bound, std::vector<Bound>, std::greater<>> bounds;
    const auto place = [&](int i, const Eigen::Vector3d& centre, double radius) {
        if (is_placed[i]) return;
        is_placed[i] = true;
        near.col(i) = drawn_near(targets.col(i), centre, radius);
        for (const auto& [j, distance] : graph.neighbours(i))
            if (!is_placed[j]) bounds.push({(targets.col(i) - targets.col(j)).stableNorm() / distance, i, j, distance});
    };
    for (const auto& [moved, first] : by_distance_moved(targets, rest)) {
        place(first, rest.col(first), k_farthest_target * mean_length);
        while (!bounds.empty()) {
            const Bound next = bounds.top();
            bounds.pop();
            place(next.to, near.col(next.from), k_most_strain * next.distance);
        }
    }
    return near;
}

}  // namespace chebnet
