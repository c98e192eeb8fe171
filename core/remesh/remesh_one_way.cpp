#include "remesh/remesh_one_way.h"

#include <limits>
#include <optional>
#include <utility>

#include "drape/tilt.h"
#include "remesh/fewer_trials.h"
#include "remesh/net_trials.h"
#include "remesh/phase_clock.h"
#include "remesh/quad_mesher.h"

namespace chebnet {

namespace {

/// What small nets promise a large one may not keep: if it is crumpled, and none asked for so few singular vertices,
/// that with the usual ones, where it is less so. Over a border other ways to end there are tried instead.
TriedNet less_crumpled(const std::shared_ptr<const Guide>& guide, TriedNet few, NetTrials& trials) {
    const int folds = crumpled_edges(*guide, few.net);
    if (folds == 0) return few;
    std::optional<TriedNet> usual = trials.best();
    return usual && crumpled_edges(*guide, usual->net) < folds ? std::move(*usual) : std::move(few);
}

}  // namespace

Remesh remesh_one_way(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                      const RemeshProgress& progress) {
    return *remesh_if_even(guide, options, std::numeric_limits<double>::infinity(), progress);
}

std::optional<Remesh> remesh_if_even(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                                     double most_error, const RemeshProgress& progress) {
    PhaseClock clock(progress);
    clock.begin(RemeshPhase::triangles);
    QuadMesher mesher(guide, options, clock);
    NetTrials trials(guide, options, mesher, clock, most_error);
    std::optional<TriedNet> found = with_fewer_singular(guide, options, mesher, trials, clock);
    if (!found)
        found = trials.best();
    else if (!options.fewest && !mesher.has_border())
        found = less_crumpled(guide, std::move(*found), trials);
    if (!found && trials.were_uneven()) return std::nullopt;
    if (!found) trials.refuse();
    clock.end();
    return Remesh{std::move(found->net), std::move(found->singular), std::move(found->kept), 0, clock.milliseconds()};
}

}  // namespace chebnet
