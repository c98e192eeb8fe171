#pragma once

#include <Eigen/Core>
#include <limits>

namespace chebnet {

/// A vertex that is pulled towards a point: it adds weight · ‖x − target‖² to an energy in which an edge counts once,
/// Σ_e ‖(x_a − x_b) − t_e‖². The weight is finite and above 0. Beyond a distance of `yields` it pulls hardly harder, if
/// the method knows that (`equilibrium`).
struct Pull {
    int vertex;
    Eigen::Vector3d target;
    double weight;
    double yields = std::numeric_limits<double>::infinity();
};

}  // namespace chebnet
