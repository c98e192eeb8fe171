#pragma once

#include <cmath>

#include "solve/options.h"
#include "solve/trace.h"

namespace chebnet {

/// When no net exists there is nothing to be exact about: the shape is even enough when the energy falls by less than
/// this part of it. Going on to the minimum would take hundreds of iterations without a visible change.
inline constexpr double k_unreachable_progress = 1e-3;

/// Whether an iteration has brought the energy to rest, by the paper's first two rules (ε_1 and ε_2, section 3.2).
/// `gradient_norm` as in TraceRow; `reachable` as in Problem.
inline bool has_settled(const Options& options, bool reachable, double energy_before, double energy,
                        double gradient_norm) {
    const double tolerance = reachable ? options.energy_tolerance : k_unreachable_progress;
    return std::abs(energy_before - energy) <= tolerance * energy_before || gradient_norm < options.gradient_tolerance;
}

/// How a solve ends that can go no further.
inline Status ended(bool reachable) { return reachable ? Status::stalled : Status::unreachable; }

}  // namespace chebnet
