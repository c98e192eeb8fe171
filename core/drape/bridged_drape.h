#pragma once

#include <memory>

#include "drape/drape.h"
#include "surface/guide.h"

namespace chebnet {

/// A net that goes on where drape() locks and leaves a gap, off the surface by up to `most_height` edge lengths: laid
/// with corners half as sharp as the limit again, it is brought to rest near the surface within the limit by
/// `equilibrium`, and cells whose vertices are higher than that are taken off. All else is as in drape(), whose own net
/// it is if nothing locks, or if that covers as much. Else it takes about as long as making a net at rest. Throws Error
/// as drape() does, and bad_option for a height out of (0, 10].
Drape bridged_drape(const std::shared_ptr<const Guide>& guide, const DrapeOptions& options, double most_height);

}  // namespace chebnet
