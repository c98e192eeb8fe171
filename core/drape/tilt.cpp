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

/// 3×F, of any length. Of the triangles at a cell's first corner, two at a time: of a quad, by its diagonals.
Eigen::Matrix3Xd normals_of_cells(const Net& net) {
    const Positions& x = net.rest_positions();
    Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, net.face_count());
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> cell = net.faces()[f];
        for (std::size_t k = 1; k + 1 < cell.size(); k += 2) {
            const Eigen::Vector3d one = x.col(cell[k + 1]) - x.col(cell[0]),
                                  other = x.col(cell[(k + 2) % cell.size()]) - x.col(cell[k]);
            normals.col(f) += one.cross(other);
        }
    }
    return normals;
}

Eigen::Vector3d centre_of(const Positions& x, std::span<const int> cell) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int v : cell) sum += x.col(v);
    return sum / static_cast<double>(cell.size());
}

/// 3×F, of the surface where it is nearest to the cells' centres.
Eigen::Matrix3Xd normals_beneath(const Guide& guide, const Net& net) {
    Eigen::Matrix3Xd normals(3, net.face_count());
    for (int f = 0; f < net.face_count(); ++f) {
        const Eigen::Vector3d centre = centre_of(net.rest_positions(), net.faces()[f]);
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
        for (int k = net.faces().start[f]; k < net.faces().start[f + 1]; ++k) {
            int& other = first[edges[k]];
            if (other >= 0 &&
                angle_between(normals.col(f), normals.col(other)) - angle_between(beneath.col(f), beneath.col(other)) >
                    k_fold)
                ++count;
            other = f;
        }
    return count;
}

}  // namespace chebnet
