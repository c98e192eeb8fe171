#pragma once

#include "net/net.h"
#include "surface/guide.h"

namespace chebnet {

/// The mean angle between the cells of a net and the surface where it is nearest to them, in radians: small for
/// a net that lies on it smoothly, large for one that is crumpled, however near it is.
double mean_tilt(const Guide& guide, const Net& net);

/// At how many edges a net folds by k_fold more than the surface does from below one cell to below the
/// other: where the surface has an edge itself, the net is not crumpled.
int crumpled_edges(const Guide& guide, const Net& net);

}  // namespace chebnet
