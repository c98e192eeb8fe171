#pragma once

#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// Of each side, whether it is on the boundary.
std::vector<bool> border_sides(const Surface& surface);

/// Of each side, whether it is on a boundary loop at least half as long as the longest of its piece: others go around
/// holes in what that one bounds.
std::vector<bool> outer_border_sides(const Surface& surface);

}  // namespace chebnet
