#include "shapes/box_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

/// How a figure is laid into the lattice of cells: its origin at a lattice point (offset 0) or in the middle of a cell
/// (offset 1/2). What is symmetric about the origin is an even number of cells wide on the one and odd on the other.
struct Placement {
    double cells_per_unit, offset;
};

/// A box that rounding would make vanish is thickened away from the origin, so that symmetric figures stay symmetric.
CellBox cells_of(const Box& box, const Placement& placement) {
    const auto rounded = [&](double x) {
        return static_cast<int>(std::lround(x * placement.cells_per_unit + placement.offset));
    };
    CellBox cells{box.low.unaryExpr(rounded), box.high.unaryExpr(rounded)};
    for (int axis = 0; axis < 3; ++axis) {
        if (cells.low[axis] < cells.high[axis]) continue;
        const double middle = box.low[axis] + box.high[axis];
        cells.low[axis] -= middle <= 0;
        cells.high[axis] += middle >= 0;
    }
    return cells;
}

std::vector<CellBox> cells_of(std::span<const Box> boxes, const Placement& placement) {
    std::vector<CellBox> cells;
    for (const Box& box : boxes) cells.push_back(cells_of(box, placement));
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

double power(double base, int exponent) {
    double result = 1;
    for (int k = 0; k < std::abs(exponent); ++k) result *= base;
    return exponent < 0 ? 1 / result : result;
}

/// Rounding makes the number of vertices jump, so placements around the scale that the area alone suggests are tried.
Placement place_for(std::span<const Box> boxes, double vertices) {
    constexpr double fine = 64, step = 1.01;
    const double area = face_count(cells_of(boxes, {fine, 0})) / (fine * fine);
    Placement best{};
    double smallest_miss = std::numeric_limits<double>::infinity();
    for (const double offset : {0.0, 0.5})
        for (int trial = -40; trial <= 40; ++trial) {
            const Placement placement{std::sqrt(vertices / area) * power(step, trial), offset};
            // A closed net of quads has as many vertices as faces, but for a few.
            const double miss = std::abs(face_count(cells_of(boxes, placement)) - vertices);
            if (miss >= smallest_miss) continue;
            smallest_miss = miss;
            best = placement;
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
    const Placement placement = place_for(boxes, vertices);
    Surface surface = boundary_surface(union_of(cells_of(boxes, placement)));
    std::vector<int> handle_vertices;
    for (const Eigen::Vector3d& point : handles) {
        const Eigen::Vector3d placed = (point * placement.cells_per_unit).array() + placement.offset;
        handle_vertices.push_back(nearest_vertex(surface.positions, placed));
    }
    return {place_net(std::move(surface)), handle_vertices};
}

}  // namespace chebnet
