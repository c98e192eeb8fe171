#pragma once

#include <functional>

#include "surface/surface.h"

namespace chebnet {

/// The surface, with the same triangles, without what is much smaller than `radius` (> 0), such as the noise of a scan:
/// its positions after an implicit step S of heat (see HeatStep), and what that takes away after another, 2 S − S². So
/// a shape of size R shrinks by no more than about (radius/R)⁴. The boundary stays. `go_on` is called now and
/// then, and may end it by an exception: a million triangles take seconds. Throws Error as Surface does, where
/// triangles vanish.
Surface smoothed(
    const Surface& surface, double radius, const std::function<void()>& go_on = [] {});

/// By how much the triangles of a surface are inclined to those of another with the same triangles, on the average of
/// the former's area; radians.
double mean_tilt(const Surface& surface, const Surface& other);

}  // namespace chebnet
