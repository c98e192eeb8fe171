#pragma once

#include <memory>

#include "solve/method.h"

namespace chebnet {

/// D_p, the sum of |r − 1|^p (Li et al. 2022, eq. 12) with the majorizer of the split (13), in the paper's stages:
/// exponent p_start first, then 4 or 8 in place of p_end. See StagedDescent.
std::unique_ptr<Method> make_dp4();
std::unique_ptr<Method> make_dp8();

}  // namespace chebnet
