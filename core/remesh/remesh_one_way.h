#pragma once

#include <memory>

#include "remesh/remesh.h"
#include "surface/guide.h"

namespace chebnet {

/// As remesh() does for checked options, by one way to end at the border, which is not `fitting`, or on a surface
/// without any; as fitting has left it: faces are in any order, and RemeshPhase::border takes no time. Throws as it.
Remesh remesh_one_way(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                      const RemeshProgress& progress);

}  // namespace chebnet
