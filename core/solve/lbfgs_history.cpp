#include "solve/lbfgs_history.h"

namespace chebnet {

namespace {

constexpr double k_least_curvature = 1e-10;

}  // namespace

void LbfgsHistory::learn(const Eigen::Matrix3Xd& move, const Eigen::Matrix3Xd& gradient_change) {
    const double sy = dot(move, gradient_change);
    if (!(sy > k_least_curvature * move.norm() * gradient_change.norm())) return;
    m_ring.resize(m_memory);
    if (m_count == m_memory)
        m_first = (m_first + 1) % m_memory;
    else
        ++m_count;
    Correction& latest = correction(m_count - 1);
    latest.s = move;
    latest.y = gradient_change;
    latest.sy = sy;
}

}  // namespace chebnet
