#pragma once

#include <memory>
#include <optional>

#include "remesh/remesh.h"
#include "surface/guide.h"

namespace chebnet {

/// As remesh() does for checked options, by one way to end at the border, which is not `fitting`, or on a surface
/// without any; as fitting has left it: faces are in any order, and RemeshPhase::border takes no time. Throws as it.
Remesh remesh_one_way(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                      const RemeshProgress& progress);

/// The same, but nothing as soon as edges of meshes on the surface err by more than `most_error` (evened_error()): as
/// far as that from one length they promise no net worth the time of its fit. Throws as remesh_one_way() does where
/// none is found for another reason.
std::optional<Remesh> remesh_if_even(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                                     double most_error, const RemeshProgress& progress);

}  // namespace chebnet
