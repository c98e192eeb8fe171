#pragma once

#include <array>
#include <vector>

#include "net/net.h"

namespace chebnet {

using Triangle = std::array<int, 3>;

/// The faces cut into triangles that wind as they do, in their order. A quad is cut along its shorter diagonal, unless
/// that has no length or only the other leaves it without a fold; a face of more vertices is cut into a fan from its
/// first, which suits convex ones.
std::vector<Triangle> triangulated(const Positions& positions, const Faces& faces);

/// Twice the area of the triangle along its normal.
Eigen::Vector3d area_vector(const Positions& positions, const Triangle& triangle);

}  // namespace chebnet
