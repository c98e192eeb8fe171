#include "energy/composite_power_energy.h"
#include "solve/methods/methods.h"
#include "solve/parts/newton_direction.h"
#include "solve/parts/option_names.h"
#include "solve/parts/staged_descent.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_composite_majorization() {
    return std::make_unique<StagedDescent>(make_energy<CompositePowerEnergy>, std::make_unique<NewtonDirection>());
}

constexpr auto k_composite_majorization_options = joined(k_tolerances, k_exponents, k_reduction);

}  // namespace

/// Composite majorization (Shtengel et al. 2017) on the paper's energy, with the paper's stages. See StagedDescent.
constinit const MethodInfo k_composite_majorization = {
    "composite_majorization",
    "The paper's energy and stages; compressed edges get no tangential stiffness.",
    "Shtengel, Poranne, Sorkine-Hornung, Kovalsky, Lipman: Geometric Optimization via Composite Majorization. ACM "
    "Transactions on Graphics 36(4), 2017",
    k_staged_names,
    k_composite_majorization_options,
    in_this_build(make_composite_majorization)};

}  // namespace chebnet
