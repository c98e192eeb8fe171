#include "drape/bound.h"

namespace chebnet {

bool is_bound(const DrapeOptions& options, const Slits* slits, const SurfacePoint& at) {
    switch (options.border) {
        case DrapeOptions::Border::inside:
            return true;
        case DrapeOptions::Border::beyond:
            return !options.beyond_cuts && slits != nullptr && slits->is_on_bank(at);
        case DrapeOptions::Border::cut:
            return false;  // where rods are cut they end on it from either side
    }
    return false;
}

}  // namespace chebnet
