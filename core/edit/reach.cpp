#include "edit/reach.h"

#include <algorithm>
#include <vector>

namespace chebnet {

namespace {

constexpr int k_most_rounds = 1000;
// A round that moves the point by less than this part of the smallest radius is the last.
constexpr double k_tolerance = 1e-9;

Eigen::Vector3d nearest_in(const Ball& ball, const Eigen::Vector3d& point) {
    const Eigen::Vector3d off = point - ball.centre;
    const double distance = off.norm();
    return distance > ball.radius ? Eigen::Vector3d(ball.centre + ball.radius / distance * off) : point;
}

}  // namespace

Eigen::Vector3d nearest_in_all(std::span<const Ball> balls, const Eigen::Vector3d& wish) {
    Eigen::Vector3d point = wish;
    std::vector<Eigen::Vector3d> corrections(balls.size(), Eigen::Vector3d::Zero());
    for (int round = 0; round < k_most_rounds; ++round) {
        double moved = 0;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            const Eigen::Vector3d corrected = point + corrections[i], next = nearest_in(balls[i], corrected);
            corrections[i] = corrected - next;
            moved = std::max(moved, (next - point).norm() / balls[i].radius);
            point = next;
        }
        if (moved < k_tolerance) break;
    }
    return point;
}

}  // namespace chebnet
