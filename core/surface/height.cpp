#include "surface/height.h"

#include <Eigen/Geometry>
#include <cmath>

namespace chebnet {

namespace {

/// The part of a triangle that is nearest: its interior, a side or a corner.
struct Feature {
    Eigen::Vector3d normal;
    bool is_boundary;
};

Feature feature_at(const Surface& surface, const SurfacePoint& at) {
    const Eigen::Vector3d face_normal = surface.face_normals().col(at.face);
    const int zeros = static_cast<int>((at.weights.array() == 0).count());
    if (zeros == 0) return {face_normal, false};
    int corner = 0;
    if (zeros == 2) {
        at.weights.maxCoeff(&corner);
        const int vertex = surface.triangles()(corner, at.face);
        return {surface.vertex_normals().col(vertex), surface.is_boundary(vertex)};
    }
    at.weights.minCoeff(&corner);
    const int other = surface.opposite(Surface::next(3 * at.face + corner));
    if (other < 0) return {face_normal, true};
    return {(face_normal + surface.face_normals().col(Surface::face_of(other))).normalized(), false};
}

}  // namespace

Height height_of(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& point, int guess) {
    const SurfaceTree::Nearest nearest = tree.nearest(point, guess);
    const auto [normal, is_boundary] = feature_at(surface, nearest.at);
    const Eigen::Vector3d away = point - nearest.position;
    const double along_normal = away.dot(normal);
    if (!is_boundary) return {std::copysign(nearest.distance, along_normal), 0, normal, nearest.at};
    return {along_normal, (away - along_normal * normal).norm(), normal, nearest.at};
}

}  // namespace chebnet
