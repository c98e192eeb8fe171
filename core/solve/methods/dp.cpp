#include "energy/length_power_energy.h"
#include "solve/methods/methods.h"
#include "solve/parts/newton_direction.h"
#include "solve/parts/option_names.h"
#include "solve/parts/staged_descent.h"

namespace chebnet {

namespace {

template <int p>
std::unique_ptr<Method> make_dp() {
    return std::make_unique<StagedDescent>(make_energy<LengthPowerEnergy>, std::make_unique<NewtonDirection>(),
                                           [](Options& options) { options.p_end = p; });
}

constexpr auto k_dp_options =
    joined(k_tolerances, std::array{"p_start", "adaptive_p", "switch_deviation"}, k_reduction);

constexpr const char* k_citation =
    "Li, Guo, Wang, Chai, Liu, Fu: Interactive Editing of Discrete Chebyshev Nets. Computer Graphics Forum 41(2), 2022";

}  // namespace

/// D_p, the sum of |r − 1|^p (Li et al. 2022, eq. 12) with the majorizer of the split (13), in the paper's stages:
/// exponent p_start first, then 4 or 8 in place of p_end. See StagedDescent.
constinit const MethodInfo k_dp4 = {"dp4",        "The energy |r - 1|^p with the paper's stages and p = 4 at the end.",
                                    k_citation,   k_staged_names,
                                    k_dp_options, in_this_build(make_dp<4>)};
constinit const MethodInfo k_dp8 = {"dp8",        "The energy |r - 1|^p with the paper's stages and p = 8 at the end.",
                                    k_citation,   k_staged_names,
                                    k_dp_options, in_this_build(make_dp<8>)};

}  // namespace chebnet
