#pragma once

#include <memory>

#include "solve/method.h"

namespace chebnet {

/// Gauss–Newton on the edges as springs, Σ (r − 1)², with a small Laplacian in the metric (see SpringEnergy) and Armijo
/// backtracking. Each iteration factors a system as large as the paper's; few are needed. See StagedDescent; the
/// exponents have no meaning here.
std::unique_ptr<Method> make_gauss_newton();

}  // namespace chebnet
