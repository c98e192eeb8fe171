#include "remesh/border_distance.h"

#include <cmath>
#include <utility>
#include <vector>

#include "surface/segment_tree.h"

namespace chebnet {

namespace {

SegmentTree border_of(const Net& net) {
    std::vector<Segment> border;
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 1)
            border.push_back(
                {net.rest_positions().col(net.edges()(0, e)), net.rest_positions().col(net.edges()(1, e))});
    return SegmentTree(std::move(border));
}

}  // namespace

double border_distance(const Surface& surface, const Net& net) {
    const SegmentTree border = border_of(net);
    if (border.empty()) return 0;
    const Positions& x = surface.positions();
    double sum = 0, length = 0;
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        if (surface.opposite(s) >= 0) continue;
        const Eigen::Vector3d from = x.col(surface.from(s)), to = x.col(surface.to(s)), middle = (from + to) / 2;
        sum += (to - from).norm() * std::sqrt(border.nearest(middle).squared_distance);
        length += (to - from).norm();
    }
    return length > 0 ? sum / length : 0;
}

}  // namespace chebnet
