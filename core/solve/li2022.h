#pragma once

#include <memory>

#include "solve/method.h"

namespace chebnet {

/// The method of Li et al. 2022: energy (3), its convex majorizer's Hessian, three stages. See StagedDescent. With the
/// option direct_energy it minimises E_p of eq. 2 instead, which the paper sets aside for energy (3).
std::unique_ptr<Method> make_li2022();

}  // namespace chebnet
