#include "solve/gauss_newton.h"

#include "energy/spring_energy.h"
#include "solve/newton_direction.h"
#include "solve/staged_descent.h"

namespace chebnet {

std::unique_ptr<Method> make_gauss_newton() {
    const auto make_springs = [](double, const Options&) -> std::unique_ptr<EdgeEnergy> {
        return std::make_unique<SpringEnergy>();
    };
    return std::make_unique<StagedDescent>(make_springs, std::make_unique<NewtonDirection>(), keep_all_vertices);
}

}  // namespace chebnet
