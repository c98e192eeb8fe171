#pragma once

#include <Eigen/Core>

namespace chebnet {

/// A vertex that is pulled towards a point: it adds weight · ‖x − target‖² to an energy in which an edge counts once,
/// Σ_e ‖(x_a − x_b) − t_e‖². The weight is finite and above 0.
struct Pull {
    int vertex;
    Eigen::Vector3d target;
    double weight;
};

}  // namespace chebnet
