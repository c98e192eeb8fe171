#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <numbers>
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

/// The map that follows the field best with cells of the given length, or of one that differs by a part of it up to
/// `slack`, if whole numbers fit better then: least squares in the gradients, with whole numbers of cells between
/// singular vertices, and around. No point of a triangle's corner has a coordinate in the
/// middle of a cell. What is to be on lines of the grid, of each side of the surface whether it is, creases or the
/// border, is on them where the field goes along it.
///
/// Cells are squares as far as can be; with a smaller `smallest_angle` (radians) they are rhombs with edges of one
/// length as far as can be, as many as squares, and no more acute than that. So between singular vertices, and around a
/// ring, there are as many cells as edges of one length ask for. Along the diagonals of the field, so that they are
/// sheared alike; about singular vertices, however they lie. Where there are no whole numbers to choose, as on a disc,
/// cells stay squares. `go_on` is called in each round; whoever wants an end throws.
GridMap fit_grid(const Surface& surface, const DirectionField& field, double length, double slack = 0,
                 const std::vector<bool>& on_lines = {}, double smallest_angle = std::numbers::pi / 2,
                 const std::function<void()>& go_on = nullptr);

/// Makes such maps, with nothing to be on lines, along a field and along those that it is turned() to, of cells of any
/// length.
using GridFitter = std::function<GridMap(const DirectionField& field, double length, double smallest_angle)>;

/// One for this field: most of the work is the same for all turns, and done once. The surface has to outlive it. Throws
/// Error as fit_grid() does.
GridFitter grid_fitter(const Surface& surface, const DirectionField& field);

}  // namespace chebnet
