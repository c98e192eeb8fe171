#include "solve/composite_majorization.h"

#include "energy/composite_power_energy.h"
#include "solve/newton_direction.h"
#include "solve/staged_descent.h"

namespace chebnet {

std::unique_ptr<Method> make_composite_majorization() {
    return std::make_unique<StagedDescent>(make_energy<CompositePowerEnergy>, std::make_unique<NewtonDirection>());
}

}  // namespace chebnet
