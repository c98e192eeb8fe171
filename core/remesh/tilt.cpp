#include "remesh/tilt.h"

#include <Eigen/Geometry>
#include <cmath>
#include <span>

namespace chebnet {

double mean_tilt(const Guide& guide, const Net& net) {
    const Positions& x = net.rest_positions();
    double sum = 0;
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> q = net.faces()[f];
        const Eigen::Vector3d normal = (x.col(q[2]) - x.col(q[0])).cross(x.col(q[3]) - x.col(q[1]));
        const Eigen::Vector3d centre = (x.col(q[0]) + x.col(q[1]) + x.col(q[2]) + x.col(q[3])) / 4;
        const Eigen::Vector3d beneath = guide.surface().face_normals().col(guide.tree().nearest(centre).at.face);
        sum += std::atan2(normal.cross(beneath).norm(), normal.dot(beneath));
    }
    return net.face_count() > 0 ? sum / net.face_count() : 0;
}

}  // namespace chebnet
