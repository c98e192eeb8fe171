#pragma once

#include <Eigen/Core>
#include <span>

namespace chebnet {

struct Ball {
    Eigen::Vector3d centre;
    double radius;
};

/// The point nearest to `wish` that lies in all balls, by Dykstra's algorithm of alternating projections (Boyle &
/// Dykstra 1986). Where they meet in hardly a point or not at all, it comes as close as many rounds bring it.
Eigen::Vector3d nearest_in_all(std::span<const Ball> balls, const Eigen::Vector3d& wish);

}  // namespace chebnet
