#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "drape/compass.h"

namespace chebnet {

/// Faces of a net whose rods end on the border of a surface.
struct BorderCut {
    struct End {
        DrapedVertex vertex;  ///< on the boundary
        int beyond = -1;      ///< the vertex that the rod went to
    };

    std::vector<End> ends;                ///< numbered behind the vertices that were given
    std::vector<std::vector<int>> faces;  ///< joined to the first vertex by edges
};

/// Cuts the cells of a net that goes over the border of a surface: each rod ends where it meets the boundary curve, and
/// an edge goes from each end to the next within a cell. A rod that would end in a stub of less than k_shortest_end
/// stops at its last vertex, and one that goes no farther than that beyond the border stays whole. What is left of a
/// cell is taken off where it would be a quad with a corner sharper than `smallest_angle`, or hangs on by a corner, or
/// has a rod that is longer than it was.
BorderCut cut_at_border(const Compass& compass, double smallest_angle, const std::vector<DrapedVertex>& vertices,
                        const std::vector<std::array<int, 4>>& cells);

/// The cosine beyond which a corner is sharper than this. Rounding puts none there: a net may be laid with all its
/// corners at the limit.
inline double largest_cosine(double smallest_angle) { return std::cos(smallest_angle) + 1e-10; }

/// In edge lengths.
inline constexpr double k_shortest_end = 0.05;

}  // namespace chebnet
