#include "shapes/placement.h"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace chebnet {

namespace {

CellBox rounded(const Box& box, const Placement& placement) {
    const auto nearest = [&](double x) {
        return static_cast<int>(std::lround(x * placement.cells_per_unit + placement.offset));
    };
    return {box.low.unaryExpr(nearest), box.high.unaryExpr(nearest)};
}

CellBox cells_of(const Box& box, const Placement& placement) {
    CellBox cells = rounded(box, placement);
    for (int axis = 0; axis < 3; ++axis) {
        if (cells.low[axis] < cells.high[axis]) continue;
        const double middle = box.low[axis] + box.high[axis];
        cells.low[axis] -= middle <= 0;
        cells.high[axis] += middle >= 0;
    }
    return cells;
}

double power(double base, int exponent) {
    double result = 1;
    for (int k = 0; k < std::abs(exponent); ++k) result *= base;
    return exponent < 0 ? 1 / result : result;
}

double vertex_count(std::span<const Box> boxes, std::span<const Box> openings, const Placement& placement) {
    return BlockLattice(cells_of(boxes, placement), openings_of(openings, placement)).vertex_count();
}

/// The first of equally near ones; the sum in this order, so that it is the same one everywhere.
int nearest_vertex(const Positions& positions, const Eigen::Vector3d& point) {
    int nearest = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (int v = 0; v < positions.cols(); ++v) {
        const Eigen::Vector3d d = positions.col(v) - point;
        const double distance = d.x() * d.x() + d.y() * d.y() + d.z() * d.z();
        if (distance >= shortest) continue;
        shortest = distance;
        nearest = v;
    }
    return nearest;
}

}  // namespace

std::vector<CellBox> cells_of(std::span<const Box> boxes, const Placement& placement) {
    std::vector<CellBox> cells;
    for (const Box& box : boxes) cells.push_back(cells_of(box, placement));
    return cells;
}

std::vector<CellBox> openings_of(std::span<const Box> openings, const Placement& placement) {
    std::vector<CellBox> cells;
    for (const Box& box : openings) cells.push_back(rounded(box, placement));
    return cells;
}

/// Rounding makes the number of vertices jump, so placements around the scale that the area alone suggests are tried.
Placement place_for(std::span<const Box> boxes, std::span<const Box> openings, double vertices) {
    constexpr double fine = 64, step = 1.01;
    const double area = vertex_count(boxes, openings, {fine, 0}) / (fine * fine);
    Placement best{};
    double smallest_miss = std::numeric_limits<double>::infinity();
    for (const double offset : {0.0, 0.5})
        for (int trial = -40; trial <= 40; ++trial) {
            const Placement placement{std::sqrt(vertices / area) * power(step, trial), offset};
            const double miss = std::abs(vertex_count(boxes, openings, placement) - vertices);
            if (miss >= smallest_miss) continue;
            smallest_miss = miss;
            best = placement;
        }
    return best;
}

std::vector<int> nearest_vertices(const Positions& lattice_points, std::span<const Eigen::Vector3d> points,
                                  const Placement& placement) {
    std::vector<int> vertices;
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d placed = (point * placement.cells_per_unit).array() + placement.offset;
        vertices.push_back(nearest_vertex(lattice_points, placed));
    }
    return vertices;
}

}  // namespace chebnet
