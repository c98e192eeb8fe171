#pragma once

#include "net/net.h"
#include "surface/guide.h"

namespace chebnet {

/// The mean angle between the cells of a net (quads) and the surface where it is nearest to them, in radians: small for
/// a net that lies on it smoothly, large for one that is crumpled, however near it is.
double mean_tilt(const Guide& guide, const Net& net);

}  // namespace chebnet
