#include "remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/stopwatch.h"
#include "net/measures.h"
#include "remesh/creases.h"
#include "remesh/limb_trials.h"
#include "remesh/prepared_surface.h"
#include "remesh/remesh_one_way.h"
#include "remesh/rows.h"
#include "remesh/scraps.h"
#include "remesh/way_trials.h"

namespace chebnet {

namespace {

constexpr double k_most_smoothing = 100;
// Of a cell, in the surface's unit, or its inverse: beyond it lengths are lost beside numbers that have no unit.
constexpr double k_largest_cell = 1e15;

/** Refuses `number` unless it is from 0 to `most`, with the sentence that says so. */
void check_number(double number, double most, const char* refusal) {
    if (!std::isfinite(number)) throw Error(ErrorCode::non_finite, refusal);
    if (!(number >= 0 && number <= most)) throw Error(ErrorCode::bad_option, refusal);
}

bool has_creases(const Surface& surface, double angle) {
    const std::vector<bool> creases = creases_of(surface, angle);
    return std::find(creases.begin(), creases.end(), true) != creases.end();
}

/// What cannot be followed is not asked for: all that creases rule out is tried as without them.
RemeshOptions without_absent_creases(const Surface& surface, RemeshOptions options) {
    if (options.crease > 0 && !has_creases(surface, options.crease)) options.crease = 0;
    return options;
}

/// Over all of a surface whose small holes are closed.
Remesh remesh_closed(const std::shared_ptr<const Guide>& closed, const RemeshOptions& asked,
                     const RemeshProgress& progress) {
    const Stopwatch watch;
    const RemeshOptions options = without_absent_creases(closed->surface(), asked);
    const bool may_crease =
        asked.tries_creases && asked.crease == 0 && !asked.fewest && has_creases(closed->surface(), k_sharp_edge);
    const bool fits_border = options.border == RemeshOptions::Border::fitting && has_border(closed->surface());
    const bool tries_ways = fits_border || may_crease;
    const RemeshPhase first = tries_ways ? RemeshPhase::border : RemeshPhase::triangles;
    const std::shared_ptr<const Guide> surface = without_noise(closed, options, [&] {
        if (progress) progress(first, 0);
    });
    const double milliseconds = watch.milliseconds();
    // What is rough has no edges.
    Remesh made = tries_ways ? remesh_best_way(surface, options, may_crease && surface == closed, progress)
                             : remesh_one_way(surface, options, progress);
    made.milliseconds[static_cast<int>(first)] += milliseconds;
    return made;
}

}  // namespace

const char* to_string(RemeshPhase phase) {
    constexpr const char* k_names[] = {"border", "triangles", "singular", "field", "grid", "fit"};
    return k_names[static_cast<int>(phase)];
}

void check_remesh(const Guide& guide, const RemeshOptions& options) {
    const Surface& surface = guide.surface();
    check_number(options.length, std::numeric_limits<double>::max(),
                 "the length of the edges must be finite, and positive");
    check_number(options.smoothing, k_most_smoothing, "the smoothing must be from 0 to 100");
    check_number(options.smallest_angle, std::numbers::pi / 3, "the shear limit must be from 0 to 60 degrees");
    check_number(options.crease, std::numbers::pi, "the angle of creases must be from 0 to 180 degrees");
    if (!(surface.area() > 0)) throw Error(ErrorCode::bad_option, "the surface has no area");
    const double cells = cells_asked_for(surface, options);
    if (!(cells >= k_least_remeshed_cells))
        throw Error(ErrorCode::bad_option, "a net of a whole surface has at least " +
                                               std::to_string(k_least_remeshed_cells) + " cells" +
                                               (options.length > 0 ? "; the edges are too long for this surface" : ""));
    if (!(cells <= k_most_remeshed_cells))
        throw Error(ErrorCode::too_large, "the net would have about " + number_text(cells, 3) + " cells; more than " +
                                              std::to_string(k_most_remeshed_cells) +
                                              " are not made of a whole surface");
    const double cell = std::sqrt(surface.area() / cells);
    if (!(cell <= k_largest_cell && cell >= 1 / k_largest_cell))
        throw Error(ErrorCode::bad_scale,
                    "the surface is too large or too small for a net over the whole of it: scale it");
    check_scraps(surface, surface.area() / cells);
    check_wishes(guide, options.singular);
    if (options.fewest && (options.singular.only || !options.singular.vertices.empty()))
        throw Error(ErrorCode::bad_option, "either as few singular vertices as can be, or those that are wished for");
    check_marked(guide, options.marked_creases);
}

Remesh remesh(const std::shared_ptr<const Guide>& guide, const RemeshOptions& asked, const RemeshProgress& progress) {
    check_remesh(*guide, asked);
    Remesh made = with_fitting_limbs(
        without_small_holes(guide, asked), asked,
        [&](const std::shared_ptr<const Guide>& closed) { return remesh_closed(closed, asked, progress); });
    Mesh rows = in_rows({made.net.rest_positions(), made.net.faces()});
    made.net = Net(std::move(rows.positions), std::move(rows.faces), RestLengths::equal);
    made.singular = singular_vertices(made.net);
    made.sharp_quads = sharp_quads(made.net, made.net.rest_positions(), asked.smallest_angle - k_limit_tolerance);
    return made;
}

}  // namespace chebnet
