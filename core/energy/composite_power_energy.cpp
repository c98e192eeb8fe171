#include "energy/composite_power_energy.h"

#include <cmath>

namespace chebnet {

EdgeCurvature CompositePowerEnergy::curvature(double r) const {
    if (r >= 1) return hessian(r);
    return {2 * m_p * m_p * std::pow(r, -m_p - 2), 0};
}

}  // namespace chebnet
