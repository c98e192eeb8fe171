#include "remesh/remesh_one_way.h"

#include <optional>
#include <utility>

#include "remesh/fewer_trials.h"
#include "remesh/net_trials.h"
#include "remesh/phase_clock.h"
#include "remesh/quad_mesher.h"

namespace chebnet {

Remesh remesh_one_way(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                      const RemeshProgress& progress) {
    PhaseClock clock(progress);
    clock.begin(RemeshPhase::triangles);
    QuadMesher mesher(guide, options, clock);
    NetTrials trials(guide, options, mesher, clock);
    std::optional<TriedNet> found = with_fewer_singular(guide, options, mesher, trials, clock);
    if (!found) found = trials.best();
    if (!found) trials.refuse();
    clock.end();
    return {std::move(found->net), std::move(found->singular), std::move(found->kept), 0, clock.milliseconds()};
}

}  // namespace chebnet
