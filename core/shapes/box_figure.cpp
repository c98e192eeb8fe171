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

std::vector<CellBox> cells_of(std::span<const Box> boxes, double cells_per_unit) {
    std::vector<CellBox> cells;
    for (const Box& box : boxes) cells.push_back(cells_of(box, cells_per_unit));
    return cells;
}

VoxelSolid union_of(std::span<const CellBox> boxes) {
    Eigen::Vector3i low = boxes[0].low, high = boxes[0].high;
    for (const CellBox& box : boxes) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    VoxelSolid solid(low, high);
    for (const CellBox& box : boxes) solid.fill(box.low, box.high);
    return solid;
}

/// The squares on the boundary of a union of boxes, counted without making them: on the uneven lattice of the planes in
/// which boxes begin and end, a face stands for as many squares as its sides are long.
double face_count(const std::vector<CellBox>& boxes) {
    std::vector<int> planes[3];
    for (int axis = 0; axis < 3; ++axis) {
        for (const CellBox& box : boxes) planes[axis].insert(planes[axis].end(), {box.low[axis], box.high[axis]});
        std::sort(planes[axis].begin(), planes[axis].end());
        planes[axis].erase(std::unique(planes[axis].begin(), planes[axis].end()), planes[axis].end());
    }
    const auto place = [&planes](const Eigen::Vector3i& point) {
        Eigen::Vector3i index;
        for (int axis = 0; axis < 3; ++axis)
            index[axis] = static_cast<int>(std::lower_bound(planes[axis].begin(), planes[axis].end(), point[axis]) -
                                           planes[axis].begin());
        return index;
    };
    std::vector<CellBox> places;
    for (const CellBox& box : boxes) places.push_back({place(box.low), place(box.high)});

    double count = 0;
    for_each_face(union_of(places), [&](const Eigen::Vector3i& cell, int axis, int) {
        const auto length = [&](int along) {
            return 1.0 * planes[along][cell[along] + 1] - planes[along][cell[along]];
        };
        count += length((axis + 1) % 3) * length((axis + 2) % 3);
    });
    return count;
}

/// Rounding makes the number of vertices jump, so scales around the one that the area alone suggests are tried.
double scale_for(std::span<const Box> boxes, double vertices) {
    constexpr double fine = 64, step = 1.01;
    const double area = face_count(cells_of(boxes, fine)) / (fine * fine);
    double best = 0, smallest_miss = std::numeric_limits<double>::infinity();
    for (int trial = -40; trial <= 40; ++trial) {
        const double scale = std::sqrt(vertices / area) * std::pow(step, trial);
        // A closed net of quads has as many vertices as faces, but for a few.
        const double miss = std::abs(face_count(cells_of(boxes, scale)) - vertices);
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
    Surface surface = boundary_surface(union_of(cells_of(boxes, scale)));
    std::vector<int> handle_vertices;
    for (const Eigen::Vector3d& point : handles)
        handle_vertices.push_back(nearest_vertex(surface.positions, scale * point));
    return {place_net(std::move(surface)), handle_vertices};
}

}  // namespace chebnet
