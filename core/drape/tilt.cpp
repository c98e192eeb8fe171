#include "drape/tilt.h"

#include <Eigen/Geometry>
#include <cmath>
#include <span>
#include <vector>

#include "net/corner_edges.h"
#include "net/measures.h"
#include "net/topology.h"

namespace chebnet {

namespace {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// 3×F, of any length.
Eigen::Matrix3Xd normals_of_cells(const Net& net) {
    const Positions& x = net.rest_positions();
    Eigen::Matrix3Xd normals(3, net.face_count());
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> q = net.faces()[f];
        const Eigen::Vector3d one = x.col(q[2]) - x.col(q[0]), other = x.col(q[3]) - x.col(q[1]);
        normals.col(f) = one.cross(other);
    }
    return normals;
}

/// 3×F, of the surface where it is nearest to the cells' centres.
Eigen::Matrix3Xd normals_beneath(const Guide& guide, const Net& net) {
    const Positions& x = net.rest_positions();
    Eigen::Matrix3Xd normals(3, net.face_count());
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> q = net.faces()[f];
        const Eigen::Vector3d centre = (x.col(q[0]) + x.col(q[1]) + x.col(q[2]) + x.col(q[3])) / 4;
        normals.col(f) = guide.surface().face_normals().col(guide.tree().nearest(centre).at.face);
    }
    return normals;
}

}  // namespace

double mean_tilt(const Guide& guide, const Net& net) {
    const Eigen::Matrix3Xd normals = normals_of_cells(net), beneath = normals_beneath(guide, net);
    double sum = 0;
    for (int f = 0; f < net.face_count(); ++f) sum += angle_between(normals.col(f), beneath.col(f));
    return net.face_count() > 0 ? sum / net.face_count() : 0;
}

int crumpled_edges(const Guide& guide, const Net& net) {
    const std::vector<int> edges = corner_edges(net, Topology(net));
    const Eigen::Matrix3Xd normals = normals_of_cells(net), beneath = normals_beneath(guide, net);
    std::vector<int> first(static_cast<std::size_t>(net.edge_count()), -1);
    int count = 0;
    for (int f = 0; f < net.face_count(); ++f)
        for (int k = 0; k < 4; ++k) {
            int& other = first[edges[net.faces().start[f] + k]];
            if (other >= 0 &&
                angle_between(normals.col(f), normals.col(other)) - angle_between(beneath.col(f), beneath.col(other)) >
                    k_fold)
                ++count;
            other = f;
        }
    return count;
}

}  // namespace chebnet
