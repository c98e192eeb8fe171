#pragma once

#include <Eigen/Core>

#include "net/net.h"
#include "net/topology.h"
#include "solve/parts/neighbour_form.h"
#include "solve/parts/neighbour_pairs.h"

namespace chebnet {

/// A move of a net, carried out as a turn where the net turns. Along straight ways all that turns grows, by the square
/// of the angle; here each vertex v has the turn ω_v that fits the move of its edges best, and a pair of neighbours
/// a, b at p = x_a − x_b with the move d = m_a − m_b is to be at
///
///     p(t) = ½ Σ_{v ∈ {a, b}} R(t ω_v) (p + t (d − ω_v × p)),
///
/// which a rigid motion obeys at any t, and any move for small t: p(t) = p + t d + O(t²). R is Cayley's rotation, by
/// 2 atan(|ω| / 2). (Rotations from infinitesimal ones, as Huang et al. do for modes of vibration: Interactive Shape
/// Interpolation through Controllable Dynamic Deformation. IEEE Transactions on Visualization and Computer Graphics
/// 17(7), 2011.)
class TurnedMove {
public:
    /// Finds how the net at x turns along. Keeps references to x and move, which must last.
    void begin(const Net& net, const Topology& topology, const Positions& x, const Eigen::Matrix3Xd& move);
    /// What x + t · move, under a form that joins pairs, is pulled by towards where they are to be: adds
    /// Σ weight · (p(t) − p − t d) at the two ends of each.
    void add_pull(double t, const NeighbourPairs& pairs, const NeighbourForm& form, Eigen::Matrix3Xd& pull);
    /// To x + t · move.
    void go_straight(double t, Positions& to) const { to = *m_from + t * *m_move; }

private:
    Eigen::Vector3d turned(int vertex, double t, const Eigen::Vector3d& p, const Eigen::Vector3d& d) const;

    const Positions* m_from = nullptr;
    const Eigen::Matrix3Xd* m_move = nullptr;
    Eigen::Matrix3Xd m_turns;  // V: ω
};

}  // namespace chebnet
