#pragma once

#include <Eigen/Core>
#include <vector>

#include "remesh/grid_map.h"
#include "surface/surface.h"

namespace chebnet {

/// Quads by what lies beyond their sides, before they have vertices: quad q has the sides 4 q … 4 q + 3,
/// counterclockwise.
struct Cells {
    std::vector<int> opposite;  ///< of each side the side of the neighbour along the same edge; −1 at the boundary
    Positions centres;          ///< 3×Q
    Positions normals;          ///< 3×Q, of the surface there
    std::vector<int> pieces;    ///< of each the piece of the surface on which it is, as Surface::components() counts

    int size() const { return static_cast<int>(centres.cols()); }
};

/// One cell where two lines of a map cross that run in the middle of the grid's cells: so the lines are what is dual to
/// the net. Each line passes from triangle to triangle by the order in which lines meet the edge between them, and in a
/// triangle two lines cross if their ends on its boundary alternate. That order is reckoned once for each edge, hence
/// the result is a mesh of quads whatever the map, also where it folds over; there are irregular vertices then.
Cells cells_of(const Surface& surface, const GridMap& map);

}  // namespace chebnet
