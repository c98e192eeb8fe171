#pragma once

#include <vector>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// A handle that jumps onto a vertex leaves an edge without length, where no energy of ratios has a direction to offer.
/// Moves the free end of every edge shorter than a hundredth of its length away from the other end, to a tenth of the
/// length, towards the free end's other neighbours. The same input always gives the same result. `is_free`: V.
void open_degenerate_edges(const Net& net, const Topology& topology, const std::vector<bool>& is_free,
                           Positions& positions);

}  // namespace chebnet
