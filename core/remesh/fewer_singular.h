#pragma once

#include <vector>

#include "remesh/direction_field.h"
#include "remesh/wish_placer.h"
#include "surface/surface.h"

namespace chebnet {

/// The singular vertices of a field, each of index 1 or −1, of which two stand where a vertex has twice as much, and
/// then fewer and fewer, to be wished for alone: of each entry those two of opposite index that are nearest to each
/// other, on one piece of the surface, have cancelled each other in the next, or that one which is nearest to the
/// border has gone over it, whichever is nearer. None goes over the border where that is held (of each side; empty:
/// nowhere). Of the last one only those are left that no net of that topology is without (Σ index = 4 χ): none where
/// they may go over some border of each piece.
///
/// A field of directions at right angles needs singular vertices wherever the surface curves, or its cells would have
/// other lengths; in a Chebyshev net cells may shear instead. Which of these a net can do without only a net shows.
std::vector<std::vector<PlacedWishes::Pin>> fewer_and_fewer(const Surface& surface, const DirectionField& field,
                                                            const std::vector<bool>& held_border);

}  // namespace chebnet
