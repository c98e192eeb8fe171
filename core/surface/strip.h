#pragma once

#include <optional>
#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// Triangles, each with a side in common with the next: what a path over a surface passes.
using Strip = std::vector<int>;

/// The triangles on the shortest way from middle to middle over those of the edges between (A*, Hart et al. 1968).
/// Empty if the two are on different pieces of the surface.
Strip strip_over_middles(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to);

/// Those beside the shortest way along edges : no path within them that is pulled taut is longer. From
/// and to points of one piece.
Strip strip_along_edges(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to);

/// Without loops, and without triangles at its ends that the path need not enter.
Strip tidied(const Surface& surface, const Strip& strip, const SurfacePoint& from, const SurfacePoint& to);

/// Led along the other side of a vertex that it passes; nothing at the boundary.
std::optional<Strip> around_other_side(const Surface& surface, const Strip& strip, int vertex);

}  // namespace chebnet
