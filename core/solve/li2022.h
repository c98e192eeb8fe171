#pragma once

#include <memory>

#include "solve/method.h"

namespace chebnet {

/// The method of Li et al. 2022: energy (3), its convex majorizer's Hessian, three stages. See StagedNewton.
std::unique_ptr<Method> make_li2022();

}  // namespace chebnet
