#pragma once

#include <vector>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// A part of L: an edge nearer to it than that has this length. Those of a net whose dL is below 1e-9 are, by some
/// 3e-5.
inline constexpr double k_whole_edge = 1e-4;

/// L, that of most edges: those at a border may be cut.
double length_of_most(const Net& net);

/// The net lines that a rod is laid along, each a list of vertices as those of Topology::net_lines(): all but the lines
/// along a border that has cut the net, whose edges have other lengths.
std::vector<std::vector<int>> rods(const Net& net, const Topology& topology);

}  // namespace chebnet
