#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace chebnet {

struct Segment {
    Eigen::Vector3d from, to;
};

/// Of a point from a segment, whose ends may be one point.
inline double squared_distance(const Eigen::Vector3d& point, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d along = to - from, away = point - from;
    const double square = along.squaredNorm();
    const double part = square > 0 ? std::clamp(away.dot(along) / square, 0.0, 1.0) : 0;
    return (away - part * along).squaredNorm();
}

}  // namespace chebnet
