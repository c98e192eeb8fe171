#pragma once

#include <Eigen/Core>
#include <cmath>

namespace chebnet {

/// Like norm(), but always by these operations in this order.
inline double length_of(const Eigen::Vector3d& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z()); }

}  // namespace chebnet
