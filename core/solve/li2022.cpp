#include "solve/li2022.h"

#include "energy/power_energy.h"
#include "solve/staged_newton.h"

namespace chebnet {

std::unique_ptr<Method> make_li2022() {
    return std::make_unique<StagedNewton>(
        [](double p) -> std::unique_ptr<EdgeEnergy> { return std::make_unique<PowerEnergy>(p); });
}

}  // namespace chebnet
