#pragma once

#include "shapes/family.h"

namespace chebnet {

/// What acts on a gridshell beside its stiffness, as loads on a unit of area.
struct Loads {
    double hold;      ///< of springs that draw every vertex to its place in the blocks
    double pressure;  ///< from within
};

/// Relaxes a gridshell of rods that lie along the net lines of `blocks`, a net of oblong faces, and are straight when
/// free: minimises
///
///     ½ Σ_v A_v ‖κ_v‖² + ½ hold Σ_v A_v ‖x_v − b_v‖² − pressure · volume
///
/// where every edge keeps its length in the blocks, and no corner leaves the range of 60° … 120°. A_v is the area about
/// a vertex, b_v its place in the blocks. κ_v is what the directions of the edges of a net line differ by at v, so that
/// a rod is as stiff as its edges are long: the loads mean the same in nets of any fineness if they are given in
/// proportion to the square of the edges' length. At a singular vertex κ_v is the sum of all directions; at a boundary
/// only the line along it bends.
///
/// Singular vertices are the tips of cones, for a point has no area that could resist. `rounding`, 0 … 1, opens them:
/// it widens the corners where three edges meet, narrows those where five or six do, towards those of a plane, and
/// draws rods towards turning little, so that with 1 faces at an edge are folded by some 60° at most, but where a limb
/// is few cells thick.
///
/// By the alternating direction method of multipliers (Overby et al. 2017, "ADMM ⊇
/// projective dynamics"); after some fifty iterations lengths are right to some thousandths.
///
/// Uses no function of the C library but the square root, and no sum whose order is left to the compiler, so the same
/// bits come out natively and in WebAssembly.
void relax(const Mesh& blocks, const Loads& loads, double rounding, int iterations, Positions& positions);

/// Moves vertices as little as may be until the edges have the lengths that they have in the blocks, to the last
/// digits.
void restore_lengths(const Mesh& blocks, Positions& positions);

}  // namespace chebnet
