#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_dome_parameters[] = {
    vertices_parameter(2000),
    {"reach", 55, 10, 70, "How far the two main arches reach down from the top, in degrees."},
};

/// One step of the compass method (Frei Otto et al., IL 10 Grid Shells, 1974): the point of the sphere about the origin
/// at distance 1 from both `a` and `b` on it, on the side to which a − b turns when seen from outside.
///
/// With the midpoint m it is m + e, where e ⟂ a − b, |e|² = 1 − |a − b|²/4 and, because it is as far out as `a` and
/// `b`, m·e = |a − b|²/4 − 1/2. Reckoned like this from m, not from the centre, no large numbers cancel: edges come out
/// equal to the last digits on the finest net as well.
Eigen::Vector3d compass(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d middle = (a + b) / 2;
    const double half_diagonal_squared = (a - b).squaredNorm() / 4;
    const double inward = (0.5 - half_diagonal_squared) / middle.norm();
    const double sideways = std::sqrt(1 - half_diagonal_squared - inward * inward);
    return middle - inward * middle.normalized() + sideways * middle.cross(a - b).normalized();
}

/// The quarter of the dome between the main arches, which leave the crown towards x and y: vertex (column, row) counted
/// from the crown.
Positions quarter(GridSize size, double reach) {
    const double step = reach / (std::max(size.columns, size.rows) - 1);
    const double radius = 0.5 / std::sin(step / 2);
    Positions positions(3, size.columns * size.rows);
    const auto at = [&](int column, int row) { return positions.col(row * size.columns + column); };
    for (int column = 0; column < size.columns; ++column)
        at(column, 0) << radius * std::sin(step * column), 0, radius * std::cos(step * column);
    for (int row = 1; row < size.rows; ++row) {
        at(0, row) << 0, radius * std::sin(step * row), radius * std::cos(step * row);
        for (int column = 1; column < size.columns; ++column)
            at(column, row) = compass(at(column, row - 1), at(column - 1, row));
    }
    return positions;
}

int nearest_odd(double count) { return 2 * static_cast<int>(std::lround((count - 1) / 2)) + 1; }

Shape make_dome(const Values& values) {
    const int rows = nearest_odd(std::sqrt(values["vertices"]));
    const int columns = nearest_odd(values["vertices"] / rows);
    const GridSize half{columns / 2 + 1, rows / 2 + 1};
    const Positions first_quarter = quarter(half, values["reach"] * std::numbers::pi / 180);

    const auto vertex = [columns](int column, int row) { return row * columns + column; };
    Positions positions(3, columns * rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int x = column - columns / 2, y = row - rows / 2;
            const Eigen::Vector3d mirror(x < 0 ? -1 : 1, y < 0 ? -1 : 1, 1);
            positions.col(vertex(column, row)) =
                mirror.cwiseProduct(first_quarter.col(std::abs(y) * half.columns + std::abs(x)));
        }

    const int right = columns - 1, back = rows - 1;
    return {place_net({std::move(positions), grid_faces({columns, rows})}),
            {vertex(0, 0), vertex(right, 0), vertex(0, back), vertex(right, back), vertex(columns / 2, rows / 2)}};
}

}  // namespace

constinit const Family k_dome = {
    {"dome", "Dome", "A part of a sphere, netted with a compass from two arches that cross at the top.",
     k_dome_parameters},
    make_dome};

}  // namespace chebnet
