#include "shapes/grid.h"

#include <cmath>
#include <numbers>

namespace chebnet {

GridSize grid_size(double vertices, double aspect) {
    const auto rounded = [](double count) { return static_cast<int>(std::lround(count)); };
    // The shorter direction first: the longer one makes up for its rounding.
    if (aspect >= 1) {
        const int columns = rounded(std::sqrt(vertices / aspect));
        return {columns, rounded(vertices / columns)};
    }
    const int rows = rounded(std::sqrt(vertices * aspect));
    return {rounded(vertices / rows), rows};
}

Faces grid_faces(GridSize size, bool closed_columns, bool closed_rows) {
    const auto vertex = [size](int column, int row) {
        return (row % size.rows) * size.columns + column % size.columns;
    };
    Faces faces;
    for (int row = 0; row < size.rows - !closed_rows; ++row)
        for (int column = 0; column < size.columns - !closed_columns; ++column)
            faces.add(
                {vertex(column, row), vertex(column + 1, row), vertex(column + 1, row + 1), vertex(column, row + 1)});
    return faces;
}

Positions guide(int vertices, const std::function<Eigen::Vector3d(double)>& direction) {
    const int edges = vertices - 1;
    Positions positions(3, vertices);
    positions.col(0).setZero();
    for (int edge = 0; edge < edges; ++edge)
        positions.col(edge + 1) = positions.col(edge) + direction((2 * edge + 1.0) / edges - 1);
    return positions;
}

Positions regular_polygon(int vertices) {
    const double radius = 0.5 / std::sin(std::numbers::pi / vertices);
    Positions positions(3, vertices);
    for (int vertex = 0; vertex < vertices; ++vertex) {
        const double angle = 2 * std::numbers::pi * vertex / vertices;
        positions.col(vertex) << radius * std::cos(angle), radius * std::sin(angle), 0;
    }
    return positions;
}

Positions sum_of_guides(const Positions& across, const Positions& along) {
    Positions sum(3, across.cols() * along.cols());
    for (int row = 0; row < along.cols(); ++row)
        sum.middleCols(row * across.cols(), across.cols()) = across.colwise() + along.col(row);
    return sum;
}

}  // namespace chebnet
