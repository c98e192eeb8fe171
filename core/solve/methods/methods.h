#pragma once

#include "solve/method.h"

namespace chebnet {

/// `make`; or null in sources compiled for their words only.
static consteval MakeMethod in_this_build([[maybe_unused]] MakeMethod make) {
#ifdef CHEBNET_WORDS_OF_METHODS_ONLY
    return nullptr;
#else
    return make;
#endif
}

/// The methods, one file each.
extern const MethodInfo k_li2022, k_projection, k_equilibrium, k_composite_majorization, k_projected_newton,
    k_gauss_newton, k_dp4, k_dp8, k_arap, k_local_global, k_gradient_descent, k_lbfgs;

}  // namespace chebnet
