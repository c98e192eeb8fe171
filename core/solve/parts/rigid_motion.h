#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "net/net.h"

namespace chebnet {

/// A turn and a shift.
struct RigidMotion {
    Eigen::Vector3d from_centre, to_centre;
    Eigen::Quaterniond rotation;
    bool is_determined;  ///< by what it was fitted to: no turn about a point or a line would do as well

    Eigen::Vector3d of(const Eigen::Vector3d& x) const { return to_centre + rotation * (x - from_centre); }
};

/// The one with the least Σ weight · ‖motion(from) − to‖² over the columns (Kabsch 1976). `weight`: V, not all 0.
RigidMotion fit_rigid_motion(const Positions& from, const Positions& to, const Eigen::VectorXd& weight);

}  // namespace chebnet
