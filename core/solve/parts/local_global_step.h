#pragma once

#include <memory>

#include "solve/parts/alternating_step.h"

namespace chebnet {

/// Local–global optimisation (projections as in Bouaziz et al. 2012, the energy of springs as in Liu et al. 2013):
///
///     E = Σ_e (ℓ_e − L_e)² = min over ‖t_e‖ = L_e of Σ_e ‖d_e − t_e‖².
class LocalGlobalStep : public AlternatingStep {
public:
    using AlternatingStep::AlternatingStep;

    /// t_e: the edge's present direction at its rest length; the direction it has at rest if it has no length now.
    void project(const Positions& positions) override;
    double energy(const Positions& positions) const override;
};

}  // namespace chebnet
