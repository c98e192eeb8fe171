#pragma once

#include <Eigen/Core>

namespace chebnet {

/// Some of the three coordinates: the sum of 1 for x, 2 for y and 4 for z.
using Axes = int;
inline constexpr Axes k_no_axes = 0, k_all_axes = 7;

constexpr bool has_axis(Axes axes, int coordinate) { return (axes >> coordinate & 1) != 0; }

/// Some of them, but not all; nor a number that means nothing.
constexpr bool is_part(Axes axes) { return axes > k_no_axes && axes < k_all_axes; }

/// A free vertex that keeps some of its coordinates bit for bit: it slides along the other axes, one or two. A foot on
/// the ground slides along x and y.
struct Slide {
    int vertex;
    Axes along;
};

/// Throws Error bad_option for a handle that is to slide along none or all of the axes, or is soft.
void check_slide(int vertex, Axes along, bool is_exact);

/// Copies the coordinates along these axes, of one point to another.
void copy_along(Axes axes, const double* from, double* to);
/// The same vector without its coordinates along these axes.
Eigen::Vector3d across(Axes axes, const Eigen::Vector3d& vector);

}  // namespace chebnet
