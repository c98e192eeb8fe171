#pragma once

#include <Eigen/Core>

#include "surface/surface.h"

namespace chebnet {

/// A vertex of a net that is made on a surface.
struct DrapedVertex {
    Eigen::Vector3d position;
    SurfacePoint at;         ///< the nearest point of the surface, which is the position unless there is an overhang
    Eigen::Vector3d normal;  ///< of the surface there
    double overhang = 0;     ///< how far beyond the boundary
};

}  // namespace chebnet
