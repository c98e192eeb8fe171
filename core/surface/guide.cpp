#include "surface/guide.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "surface/height.h"

namespace chebnet {

namespace {

/// On the side of the normals.
struct HeightOver {
    double height;
    int face;
};

std::vector<HeightOver> heights_along_normals(const Surface& surface, const SurfaceTree& tree,
                                              const Positions& points) {
    std::vector<HeightOver> heights;
    heights.reserve(static_cast<std::size_t>(points.cols()));
    int face = 0;
    for (const auto& point : points.colwise()) {
        const Height height = height_of(surface, tree, point, face);
        face = height.at.face;
        heights.push_back({height.height, face});
    }
    return heights;
}

}  // namespace

Eigen::VectorXd heights_over(const Guide& guide, const Positions& points) {
    Eigen::VectorXd heights(points.cols());
    Eigen::Index i = 0;
    for (const auto& [height, face] : heights_along_normals(guide.surface(), guide.tree(), points))
        heights[i++] = guide.is_inside_out(face) ? -height : height;
    return heights;
}

GuideDistance distance_to(const Surface& surface, const SurfaceTree& tree, const Net& net, const Positions& positions) {
    Positions points(3, net.vertex_count() + net.edge_count());
    points.leftCols(net.vertex_count()) = positions;
    for (int e = 0; e < net.edge_count(); ++e)
        points.col(net.vertex_count() + e) = (positions.col(net.edges()(0, e)) + positions.col(net.edges()(1, e))) / 2;
    Eigen::ArrayXd distances(points.cols());
    Eigen::Index i = 0;
    for (const HeightOver& over : heights_along_normals(surface, tree, points)) distances[i++] = std::abs(over.height);
    return {distances.mean(), distances.maxCoeff()};
}

}  // namespace chebnet
