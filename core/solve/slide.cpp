#include "solve/slide.h"

namespace chebnet {

void copy_along(Axes axes, const double* from, double* to) {
    for (int k = 0; k < 3; ++k)
        if (has_axis(axes, k)) to[k] = from[k];
}

Eigen::Vector3d across(Axes axes, const Eigen::Vector3d& vector) {
    Eigen::Vector3d result(0, 0, 0);
    copy_along(k_all_axes - axes, vector.data(), result.data());
    return result;
}

}  // namespace chebnet
