#pragma once

#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// A point of a surface, and the part of its area that it stands for.
struct SamplePoint {
    SurfacePoint at;
    double area = 0;
};

/// Points all over a surface: the middles of every `stride`-th triangle. Where these are few, as on a panel of two or a
/// vault of long strips, so that the middles would say little, triangles are cut into equal pieces with a middle each,
/// until there are about k_samples; triangles with less than four times their share of the area stay whole.
std::vector<SamplePoint> sample_points(const Surface& surface, int stride);

inline constexpr int k_samples = 2000;

}  // namespace chebnet
