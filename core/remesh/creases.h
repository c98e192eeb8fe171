#pragma once

#include <vector>

#include "base/angle.h"
#include "surface/surface.h"

namespace chebnet {

/// Edges of a surface that are inclined by more than this, 30 degrees, are sharp unless another angle is asked for.
inline constexpr double k_sharp_edge = 30 * k_degree;

/// Of each side, whether the two triangles at it are inclined to each other by more than `angle` (radians, above 0):
/// the surface is sharp there. Never at the boundary, nor beside a triangle without area.
std::vector<bool> creases_of(const Surface& surface, double angle);

}  // namespace chebnet
