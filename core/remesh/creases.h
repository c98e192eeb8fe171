#pragma once

#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// Of each side, whether the two triangles at it are inclined to each other by more than `angle` (radians, above 0):
/// the surface is sharp there. Never at the boundary, nor beside a triangle without area.
std::vector<bool> creases_of(const Surface& surface, double angle);

}  // namespace chebnet
