#include "drape/sample_points.h"

#include <algorithm>
#include <cmath>

#include "surface/middles.h"

namespace chebnet {

namespace {

/// Into how many parts the sides of a triangle are cut: for n² pieces.
int parts_of_side(const Surface& surface, int face) {
    if (surface.face_count() >= k_samples || !(surface.area() > 0)) return 1;
    const double pieces = k_samples * surface.areas()[face] / surface.area();
    return std::max(1, static_cast<int>(std::sqrt(pieces)));
}

}  // namespace

std::vector<SamplePoint> sample_points(const Surface& surface, int stride) {
    std::vector<SamplePoint> points;
    for (int f = 0; f < surface.face_count(); f += stride) {
        const int n = parts_of_side(surface, f);
        if (n == 1) {
            points.push_back({{f, Eigen::Vector3d::Constant(1. / 3)}, surface.areas()[f]});
            continue;
        }
        for_each_middle(n, [&](const Eigen::Vector3d& weights) {
            points.push_back({{f, weights}, surface.areas()[f] / (n * n)});
        });
    }
    return points;
}

}  // namespace chebnet
