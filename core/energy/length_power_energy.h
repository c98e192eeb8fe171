#pragma once

#include "energy/edge_energy.h"

namespace chebnet {

/// D_p, f(r) = |r − 1|^p (Li et al. 2022, eq. 12).
class LengthPowerEnergy : public EdgeEnergy {
public:
    /// p > 1. Below 2 the second derivative is bounded: its value at r = 1 is finite, not f''(1).
    explicit LengthPowerEnergy(double p) : m_p(p) {}

    double value(double r) const override;
    double slope(double r) const override;
    double second_derivative(double r) const override;
    /// The Hessian of the majorizer h⁺(r(x)) + h⁻(r₀ + ∇r₀·(x − x₀)), where h⁺ and h⁻ are f for r ≥ 1 and for r < 1
    /// (the split of eq. 13). Since f is convex in r, it is the positive part of the true Hessian.
    EdgeCurvature curvature(double r) const override { return positive_part(hessian(r)); }

    /// Beside (r − 1)², which is |r − 1|^p with p = 2.
    double relative_slope(double deviation) const override;

private:
    double m_p;
};

}  // namespace chebnet
