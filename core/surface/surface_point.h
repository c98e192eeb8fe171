#pragma once

#include <Eigen/Core>
#include <optional>

#include "surface/surface.h"

namespace chebnet {

/// Which corner of a triangle a vertex is; −1 if none.
int corner_of(const Surface& surface, int face, int vertex);

/// The point itself, or where it is nearer to an edge or a vertex than a thousandth of its triangle's heights, the
/// point there: its weights for the corners elsewhere are 0.
SurfacePoint snapped(const SurfacePoint& point);

/// The weights of a point for the corners of a triangle on which it lies, too; nothing if it does not, as its weights
/// tell.
std::optional<Eigen::Vector3d> weights_in(const Surface& surface, const SurfacePoint& point, int face);

}  // namespace chebnet
