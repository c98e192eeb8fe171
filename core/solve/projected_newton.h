#pragma once

#include <memory>

#include "solve/method.h"

namespace chebnet {

/// Newton's method on the paper's energy, each edge's Hessian projected to be positive semi-definite, with the paper's
/// stages. See StagedDescent.
std::unique_ptr<Method> make_projected_newton();

}  // namespace chebnet
