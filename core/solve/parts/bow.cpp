#include "solve/parts/bow.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "linear/ordered_dot.h"

namespace chebnet {

namespace {

// In edge lengths: a net that rises by no more than this is flat.
constexpr double k_flat = 0.02;
// Moves whose share across the plane is less than this lead to neither side.
constexpr double k_led = 1e-6;

}  // namespace

std::optional<Eigen::Vector3d> normal_of_flat(const Net& net, const Positions& positions, int up) {
    // By the sum of the faces' areas as vectors.
    const Eigen::Vector3d origin = positions.col(0);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (int f = 0; f < net.face_count(); ++f) {
        const auto face = net.faces()[f];
        for (std::size_t k = 0; k < face.size(); ++k)
            normal += (positions.col(face[k]) - origin).cross(positions.col(face[(k + 1) % face.size()]) - origin);
    }
    if (!(normal.norm() > 0)) return std::nullopt;
    normal.normalize();
    double low = 0, high = 0;
    for (int v = 0; v < net.vertex_count(); ++v) {
        const double height = normal.dot(positions.col(v) - origin);
        low = std::min(low, height);
        high = std::max(high, height);
    }
    if (!(high - low <= k_flat * net.mean_length())) return std::nullopt;
    // Above the ground is up; of what stands upright, the side of y or z, and of what has no such side, that of x.
    Eigen::Vector3d side(1e-6, 1e-3, 1e-3);
    side[up] = 1;
    if (normal.dot(side) < 0) normal = -normal;
    return normal;
}

double part_of_bow(const Net& net, const Positions& positions, const Eigen::Matrix3Xd& moves,
                   const Eigen::Matrix3Xd& bow, bool rises) {
    double lost = 0, wanted = 0, made_up = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const int a = net.edges()(0, e), b = net.edges()(1, e);
        const Eigen::Vector3d before = positions.col(a) - positions.col(b), move = moves.col(a) - moves.col(b);
        const double taken = -move.dot(2 * before + move), step = (bow.col(a) - bow.col(b)).squaredNorm();
        lost += taken;
        wanted += taken * step;
        made_up += step * step;
    }
    if (!(lost > 0 && wanted > 0 && made_up > 0)) return 0;
    const double led = ordered_dot(moves, bow);
    const bool is_led = led * led > k_led * k_led * ordered_dot(moves, moves) * ordered_dot(bow, bow);
    return ((is_led ? led < 0 : rises) ? -1 : 1) * std::sqrt(wanted / made_up);
}

}  // namespace chebnet
