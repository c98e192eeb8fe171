#pragma once

#include "energy/edge_energy.h"

namespace chebnet {

/// E_p itself, f(r) = dL^p with dL = r + 1/r − 2 (Li et al. 2022, eq. 2), which the paper replaces by energy (3).
/// It vanishes to order 2p at r = 1: there is next to no gradient and curvature left near the solution.
class DirectEnergy : public EdgeEnergy {
public:
    /// p > 1.
    explicit DirectEnergy(double p) : m_p(p) {}

    double value(double r) const override;
    double slope(double r) const override;
    double second_derivative(double r) const override;
    /// As for LengthPowerEnergy: f is convex in r, falls for r < 1 and rises from there.
    EdgeCurvature curvature(double r) const override { return positive_part(hessian(r)); }

private:
    double m_p;
};

}  // namespace chebnet
