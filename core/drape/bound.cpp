#include "drape/bound.h"

namespace chebnet {

namespace {

bool is_at_cut(const Surface& surface, const DrapeOptions& options, const Slits* slits, const SurfacePoint& at) {
    if (slits != nullptr && slits->is_on_bank(at)) return true;
    if (options.seam.empty()) return false;
    for (int k = 0; k < 3; ++k)
        if (at.weights[k] > 0 && !options.seam[surface.triangles()(k, at.face)]) return false;
    return true;
}

}  // namespace

bool is_bound(const Surface& surface, const DrapeOptions& options, const Slits* slits, const SurfacePoint& at) {
    switch (options.border) {
        case DrapeOptions::Border::inside:
            return true;
        case DrapeOptions::Border::beyond:
            return !options.beyond_cuts && is_at_cut(surface, options, slits, at);
        case DrapeOptions::Border::cut:
            return false;  // where rods are cut they end on it from either side
    }
    return false;
}

}  // namespace chebnet
