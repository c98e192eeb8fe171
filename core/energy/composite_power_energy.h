#pragma once

#include "energy/power_energy.h"

namespace chebnet {

/// The paper's energy with the majorizer of composite majorization (Shtengel et al. 2017). f = h(g) with g = r^p and
/// h(y) = y + 1/y − 2 = h⁺ + h⁻, the part that rises (y ≥ 1) and the part that falls (y < 1); the majorizer at x₀ is
/// h⁺(g(x)) + h⁻(g₀ + ∇g₀·(x − x₀)).
class CompositePowerEnergy : public PowerEnergy {
public:
    using PowerEnergy::PowerEnergy;

    /// r ≥ 1: (1 − 1/g²) ∇²g + (2/g³) ∇g ∇gᵀ, which is the true Hessian; r < 1: (2/g³) ∇g ∇gᵀ alone. A compressed edge
    /// has no tangential stiffness, and one at r = 1 neither.
    EdgeCurvature curvature(double r) const override;
};

}  // namespace chebnet
