#pragma once

#include <Eigen/Core>
#include <optional>

#include "net/net.h"

namespace chebnet {

/// A flat net whose handles come closer within its plane should bow out of it, as a lath does; but to first order
/// nothing pushes it there, and within the plane it can only fold up. So it is given the bow that makes up for what
/// moves within the plane take from the lengths of edges.

/// The normal of the plane in which all vertices lie, nearly, to the side of axis `up` where that says something; null
/// if there is none.
std::optional<Eigen::Vector3d> normal_of_flat(const Net& net, const Positions& positions, int up);

/// How much of a bow (3×V, along the normal) to add to moves (3×V): the c with c² = Σ_e t_e s_e² / Σ_e s_e⁴, for which
/// c² s_e² fits t_e best, where t_e is what the moves take from the square of the length of edge e, and s_e how much
/// higher one of its ends comes than the other by the bow. Negative where the moves lead to the other side, or lead to
/// none and the energy rises along the bow. 0 where edges get longer on the whole.
double part_of_bow(const Net& net, const Positions& positions, const Eigen::Matrix3Xd& moves,
                   const Eigen::Matrix3Xd& bow, bool rises);

}  // namespace chebnet
