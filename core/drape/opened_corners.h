#pragma once

#include <optional>

#include "net/net.h"
#include "surface/guide.h"

namespace chebnet {

/// Where the net's vertices stand once no corner of its quads is sharper than `smallest_angle` (radians), every edge
/// has its length and the net is near the surface that it was laid on; nothing if no such net is found. By alternating
/// projections onto the three (Bauschke & Borwein, On Projection Algorithms for Solving Convex Feasibility Problems,
/// 1996): so vertices far from sharp corners hardly move. Throws Error too_large as LengthSystem does.
std::optional<Positions> with_opened_corners(const Net& net, const Guide& guide, double smallest_angle);

}  // namespace chebnet
