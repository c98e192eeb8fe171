#pragma once

#include "surface/surface.h"
#include "surface/surface_cut.h"

namespace chebnet {

/// The cut from a point of a surface to its border that is no longer than others, as far as geodesic_distances() and
/// shortest_path() tell: two points, `from` and one on the boundary. On a surface that has been cut open (see cut_open)
/// the cuts are border, too. Throws Error bad_option where the point's piece has no border, or it stands on that.
CutLine shortest_cut_to_border(const Surface& surface, const SurfacePoint& from);

/// Likewise between the two boundary curves of a piece that are nearest to each other: cut open along it they are one.
/// Four points, those between at thirds of the way: so it runs the same way where the surface has not been cut open,
/// but the ends may be on both sides of a cut. Of more than 64 pairs of neighbours those are measured that are nearest
/// along edges. Throws Error bad_option where no piece has two.
CutLine shortest_cut_between_borders(const Surface& surface);

}  // namespace chebnet
