#pragma once

#include <optional>
#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// The surface with holes closed whose border is no longer than `longest`, each by triangles to its middle, which have
/// numbers behind its own. The border around a piece that is hardly larger than what it encloses is none of a hole.
/// Nothing if the surface has no holes, or if that gives no surface, as where a hole touches itself.
std::optional<Surface> without_pinholes(const Surface& surface, double longest);

/// The same for holes with these borders, each one of the surface's boundary_loops().
std::optional<Surface> closed_at(const Surface& surface, const std::vector<std::vector<int>>& loops);

}  // namespace chebnet
