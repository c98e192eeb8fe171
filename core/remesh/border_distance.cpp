#include "remesh/border_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "surface/segment.h"

namespace chebnet {

namespace {

std::vector<int> border_edges(const Net& net) {
    std::vector<int> edges;
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 1) edges.push_back(e);
    return edges;
}

}  // namespace

double border_distance(const Surface& surface, const Net& net) {
    const Positions &x = surface.positions(), &y = net.rest_positions();
    const std::vector<int> edges = border_edges(net);
    double sum = 0, length = 0;
    for (int s = 0; s < 3 * surface.face_count() && !edges.empty(); ++s) {
        if (surface.opposite(s) >= 0) continue;
        const Eigen::Vector3d from = x.col(surface.from(s)), to = x.col(surface.to(s)), middle = (from + to) / 2;
        double least = std::numeric_limits<double>::infinity();
        for (const int e : edges)
            least = std::min(least, squared_distance(middle, y.col(net.edges()(0, e)), y.col(net.edges()(1, e))));
        sum += (to - from).norm() * std::sqrt(least);
        length += (to - from).norm();
    }
    return length > 0 ? sum / length : 0;
}

}  // namespace chebnet
