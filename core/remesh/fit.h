#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "net/mesh.h"
#include "net/net.h"
#include "solve/pull.h"
#include "surface/guide.h"
#include "surface/segment.h"

namespace chebnet {

struct FitOptions {
    double length = 0;             ///< L, of all edges; 0: the one that fits best
    double smallest_angle = 0;     ///< of corners of quads, radians
    std::vector<Pull> pulls;       ///< of vertices of the mesh, each towards a point of the surface
    std::vector<Segment> creases;  ///< on the surface, which net lines near them follow
    bool suits_creases = false;    ///< if no length is given, it is the one with which net lines along creases are as
                                   ///< long as these: closed ones are not followed else
    std::vector<bool> border;      ///< of each side of the surface, whether it is on a border where the mesh's is to
                                   ///< be, and its corners at corners; empty: none is
};

/// A net with the mesh's faces near the surface, all edges of one length and no corner sharper than the limit, but
/// where that many projections do not open all of them: lengths come first.
///
/// First edges are evened out while vertices slide over the surface and corners stay open (Gauss–Newton steps); then
/// net lines bend as little as they can near it (FairStart), on closed surfaces also as they are laid on it, for about
/// singular vertices straight ones would raise tips; then edges and corners are projected onto what they have to be
/// (LengthProjection, CornerLimit), and the net comes to rest near the surface (method `equilibrium`). `go_on` is told
/// the part that is done, and may end it all by an exception. Throws Error as Net does, and bad_option where no such
/// net is found.
Net fit_net(const std::shared_ptr<const Guide>& guide, const Mesh& mesh, const FitOptions& options,
            const std::function<void(double)>& go_on);

/// What lengths of edges err by, root mean square, in L, once they have been evened out on the surface for a while:
/// where it does not allow for edges of one length, a net has to fold. `smallest_angle` as for fit_net(). Throws Error
/// as Net does.
double evened_error(const std::shared_ptr<const Guide>& guide, const Mesh& mesh, double smallest_angle);

}  // namespace chebnet
