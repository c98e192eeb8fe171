#pragma once

#include <Eigen/Core>
#include <span>

#include "shapes/placement.h"
#include "shapes/shapes.h"

namespace chebnet {

/// The boundary of a union of blocks, netted with equal squares. The blocks are rounded to whole squares, at least one
/// thick; the size of the squares is chosen so that about `vertices` of them come out. The handles are the vertices
/// nearest to `handles`, given in the units of the blocks.
Shape make_box_figure(std::span<const Box> boxes, double vertices, std::span<const Eigen::Vector3d> handles);

}  // namespace chebnet
