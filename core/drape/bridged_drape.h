#pragma once

#include <memory>

#include "drape/drape.h"
#include "surface/guide.h"

namespace chebnet {

/// A net that goes on where drape() locks and leaves a gap, off the surface by up to `most_height` edge lengths: laid
/// with corners sharper than the limit, which are opened then (see with_opened_corners); cells whose vertices are
/// higher than that, or on the rest of the net, or beyond the border where none may be, are taken off. All else is as
/// in drape(), whose own net it is if nothing locks, or if that covers as much. Throws Error as drape() does,
/// bad_option for a height out of (0, 10], and too_large where something locks in a net with more edges than can be
/// opened.
Drape bridged_drape(const std::shared_ptr<const Guide>& guide, const DrapeOptions& options, double most_height);

}  // namespace chebnet
