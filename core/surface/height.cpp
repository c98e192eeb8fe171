#include "surface/height.h"

#include <Eigen/Geometry>
#include <cmath>

namespace chebnet {

namespace {

/// The part of a triangle that is nearest: its interior, a side or a corner.
struct Feature {
    Eigen::Vector3d normal;
    bool is_boundary;
    int dimension;          // 2: a triangle's interior, 1: a side, 0: a corner
    Eigen::Vector3d along;  // of a side
};

Feature feature_at(const Surface& surface, const SurfacePoint& at) {
    const Eigen::Vector3d face_normal = surface.face_normals().col(at.face);
    const int zeros = static_cast<int>((at.weights.array() == 0).count());
    if (zeros == 0) return {face_normal, false, 2, {}};
    int corner = 0;
    if (zeros == 2) {
        at.weights.maxCoeff(&corner);
        const int vertex = surface.triangles()(corner, at.face);
        return {surface.vertex_normals().col(vertex), surface.is_boundary(vertex), 0, {}};
    }
    at.weights.minCoeff(&corner);
    const int side = Surface::next(3 * at.face + corner), other = surface.opposite(side);
    const Eigen::Vector3d along =
        (surface.positions().col(surface.to(side)) - surface.positions().col(surface.from(side))).normalized();
    if (other < 0) return {face_normal, true, 1, along};
    return {(face_normal + surface.face_normals().col(Surface::face_of(other))).normalized(), false, 1, along};
}

}  // namespace

Height height_of(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& point, int guess) {
    return height_at(surface, tree.nearest(point, guess), point);
}

Height height_at(const Surface& surface, const SurfaceTree::Nearest& nearest, const Eigen::Vector3d& point) {
    const auto [normal, is_boundary, dimension, along] = feature_at(surface, nearest.at);
    const Eigen::Vector3d away = point - nearest.position;
    const double along_normal = away.dot(normal);
    if (!is_boundary) return {std::copysign(nearest.distance, along_normal), 0, normal, nearest.at};
    return {along_normal, (away - along_normal * normal).norm(), normal, nearest.at};
}

Offset offset_of(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& point, int guess) {
    const SurfaceTree::Nearest nearest = tree.nearest(point, guess);
    const Feature feature = feature_at(surface, nearest.at);
    const Eigen::Vector3d away = point - nearest.position;
    const double along_normal = away.dot(feature.normal);
    const Eigen::Matrix3d onto_normal = feature.normal * feature.normal.transpose();
    Offset offset{away, onto_normal, along_normal, nearest.at.face};
    if (feature.is_boundary)
        offset.away = along_normal * feature.normal;
    else if (feature.dimension == 1)
        offset.change = Eigen::Matrix3d::Identity() - feature.along * feature.along.transpose();
    else if (feature.dimension == 0)
        offset.change.setIdentity();
    return offset;
}

}  // namespace chebnet
