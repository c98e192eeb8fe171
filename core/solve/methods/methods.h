#pragma once

#include "base/in_this_build.h"
#include "solve/method.h"

namespace chebnet {

/// The methods, one file each.
extern const MethodInfo k_li2022, k_projection, k_equilibrium, k_composite_majorization, k_projected_newton,
    k_gauss_newton, k_dp4, k_dp8, k_arap, k_local_global, k_gradient_descent, k_lbfgs;

/// In the order of menus and help.
inline constexpr const MethodInfo* k_methods[] = {
    &k_li2022, &k_projection, &k_equilibrium, &k_composite_majorization, &k_projected_newton, &k_gauss_newton,
    &k_dp4,    &k_dp8,        &k_arap,        &k_local_global,           &k_gradient_descent, &k_lbfgs};

}  // namespace chebnet
