#include <cmath>
#include <numbers>

#include "base/in_this_build.h"
#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_vase_parameters[] = {
    vertices_parameter(2000),
    {"aspect", 1.4, 1.1, 2.5, "Height divided by width, about."},
    {"waist", 0.5, 0.45, 1, "Width of the neck divided by that of the belly."},
};

// Where up the vase it is widest and where it is narrowest, in parts of its rows.
constexpr double k_belly = 0.36, k_neck = 0.84;
// Half the width of a quad at the belly, in edge lengths.
constexpr double k_half_width = 0.82;

/// Radius at a part of the rows, relative to that of the belly.
double width_at(double part, double waist) {
    return (1 + waist + (1 - waist) * std::cos(std::numbers::pi * (part - k_belly) / (k_neck - k_belly))) / 2;
}

/// Rings of vertices, each turned by half a step against that below, as high above it as edges of length 1 allow.
Positions rings(GridSize size, double waist) {
    const double step = 2 * std::numbers::pi / size.columns;
    const double belly = k_half_width / (2 * std::sin(step / 4));
    const auto radius = [&](int row) { return belly * width_at(double(row) / (size.rows - 1), waist); };
    Positions positions(3, size.columns * size.rows);
    double height = 0;
    for (int row = 0; row < size.rows; ++row) {
        if (row > 0) {
            const double before = radius(row - 1), here = radius(row), turn = std::sin(step / 4);
            height += std::sqrt(1 - (here - before) * (here - before) - 4 * before * here * turn * turn);
        }
        for (int column = 0; column < size.columns; ++column) {
            const double angle = step * (column + row % 2 / 2.0);
            positions.col(row * size.columns + column) << radius(row) * std::cos(angle), radius(row) * std::sin(angle),
                height;
        }
    }
    return positions;
}

/// A quad stands on each vertex, between its neighbours to the right and left in the row above.
Faces standing_quads(GridSize size) {
    const auto vertex = [size](int column, int row) {
        return row * size.columns + (column + size.columns) % size.columns;
    };
    Faces faces;
    for (int row = 0; row + 2 < size.rows; ++row)
        for (int column = 0; column < size.columns; ++column) {
            const int right = column + row % 2;
            faces.add(
                {vertex(column, row), vertex(right, row + 1), vertex(column, row + 2), vertex(right - 1, row + 1)});
        }
    return faces;
}

Shape make_vase(const Values& values) {
    // Rows are about this much closer than columns.
    const GridSize size = grid_size(values["vertices"], values["aspect"] / 1.5);
    const auto foot = [size](int third) { return third * size.columns / 3; };
    return {place_net({rings(size, values["waist"]), standing_quads(size)}),
            {foot(0), foot(1), foot(2), (size.rows - 1) * size.columns}};
}

}  // namespace

constinit const Family k_vase = {{"vase", "Vase", "A vase of wires that wind up both ways.", k_vase_parameters},
                                 in_this_build(make_vase)};

}  // namespace chebnet
