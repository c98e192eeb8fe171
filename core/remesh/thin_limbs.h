#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "surface/guide.h"

namespace chebnet {

/// Part of a surface around which too few cells go for a net.
struct ThinLimb {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on it, farthest from what is left
    double girth = 0;  ///< around it where it is thin, on average, in cells, within half a cell
};

/// A surface, and what it lacks.
struct WithoutLimbs {
    std::shared_ptr<const Guide> guide;
    std::vector<ThinLimb> limbs = {};
};

/// The surface without limbs around which fewer than `girth` cells go, of the side `cell` (in its unit), such as tails,
/// horns and spikes, with flat caps where they were; anew of triangles that are shorter than a cell, with edges sharper
/// than `crease` (radians) kept. What hangs on a limb goes with it if it is small: of no more than 400 cells, and
/// hardly anything beside the rest. What is larger stays, as a piece of its own. The genus of the surface and its own
/// border stay, so thin handles and what is thin at a border do. Given back as it is, the same object: where there is
/// no such limb, where they are more than a third of the area, and where what is left would be no surface.
WithoutLimbs without_thin_limbs(const std::shared_ptr<const Guide>& guide, double cell, double girth, double crease);

}  // namespace chebnet
