#pragma once

#include <Eigen/Core>
#include <vector>

#include "remesh/wish_placer.h"
#include "surface/surface.h"

namespace chebnet {

/// By which angle transport along each side is turned (radians of the fourth power), so that the curvature of the
/// connection is where singular vertices may be: 2π · index in the triangles at a pinned vertex, none in those that are
/// forbidden, and, unless these alone are wished for, elsewhere what it was, less what a pinned vertex has taken from
/// its neighbourhood and more by what forbidden triangles have given to theirs. Then the smoothest field has its
/// singular vertices there (Crane, Desbrun & Schröder, Trivial Connections on Discrete Surfaces, 2010). Opposite sides
/// have opposite angles.
///
/// `curvature`: of each triangle, four times its own, in radians; `border`: of each side on the boundary that
/// the field follows the angle by which transport is turned for it to do so; else 0. `is_followed`: which they are.
/// What is left over goes through the rest of the boundary, where there is any.
struct TurnedConnection {
    std::vector<double> angles;      ///< of each side
    Eigen::VectorXd potential;       ///< of each triangle, whose differences turn transport along the sides between
    std::vector<bool> is_unaligned;  ///< of each vertex: it is on a boundary that is not followed, or cannot be with
                                     ///< these alone
};
TurnedConnection turned_connection(const Surface& surface, std::vector<double> curvature,
                                   const std::vector<double>& border, const std::vector<bool>& is_followed,
                                   const PlacedWishes& wishes);

}  // namespace chebnet
