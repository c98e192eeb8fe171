#pragma once

#include "net/net.h"
#include "surface/surface.h"

namespace chebnet {

/// How far the surface's border is from that of a net, on the average, in the surface's unit; 0 if either has none.
double border_distance(const Surface& surface, const Net& net);

}  // namespace chebnet
