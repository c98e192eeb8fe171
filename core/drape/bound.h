#pragma once

#include "drape/drape.h"
#include "drape/slits.h"

namespace chebnet {

/// Whether a net ends inside at a point of the border: everywhere, or as at a cut, behind which more of it lies.
/// `slits`: that are to be kept to; null if there are none.
bool is_bound(const DrapeOptions& options, const Slits* slits, const SurfacePoint& at);

}  // namespace chebnet
