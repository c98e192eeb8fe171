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

/// Number of squares between filled and empty cells.
int boundary_face_count(const VoxelSolid& solid);

/// The boundary of a solid, squares of side 1 at their places in the lattice, counterclockwise from outside, as a
/// closed manifold: a lattice point becomes one vertex for each fan of squares about it, so that cubes which touch in
/// an edge or a vertex alone are parted there. The one exception: an edge in which two cubes touch joins them if at
/// both its ends other cubes join them already, because parted it would be the same edge twice.
Surface boundary_surface(const VoxelSolid& solid);

}  // namespace chebnet
