#include "surface/guide.h"

#include <algorithm>
#include <cmath>

#include "surface/height.h"

namespace chebnet {

Eigen::VectorXd heights_over(const Surface& surface, const SurfaceTree& tree, const Positions& points) {
    Eigen::VectorXd heights(points.cols());
    int face = 0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Height height = height_of(surface, tree, points.col(i), face);
        heights[i] = height.height;
        face = height.at.face;
    }
    return heights;
}

GuideDistance distance_to(const Surface& surface, const SurfaceTree& tree, const Net& net, const Positions& positions) {
    Positions points(3, net.vertex_count() + net.edge_count());
    points.leftCols(net.vertex_count()) = positions;
    for (int e = 0; e < net.edge_count(); ++e)
        points.col(net.vertex_count() + e) = (positions.col(net.edges()(0, e)) + positions.col(net.edges()(1, e))) / 2;
    const Eigen::ArrayXd distances = heights_over(surface, tree, points).array().abs();
    return {distances.mean(), distances.maxCoeff()};
}

}  // namespace chebnet
