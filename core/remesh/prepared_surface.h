#pragma once

#include <functional>
#include <memory>

#include "remesh/remesh.h"
#include "surface/guide.h"
#include "surface/surface.h"

namespace chebnet {

/// About so many are asked for, by their number or by a length.
double cells_asked_for(const Surface& surface, const RemeshOptions& options);

bool has_border(const Surface& surface);

/// The surface with holes closed that are smaller than a cell, which are none for a net; itself if it has none.
std::shared_ptr<const Guide> without_small_holes(const std::shared_ptr<const Guide>& guide,
                                                 const RemeshOptions& options);

/// A net cannot follow what is smaller than its cells, and crumples where it is held near that: a rough surface is
/// smoothed over a cell, or farther, until that tilts it no more, or melts its shape. Any other is given back as it is,
/// and so is one with creases that are to be followed. `go_on` is called meanwhile; whoever wants an end throws.
std::shared_ptr<const Guide> without_noise(const std::shared_ptr<const Guide>& guide, const RemeshOptions& options,
                                           const std::function<void()>& go_on);

}  // namespace chebnet
