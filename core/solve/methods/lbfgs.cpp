#include "energy/power_energy.h"
#include "solve/methods/methods.h"
#include "solve/parts/lbfgs_direction.h"
#include "solve/parts/option_names.h"
#include "solve/parts/staged_descent.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_lbfgs() {
    return std::make_unique<StagedDescent>(make_energy<PowerEnergy>, std::make_unique<LbfgsDirection>(),
                                           keep_all_vertices);
}

constexpr auto k_lbfgs_options = joined(k_tolerances, k_exponents);

}  // namespace

/// L-BFGS on the paper's energy, with its exponents.
constinit const MethodInfo k_lbfgs = {
    "lbfgs",
    "L-BFGS on the paper's energy: learns the curvature from the last ten gradients.",
    "Liu, Nocedal: On the limited memory BFGS method for large scale optimization. Mathematical Programming 45, 1989",
    k_staged_names,
    k_lbfgs_options,
    in_this_build(make_lbfgs)};

}  // namespace chebnet
