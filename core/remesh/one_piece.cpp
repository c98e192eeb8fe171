#include "remesh/one_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "drape/drape.h"
#include "drape/proposals.h"
#include "net/topology.h"

namespace chebnet {

namespace {

// Radians: drape() lays no net without a limit.
constexpr double k_least_limit = 0.5 * std::numbers::pi / 180;

}  // namespace

std::optional<Net> one_piece(const Surface& surface, const SurfaceTree& tree, double cells, double length,
                             double smallest_angle) {
    const std::vector<int> pieces = surface.components();
    if (std::any_of(pieces.begin(), pieces.end(), [](int piece) { return piece > 0; })) return std::nullopt;
    try {
        DrapeOptions options = suggested_drape(surface, tree, 1);
        options.length = length > 0 ? length : std::sqrt(surface.area() / cells);
        options.smallest_angle = std::max(smallest_angle, k_least_limit);
        options = propose_drapes(surface, tree, options).front().options;
        Net net = drape(surface, tree, options).net;
        if (length == 0) {
            // Sheared cells are smaller than square ones, and some go over the border.
            options.length *= std::sqrt(net.face_count() / cells);
            net = drape(surface, tree, options).net;
        }
        if (Topology(net).component_count() == 1) return net;
    } catch (const Error&) {  // no cell fits where it would begin
    }
    return std::nullopt;
}

}  // namespace chebnet
