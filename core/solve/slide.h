#pragma once

#include <Eigen/Core>
#include <vector>

namespace chebnet {

/// Some of the three coordinates: the sum of 1 for x, 2 for y and 4 for z.
using Axes = int;
inline constexpr Axes k_no_axes = 0, k_all_axes = 7;

constexpr bool has_axis(Axes axes, int coordinate) { return (axes >> coordinate & 1) != 0; }

/// A free vertex that keeps some of its coordinates bit for bit: it slides along the other axes, one or two. A foot on
/// the ground slides along x and y.
struct Slide {
    int vertex;
    Axes along;
};

/// For each vertex the axes along which it may move: all of a free one, none of a fixed one.
inline std::vector<Axes> axes_of_motion(const std::vector<bool>& is_free, const std::vector<Slide>& slides) {
    std::vector<Axes> axes(is_free.size(), k_no_axes);
    for (std::size_t v = 0; v < is_free.size(); ++v)
        if (is_free[v]) axes[v] = k_all_axes;
    for (const Slide& slide : slides) axes[slide.vertex] = slide.along;
    return axes;
}

/// The same vector without its coordinates along these axes.
inline Eigen::Vector3d across(Axes axes, Eigen::Vector3d vector) {
    for (int k = 0; k < 3; ++k)
        if (has_axis(axes, k)) vector[k] = 0;
    return vector;
}

}  // namespace chebnet
