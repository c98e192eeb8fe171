#include "solve/dp.h"

#include "energy/length_power_energy.h"
#include "solve/newton_direction.h"
#include "solve/staged_descent.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_dp(StagedDescent::Adjust adjust) {
    return std::make_unique<StagedDescent>(make_energy<LengthPowerEnergy>, std::make_unique<NewtonDirection>(), adjust);
}

}  // namespace

std::unique_ptr<Method> make_dp4() {
    return make_dp([](Options& options) { options.p_end = 4; });
}

std::unique_ptr<Method> make_dp8() {
    return make_dp([](Options& options) { options.p_end = 8; });
}

}  // namespace chebnet
