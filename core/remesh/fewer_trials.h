#pragma once

#include <memory>
#include <optional>

#include "remesh/net_trials.h"
#include "remesh/phase_clock.h"
#include "remesh/quad_mesher.h"
#include "remesh/remesh.h"
#include "surface/guide.h"

namespace chebnet {

/// The net with as few singular vertices as can be, or, unless RemeshOptions::fewest asks for that, without any, which
/// small nets are tried for first. Nothing where the options leave no room for it, none can be left out, or small nets
/// promise what larger ones do not keep; the mesher then has the wishes that it had.
std::optional<TriedNet> with_fewer_singular(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                                            QuadMesher& mesher, NetTrials& trials, PhaseClock& clock);

}  // namespace chebnet
