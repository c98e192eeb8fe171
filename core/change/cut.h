#pragma once

#include "change/change.h"

namespace chebnet {

/// The faces on both sides of the place's edges no longer share these: each side has its own vertices along them, the
/// new ones at the end, at the same points. Where a line of edges ends inside of the net its end stays one vertex, so
/// that the cut is a slit. Throws Error impossible_change where no vertex is parted by that.
ChangedMesh cut(const Net& net, const ChangePlace& place);

/// Likewise, and faces that meet at one of the place's vertices, but not along edges there, get a vertex each. Nothing
/// may be parted by that.
ChangedMesh parted(const Net& net, const ChangePlace& place);

}  // namespace chebnet
