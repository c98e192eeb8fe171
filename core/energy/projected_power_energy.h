#pragma once

#include "energy/power_energy.h"

namespace chebnet {

/// The paper's energy with its true Hessian, projected to be positive semi-definite edge by edge: compressed edges lose
/// their negative tangential weight.
class ProjectedPowerEnergy : public PowerEnergy {
public:
    using PowerEnergy::PowerEnergy;

    EdgeCurvature curvature(double r) const override { return positive_part(hessian(r)); }
};

}  // namespace chebnet
