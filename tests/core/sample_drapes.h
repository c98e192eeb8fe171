#pragma once

#include <optional>

#include "base/error.h"
#include "drape/drape.h"

namespace chebnet::samples {

/// Nothing where no cell fits, or the direction leads off the surface.
inline std::optional<Drape> drape_if_any(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options) {
    try {
        return drape(surface, tree, options);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace chebnet::samples
