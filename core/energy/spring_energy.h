#pragma once

#include "energy/edge_energy.h"

namespace chebnet {

/// A spring, f(r) = (r − 1)², for steps of Gauss and Newton: its own curvature along the edge, and across it a small
/// part of that, whatever the ratio. On all edges together that part is a Laplacian, which chooses the smoothest of the
/// many steps that the lengths leave open.
class SpringEnergy : public EdgeEnergy {
public:
    double value(double r) const override { return (r - 1) * (r - 1); }
    double slope(double r) const override { return 2 * (r - 1); }
    double second_derivative(double) const override { return 2; }
    EdgeCurvature curvature(double) const override { return {2, 2 * k_smoothness}; }

private:
    static constexpr double k_smoothness = 1e-4;
};

}  // namespace chebnet
