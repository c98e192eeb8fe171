#pragma once

#include <optional>

#include "net/net.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// The net of about so many cells, or with edges of a length (of the two the one that is not 0), that grows from the
/// best of several places (see propose_drapes) over a surface, with no corner sharper than `smallest_angle` (radians):
/// it has no singular vertices, and gaps where it locks. Nothing where it falls apart, or the surface is of several
/// pieces.
std::optional<Net> one_piece(const Surface& surface, const SurfaceTree& tree, double cells, double length,
                             double smallest_angle);

}  // namespace chebnet
