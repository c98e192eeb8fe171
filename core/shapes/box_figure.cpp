#include "shapes/box_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "shapes/family.h"
#include "shapes/voxel_solid.h"

namespace chebnet {

namespace {

struct CellBox {
    Eigen::Vector3i low, high;
};

/// Rounds outwards from the origin where a box would vanish, so that figures symmetric about it stay so.
CellBox cells_of(const Box& box, double cells_per_unit) {
    CellBox cells;
    for (int axis = 0; axis < 3; ++axis) {
        int& low = cells.low[axis] = static_cast<int>(std::lround(box.low[axis] * cells_per_unit));
        int& high = cells.high[axis] = static_cast<int>(std::lround(box.high[axis] * cells_per_unit));
        if (low < high) continue;
        const double middle = box.low[axis] + box.high[axis];
        low -= middle <= 0;
        high += middle >= 0;
    }
    return cells;
}

VoxelSolid voxelised(std::span<const Box> boxes, double cells_per_unit) {
    std::vector<CellBox> cells;
    for (const Box& box : boxes) cells.push_back(cells_of(box, cells_per_unit));
    Eigen::Vector3i low = cells[0].low, high = cells[0].high;
    for (const CellBox& box : cells) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    VoxelSolid solid(low, high);
    for (const CellBox& box : cells) solid.fill(box.low, box.high);
    return solid;
}

/// Rounding makes the number of vertices jump, so the scales about the one that area alone suggests are all tried.
double scale_for(std::span<const Box> boxes, double vertices) {
    constexpr double fine = 8, step = 1.02, good_enough = 0.01;
    const double area = boundary_face_count(voxelised(boxes, fine)) / (fine * fine);
    const double expected = std::sqrt(vertices / area);
    double best = expected, smallest_miss = std::numeric_limits<double>::infinity();
    for (int trial = 0; trial <= 40 && smallest_miss > good_enough; ++trial) {
        const double scale = expected * std::pow(step, trial % 2 ? (trial + 1) / 2 : -trial / 2);
        // A closed net of quads has as many vertices as faces, but for a few.
        const double miss = std::abs(boundary_face_count(voxelised(boxes, scale)) / vertices - 1);
        if (miss < smallest_miss) {
            smallest_miss = miss;
            best = scale;
        }
    }
    return best;
}

int nearest_vertex(const Positions& positions, const Eigen::Vector3d& point) {
    int nearest;
    (positions.colwise() - point).colwise().squaredNorm().minCoeff(&nearest);
    return nearest;
}

}  // namespace

Shape make_box_figure(std::span<const Box> boxes, double vertices, std::span<const Eigen::Vector3d> handles) {
    const double scale = scale_for(boxes, vertices);
    Surface surface = boundary_surface(voxelised(boxes, scale));
    std::vector<int> handle_vertices;
    for (const Eigen::Vector3d& point : handles)
        handle_vertices.push_back(nearest_vertex(surface.positions, scale * point));
    return {place_net(std::move(surface)), handle_vertices};
}

}  // namespace chebnet
