#pragma once

#include "energy/edge_energy.h"

namespace chebnet {

/// The paper's energy, f(r) = r^p + r^−p − 2 (Li et al. 2022, eq. 3; the constant 2 is taken off so that f(1) = 0, and
/// relative changes of the energy mean something near the solution), with the paper's majorizer.
class PowerEnergy : public EdgeEnergy {
public:
    /// p > 1.
    explicit PowerEnergy(double p) : m_p(p) {}

    /// Computed without cancellation near r = 1, as (r^(p/2) − r^(−p/2))².
    double value(double r) const override;
    /// f′(r) = p (r^(p−1) − r^(−p−1)), likewise.
    double slope(double r) const override;
    double second_derivative(double r) const override;
    /// The Hessian at r of the convex majorizer f̂(x) = g(x) + 1 / (g₀ + ∇g₀·(x − x₀)) with g = r^p (section 3.2.1):
    /// ∇²g + (2/g³) ∇g ∇gᵀ. Positive definite.
    EdgeCurvature curvature(double r) const override;

protected:
    double m_p;
};

}  // namespace chebnet
