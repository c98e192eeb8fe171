#include "solve/slide.h"

namespace chebnet {

std::vector<Axes> axes_of_motion(const std::vector<bool>& is_free, std::span<const Slide> slides) {
    std::vector<Axes> axes(is_free.size(), k_no_axes);
    for (std::size_t v = 0; v < is_free.size(); ++v)
        if (is_free[v]) axes[v] = k_all_axes;
    for (const Slide& slide : slides) axes[slide.vertex] = slide.along;
    return axes;
}

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
