#include "surface/surface_point.h"

namespace chebnet {

namespace {

constexpr double k_snap_to_corner = 1e-3;

}  // namespace

int corner_of(const Surface& surface, int face, int vertex) {
    for (int k = 0; k < 3; ++k)
        if (surface.triangles()(k, face) == vertex) return k;
    return -1;
}

SurfacePoint snapped(const SurfacePoint& point) {
    SurfacePoint near = point;
    for (double& weight : near.weights)
        if (weight < k_snap_to_corner) weight = 0;
    near.weights /= near.weights.sum();
    return near;
}

std::optional<Eigen::Vector3d> weights_in(const Surface& surface, const SurfacePoint& point, int face) {
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        if (point.weights[k] == 0) continue;
        const int corner = corner_of(surface, face, surface.triangles()(k, point.face));
        if (corner < 0) return std::nullopt;
        weights[corner] = point.weights[k];
    }
    return weights;
}

}  // namespace chebnet
