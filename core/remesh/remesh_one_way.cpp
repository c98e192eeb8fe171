#include "remesh/remesh_one_way.h"

#include <limits>
#include <optional>
#include <utility>

#include "remesh/fewer_trials.h"
#include "remesh/net_trials.h"
#include "remesh/phase_clock.h"
#include "remesh/quad_mesher.h"

namespace chebnet {

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
    if (!found) found = trials.best();
    if (!found && trials.were_uneven()) return std::nullopt;
    if (!found) trials.refuse();
    clock.end();
    return Remesh{std::move(found->net), std::move(found->singular), std::move(found->kept), 0, clock.milliseconds()};
}

}  // namespace chebnet
