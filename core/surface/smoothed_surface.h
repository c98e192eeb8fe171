#pragma once

#include <functional>
#include <memory>

#include "surface/guide.h"
#include "surface/surface.h"

namespace chebnet {

/// The surface, with the same triangles, without what is much smaller than `radius` (> 0), such as the noise of a scan:
/// its positions after an implicit step S of heat (see HeatStep), and what that takes away after another, 2 S − S². So
/// a shape of size R shrinks by no more than about (radius/R)⁴. The boundary stays. `go_on` is called now and
/// then, and may end it by an exception: a million triangles take seconds. Throws Error as Surface does, where
/// triangles vanish.
Surface smoothed(
    const Surface& surface, double radius, const std::function<void()>& go_on = [] {});

/// Whether a surface is rough as a noisy scan is: triangles are inclined to their neighbours by more than 10° at most
/// of its edges, and what curvature that makes cancels within an edge. Few triangles, folds and bumps do not make it
/// so.
bool is_rough(const Surface& surface);

/// What a net with edges of a `length` (> 0) is to lie on: the surface itself or, where that is_rough(), the surface
/// smoothed over that length, or farther until this tilts it by no more than 7°; not if its triangles' sides are longer
/// than two edges. Noise that narrow has a curvature, but none that edges of a net could follow: corners add it up
/// along net lines until they lock.
std::shared_ptr<const Guide> without_roughness(const std::shared_ptr<const Guide>& guide, double length);

/// By how much the triangles of a surface are inclined to those of another with the same triangles, on the average of
/// the former's area; radians.
double mean_tilt(const Surface& surface, const Surface& other);

/// How far the vertices of a surface are from those of another with the same triangles, on the average of its area.
double mean_move(const Surface& surface, const Surface& other);

}  // namespace chebnet
