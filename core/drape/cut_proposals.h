#pragma once

#include <vector>

#include "drape/drape.h"
#include "surface/surface_cut.h"

namespace chebnet {

/// Cuts that have been tried, and what came of them.
struct CutProposals {
    std::vector<CutLine> cuts;     ///< in the order in which they help, each beside all before it
    std::vector<double> coverage;  ///< one more than cuts: of the uncut surface, and with each further cut; rising
};

/// Looks for up to `most` cuts with which nets cover more of a surface. Tried are ways to the border, or to earlier
/// cuts, from places at which a net locks or is sheared most, and between two of these places; with nets of about a
/// thousand cells and geodesic arms those that promise most, then the best with the edges asked for. Only cuts with
/// which coverage (see DrapeReport) rises by more than k_least_gain there are proposed: there may be none. Nets begin
/// where `options` says on its piece, in the middle of others. Takes some seconds for each cut. Throws Error as drape
/// does.
CutProposals propose_cuts(const Surface& surface, const DrapeOptions& options, int most);

inline constexpr double k_least_gain = 0.005;

}  // namespace chebnet
