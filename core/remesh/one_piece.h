#pragma once

#include <optional>

#include "net/net.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// The net of about so many cells, or with edges of a length (of the two the one that is not 0), that grows from the
/// best of several places (see propose_drapes) over all of a surface that is a disc, with no corner sharper than
/// `smallest_angle` (radians): it has no singular vertices. Nothing for other surfaces, or where a gap or a slit would
/// stay open.
std::optional<Net> one_piece(const Surface& surface, const SurfaceTree& tree, double cells, double length,
                             double smallest_angle);

}  // namespace chebnet
