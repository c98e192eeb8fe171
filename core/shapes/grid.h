#pragma once

#include <Eigen/Core>
#include <functional>

#include "net/net.h"

namespace chebnet {

/// Vertices along the two directions of a grid.
struct GridSize {
    int columns, rows;
};

/// The grid of about `vertices` vertices in all with about `aspect` rows to a column.
GridSize grid_size(double vertices, double aspect);

/// Quads of a grid, vertex = row · columns + column. A closed direction joins its last vertex to its first. Faces turn
/// from the direction of growing columns to that of growing rows.
Faces grid_faces(GridSize size, bool closed_columns = false, bool closed_rows = false);

/// An open polyline with edges of length 1, 3×vertices. `direction` gives the unit vector of the edge at t in (−1, 1).
Positions guide(int vertices, const std::function<Eigen::Vector3d(double t)>& direction);

/// A closed regular polygon in the plane z = 0 about the origin, counterclockwise, with edges of length 1.
Positions regular_polygon(int vertices);

/// The translational surface of two guides, the sum of each vertex of one and each of the other: vertex (column, row)
/// is across(column) + along(row). Every edge is an edge of a guide, so the net is Chebyshev if the guides' edges are
/// all equal.
Positions sum_of_guides(const Positions& across, const Positions& along);

}  // namespace chebnet
