#pragma once

#include <memory>

#include "remesh/remesh.h"
#include "surface/guide.h"

namespace chebnet {

/// As remesh_one_way() does, by the way that fits best: the ways to end at the border (RemeshOptions::Border::fitting),
/// the net that grows from one place over all of a disc, and if `tries_creases` nets that follow sharp edges, too, are
/// tried with fewer cells one after the other until one is good; and the best is made as it is asked for, or the next,
/// where that leads to no net. Throws as it does, where no way leads to one.
Remesh remesh_best_way(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options, bool tries_creases,
                       const RemeshProgress& progress);

}  // namespace chebnet
