#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "remesh/direction_field.h"
#include "surface/surface.h"

namespace chebnet {

/// Coordinates in the plane, in parts of a cell: so they are added and turned exactly.
using GridPoint = std::array<std::int64_t, 2>;
inline constexpr std::int64_t k_cell = std::int64_t{1} << 20;

/// p turned by so many (0 … 3) quarter turns counterclockwise.
GridPoint turned(const GridPoint& p, int quarter_turns);

/// A map of the surface into the plane, over which the lines of a grid fit together again where it is cut
/// (an integer-grid map, Bommes et al. 2013).
struct GridMap {
    std::vector<GridPoint> corners;  ///< of the corner at which each side begins, in the coordinates of its triangle
    std::vector<int> turns;          ///< of each side: beyond it coordinates are turned by so much …
    std::vector<GridPoint> shifts;   ///< … and then moved by so much, whole cells
};

/// The map that follows the field best with cells of the given length: least squares in the gradients, with whole
/// numbers of cells between singular vertices. No point of a triangle's corner has a coordinate in the middle of a
/// cell. What is to be on lines of the grid, of each side of the surface whether it is, creases or the border, is on
/// them where the field goes along it.
GridMap fit_grid(const Surface& surface, const DirectionField& field, double length,
                 const std::vector<bool>& on_lines = {});

}  // namespace chebnet
