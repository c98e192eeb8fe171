#pragma once

#include <string>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// The rods of a net (net/rods.h) as CSV, for cutting them and marking where they cross: the line
/// "rod,edges,length,closed,vertices,marks", then one for each rod in the order of rods(). `length` is that of its
/// edges at `positions` (3×V), `closed` 1 if it goes straight on where its ends meet. `vertices` are those it passes,
/// counted from 0, and `marks` how far along it each of them is, both with spaces between. Numbers have as many digits,
/// 15 to 17, as bring them back exactly.
std::string rod_table(const Net& net, const Topology& topology, const Positions& positions);

}  // namespace chebnet
