#pragma once

#include <Eigen/Core>

#include "net/net.h"
#include "solve/parts/free_part.h"

namespace chebnet {

/// A flat net whose handles come closer within its plane should bow out of it, as a lath does; but to first order
/// nothing pushes it there, and within the plane it can only fold up. Adds to moves within the plane (3×V) the bow that
/// makes up for what they take from the lengths of edges: a film under an even load, stiff along edges that keep their
/// lengths, so that lines which stay taut stay straight. To the side to which the moves lead, or upwards, or downwards
/// if the net hangs. Nothing where the net at `positions` is not flat, or its edges get longer on the whole. Throws
/// Error too_large.
void add_bow(const Net& net, const FreePart& part, const Positions& positions, bool hangs, Eigen::Matrix3Xd& moves);

}  // namespace chebnet
