#pragma once

#include <span>

#include "edit/edit_state.h"
#include "net/net.h"

namespace chebnet {

/// Where to begin in order to find the other equilibrium of a net that has buckled: `positions` (3×V) mirrored in the
/// surface that a soap film between the exact handles would be, along the normal of the plane nearest to them. Where
/// handles lie in a plane this is the mirror image, a net as exact as before. Handles stay at their targets, and pieces
/// of the net without one where they are. A solve from there leads to the other net at rest, or back, if there is none.
/// Throws Error bad_option where no exact handle holds anything, too_large.
Positions flipped(const Net& net, std::span<const Handle> handles, const Positions& positions);

}  // namespace chebnet
