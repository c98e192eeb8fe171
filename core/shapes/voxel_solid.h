#pragma once

#include <Eigen/Core>
#include <vector>

#include "shapes/family.h"

namespace chebnet {

/// A solid of equal cubes: cells of the unit lattice, filled or empty. Cell (i, j, k) is the cube between the lattice
/// points (i, j, k) and (i + 1, j + 1, k + 1).
class VoxelSolid {
public:
    /// Empty, with room for the cells low ≤ cell < high.
    VoxelSolid(const Eigen::Vector3i& low, const Eigen::Vector3i& high);

    const Eigen::Vector3i& low() const { return m_low; }
    const Eigen::Vector3i& high() const { return m_high; }
    /// False outside the room.
    bool filled(const Eigen::Vector3i& cell) const;
    /// Fills the cells low ≤ cell < high, all within the room.
    void fill(const Eigen::Vector3i& low, const Eigen::Vector3i& high);

private:
    std::size_t index(const Eigen::Vector3i& cell) const;

    Eigen::Vector3i m_low, m_high;
    std::vector<char> m_filled;
};

/// Calls visit(cell, axis, side) for each square of the boundary: the one that closes the filled `cell` along `axis`,
/// below (side 0) or above (side 1).
template <typename Visit>
void for_each_face(const VoxelSolid& solid, Visit visit) {
    Eigen::Vector3i cell;
    for (cell.z() = solid.low().z(); cell.z() < solid.high().z(); ++cell.z())
        for (cell.y() = solid.low().y(); cell.y() < solid.high().y(); ++cell.y())
            for (cell.x() = solid.low().x(); cell.x() < solid.high().x(); ++cell.x()) {
                if (!solid.filled(cell)) continue;
                for (int axis = 0; axis < 3; ++axis)
                    for (int side = 0; side < 2; ++side)
                        if (!solid.filled(cell + (2 * side - 1) * Eigen::Vector3i::Unit(axis))) visit(cell, axis, side);
            }
}

/// The boundary of a solid, squares of side 1 at their places in the lattice, counterclockwise from outside, as a
/// closed manifold: a lattice point becomes one vertex for each fan of squares about it, so that cubes which touch in
/// an edge or a vertex alone are parted there. The one exception: an edge in which two cubes touch joins them if at
/// both its ends other cubes join them already, because parted it would be the same edge twice.
Mesh boundary_surface(const VoxelSolid& solid);

}  // namespace chebnet
