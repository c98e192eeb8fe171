#include "energy/direct_energy.h"
#include "energy/power_energy.h"
#include "solve/methods/methods.h"
#include "solve/parts/newton_direction.h"
#include "solve/parts/option_names.h"
#include "solve/parts/staged_descent.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_li2022() {
    const auto energy = [](double p, const Options& options) {
        return options.direct_energy ? make_energy<DirectEnergy>(p, options) : make_energy<PowerEnergy>(p, options);
    };
    return std::make_unique<StagedDescent>(energy, std::make_unique<NewtonDirection>());
}

constexpr auto k_li2022_options = joined(k_tolerances, k_exponents, k_reduction, std::array{"direct_energy"});

}  // namespace

/// The method of Li et al. 2022: energy (3), its convex majorizer's Hessian, three stages. See StagedDescent. With the
/// option direct_energy it minimises E_p of eq. 2 instead, which the paper sets aside for energy (3).
constinit const MethodInfo k_li2022 = {
    "li2022",
    "The paper's: the energy r^p + r^-p, Newton steps on its convex majorizer, in three stages.",
    "Li, Guo, Wang, Chai, Liu, Fu: Interactive Editing of Discrete Chebyshev Nets. Computer Graphics Forum 41(2), 2022",
    k_staged_names,
    k_li2022_options,
    in_this_build(make_li2022)};

}  // namespace chebnet
