#include "solve/parts/turned_move.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace chebnet {

namespace {

// Keeps the turn about edges that lie in one line small, in squared edge lengths.
constexpr double k_turn_inertia = 1e-3;

}  // namespace

void TurnedMove::begin(const Net& net, const Topology& topology, const Positions& x, const Eigen::Matrix3Xd& move) {
    m_from = &x;
    m_move = &move;
    m_turns.resize(3, net.vertex_count());
    const double least = k_turn_inertia * net.mean_length() * net.mean_length();
    for (int v = 0; v < net.vertex_count(); ++v) {
        Eigen::Matrix3d inertia = least * Eigen::Matrix3d::Identity();
        Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
        for (int n : topology.neighbours(v)) {
            const Eigen::Vector3d p = x.col(n) - x.col(v), d = move.col(n) - move.col(v);
            inertia += p.squaredNorm() * Eigen::Matrix3d::Identity() - p * p.transpose();
            momentum += p.cross(d);
        }
        m_turns.col(v) = inertia.inverse() * momentum;
    }
}

void TurnedMove::add_pull(double t, const NeighbourPairs& pairs, const NeighbourForm& form, Eigen::Matrix3Xd& pull) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const double weight = form.weight(k);
        if (weight == 0) continue;
        const auto& [a, b] = pairs[k];
        const Eigen::Vector3d p = m_from->col(a) - m_from->col(b), d = m_move->col(a) - m_move->col(b);
        const Eigen::Vector3d force = weight * ((turned(a, t, p, d) + turned(b, t, p, d)) / 2 - p - t * d);
        pull.col(a) += force;
        pull.col(b) -= force;
    }
}

/// With R(2 c) q = q + 2 / (1 + c²) (c × q + c × (c × q)).
Eigen::Vector3d TurnedMove::turned(int vertex, double t, const Eigen::Vector3d& p, const Eigen::Vector3d& d) const {
    const Eigen::Vector3d c = t / 2 * m_turns.col(vertex);
    const Eigen::Vector3d q = p + t * d - 2 * c.cross(p), turning = c.cross(q);
    return q + 2 / (1 + c.squaredNorm()) * (turning + c.cross(turning));
}

}  // namespace chebnet
