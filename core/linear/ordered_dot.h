#pragma once

#include <Eigen/Core>

#include "linear/dense_kernels.h"

namespace chebnet {

/// The dot product, added up in an order that does not depend on the compiler, as that of Eigen's does.
inline double ordered_dot(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// Likewise, of all coefficients of vectors or matrices of one size.
template <typename Matrix>
double ordered_dot(const Eigen::PlainObjectBase<Matrix>& a, const Eigen::PlainObjectBase<Matrix>& b) {
    return dense::dot(a.data(), b.data(), static_cast<int>(a.size()));
}

}  // namespace chebnet
