#pragma once

#include <Eigen/Core>
#include <span>

#include "shapes/placement.h"
#include "shapes/shapes.h"

namespace chebnet {

/// The net of a box figure, relaxed until it is smooth but for the singular vertices, which stay the tips of cones: a
/// gridshell that resists bending, under a slight pressure from within, whose edges keep their length. `openings`, flat
/// boxes in faces of the blocks, are left open. Arguments as for make_box_figure.
///
/// It is relaxed from few oblong faces to many squares, so that the shape is the same at every number of vertices.
/// `rounding`: as of relax().
Shape make_smooth_figure(std::span<const Box> boxes, double vertices, double rounding,
                         std::span<const Eigen::Vector3d> handles, std::span<const Box> openings = {});

}  // namespace chebnet
