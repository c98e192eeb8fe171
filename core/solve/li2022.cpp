#include "solve/li2022.h"

#include "energy/direct_energy.h"
#include "energy/power_energy.h"
#include "solve/newton_direction.h"
#include "solve/staged_descent.h"

namespace chebnet {

std::unique_ptr<Method> make_li2022() {
    const auto energy = [](double p, const Options& options) {
        return options.direct_energy ? make_energy<DirectEnergy>(p, options) : make_energy<PowerEnergy>(p, options);
    };
    return std::make_unique<StagedDescent>(energy, std::make_unique<NewtonDirection>());
}

}  // namespace chebnet
