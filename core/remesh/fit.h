#pragma once

#include <functional>

#include "net/mesh.h"
#include "net/net.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

struct FitOptions {
    double length = 0;          ///< L, of all edges; 0: the one that fits best
    double smallest_angle = 0;  ///< of corners of quads, radians
};

/// A net with the mesh's faces near the surface, all edges of one length and no corner sharper than the limit.
///
/// First springs that get stiffer draw the edges towards L and the corners out of the limit, while vertices are drawn
/// to the tangent planes of the surface and net lines to be straight (Gauss–Newton steps); then edges and corners are
/// projected onto what they have to be (LengthProjection, CornerLimit). `go_on` is told the part that is done, and may
/// end it all by an exception. Throws Error as Net does, and bad_option where no such net is found.
Net fit_net(const Surface& surface, const SurfaceTree& tree, const Mesh& mesh, const FitOptions& options,
            const std::function<void(double)>& go_on);

}  // namespace chebnet
