#pragma once

#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// F: the triangles of closed pieces whose normals point inwards, by the volume that these enclose; empty if there are
/// none. What lies within another closed piece is turned if that is: so a cavity, whose normals point into it, is not.
std::vector<bool> faces_inside_out(const Surface& surface);

}  // namespace chebnet
