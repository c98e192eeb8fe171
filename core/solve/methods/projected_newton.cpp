#include "energy/projected_power_energy.h"
#include "solve/methods/methods.h"
#include "solve/parts/newton_direction.h"
#include "solve/parts/option_names.h"
#include "solve/parts/staged_descent.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_projected_newton() {
    return std::make_unique<StagedDescent>(make_energy<ProjectedPowerEnergy>, std::make_unique<NewtonDirection>());
}

constexpr auto k_projected_newton_options = joined(k_tolerances, k_exponents, k_reduction);

}  // namespace

/// Newton's method on the paper's energy, each edge's Hessian projected to be positive semi-definite, with the paper's
/// stages. See StagedDescent.
constinit const MethodInfo k_projected_newton = {
    "projected_newton",
    "The paper's energy and stages; the true Hessian, made positive semi-definite edge by edge.",
    "Teran, Sifakis, Irving, Fedkiw: Robust Quasistatic Finite Elements and Flesh Simulation. Symposium on Computer "
    "Animation 2005",
    k_staged_names,
    k_projected_newton_options,
    in_this_build(make_projected_newton)};

}  // namespace chebnet
