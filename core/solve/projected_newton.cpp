#include "solve/projected_newton.h"

#include "energy/projected_power_energy.h"
#include "solve/newton_direction.h"
#include "solve/staged_descent.h"

namespace chebnet {

std::unique_ptr<Method> make_projected_newton() {
    return std::make_unique<StagedDescent>(make_energy<ProjectedPowerEnergy>, std::make_unique<NewtonDirection>());
}

}  // namespace chebnet
