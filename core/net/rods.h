#pragma once

#include <vector>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// The net lines that a rod is laid along, each a list of vertices as those of Topology::net_lines(): all but the lines
/// along a border that has cut the net, whose edges are not of the length that others share (shared_length()).
std::vector<std::vector<int>> rods(const Net& net, const Topology& topology);

/// Whether a border has cut the net: its edges share a length, but for some that end at the border, where some of its
/// faces are no quads, or lines of whole edges end with a shorter one.
bool is_cut(const Net& net, const Topology& topology);

}  // namespace chebnet
