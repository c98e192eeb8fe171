#pragma once

#include <Eigen/Core>
#include <limits>

namespace chebnet {

/// Heavier pulls would stand as good as still, and single precision has room for these.
inline constexpr double k_most_pull = 1e6;

/// A vertex that is pulled towards a point: it adds weight · ‖x − target‖² to an energy in which an edge counts once,
/// Σ_e ‖(x_a − x_b) − t_e‖². The weight is above 0, and k_most_pull at most. Beyond a distance of `yields` it pulls
/// hardly harder, if the method knows that (`equilibrium`).
struct Pull {
    int vertex;
    Eigen::Vector3d target;
    double weight;
    double yields = std::numeric_limits<double>::infinity();
};

}  // namespace chebnet
