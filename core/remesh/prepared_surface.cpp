#include "remesh/prepared_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "base/error.h"
#include "remesh/pinholes.h"
#include "surface/smoothed_surface.h"

namespace chebnet {

namespace {

constexpr int k_sides = 4;  // of a cell
// A surface whose triangles are inclined by more than this to those of the surface that is smoothed over a cell is
// rough, in radians, on average. What is larger than cells of so many is shape rather than noise.
constexpr double k_rough_tilt = 7 * std::numbers::pi / 180, k_fewest_smoothing_cells = 1500;
constexpr double k_farthest_smoothing = 5;  // in cells
// Once noise is gone, smoothing twice as far moves the surface little farther, a fifth for that of a scan; where it
// melts edges and ribs, three times as far.
constexpr double k_melting = 2;

}  // namespace

double cells_asked_for(const Surface& surface, const RemeshOptions& options) {
    return options.length > 0 ? surface.area() / options.length / options.length : options.cells;
}

bool has_border(const Surface& surface) {
    for (int s = 0; s < 3 * surface.face_count(); ++s)
        if (surface.opposite(s) < 0) return true;
    return false;
}

std::shared_ptr<const Guide> without_small_holes(const std::shared_ptr<const Guide>& guide,
                                                 const RemeshOptions& options) {
    const Surface& surface = guide->surface();
    const double cell = std::sqrt(surface.area() / cells_asked_for(surface, options));
    std::optional<Surface> closed = without_pinholes(surface, k_sides * cell);
    return closed ? std::make_shared<const Guide>(*std::move(closed)) : guide;
}

std::shared_ptr<const Guide> without_noise(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                                           const std::function<void()>& go_on) {
    if (options.crease > 0 || !options.marked_creases.empty()) return guide;
    const Surface& surface = guide->surface();
    const double cells = std::max(k_fewest_smoothing_cells, cells_asked_for(surface, options));
    const double cell = std::sqrt(surface.area() / cells);
    std::optional<Surface> smooth;
    try {
        for (double radius = cell; radius < k_farthest_smoothing * cell; radius *= 2) {
            Surface smoother = smoothed(surface, radius, go_on);
            if (mean_tilt(smooth ? *smooth : surface, smoother) < k_rough_tilt) break;
            if (smooth && mean_move(surface, smoother) > k_melting * mean_move(surface, *smooth)) break;
            smooth = std::move(smoother);
        }
    } catch (const Error&) {  // triangles that vanish
    }
    return smooth ? std::make_shared<const Guide>(*std::move(smooth)) : guide;
}

}  // namespace chebnet
