#pragma once

#include <memory>

#include "solve/method.h"

namespace chebnet {

/// Composite majorization (Shtengel et al. 2017) on the paper's energy, with the paper's stages. See StagedDescent.
std::unique_ptr<Method> make_composite_majorization();

}  // namespace chebnet
