#include "solve/methods/methods.h"
#include "solve/parts/alternating.h"
#include "solve/parts/local_global_step.h"
#include "solve/parts/option_names.h"

namespace chebnet {

namespace {

std::unique_ptr<Method> make_local_global() {
    return std::make_unique<Alternating>(make_alternating_step<LocalGlobalStep>);
}

}  // namespace

constinit const MethodInfo k_local_global = {
    "local_global",
    "Each edge takes its length by itself, then one constant linear system fits them together.",
    "Bouaziz, Deuss, Schwartzburg, Weise, Pauly: Shape-Up: Shaping Discrete Geometry with Projections. Computer "
    "Graphics Forum 31(5), 2012; Liu, Bargteil, O'Brien, Kavan: Fast Simulation of Mass-Spring Systems. ACM "
    "Transactions on Graphics 32(6), 2013",
    k_alternating_names,
    k_tolerances,
    in_this_build(make_local_global)};

}  // namespace chebnet
