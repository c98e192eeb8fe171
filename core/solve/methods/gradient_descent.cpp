#include "energy/power_energy.h"
#include "solve/methods/methods.h"
#include "solve/parts/gradient_direction.h"
#include "solve/parts/option_names.h"
#include "solve/parts/staged_descent.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_gradient_descent() {
    return std::make_unique<StagedDescent>(make_energy<PowerEnergy>, std::make_unique<GradientDirection>(),
                                           keep_all_vertices);
}

constexpr auto k_gradient_descent_options = joined(k_tolerances, k_exponents);

}  // namespace

/// Gradient descent on the paper's energy, with its exponents.
constinit const MethodInfo k_gradient_descent = {
    "gradient_descent",
    "Steepest descent on the paper's energy, with a line search: cheap and very many iterations.",
    "Armijo: Minimization of functions having Lipschitz continuous first partial derivatives. Pacific Journal of "
    "Mathematics 16(1), 1966",
    k_staged_names,
    k_gradient_descent_options,
    in_this_build(make_gradient_descent)};

}  // namespace chebnet
