#include "solve/parts/path_extrapolation.h"

#include <algorithm>
#include <utility>

namespace chebnet {

void PathExtrapolation::add(const Positions& x) {
    std::rotate(m_points.begin(), m_points.end() - 1, m_points.end());
    m_points.front() = x;
    m_count = std::min(m_count + 1, 3);
}

bool PathExtrapolation::is_known() const {
    return m_count == 3 && m_points[0] != m_points[1] && m_points[1] != m_points[2];
}

Positions PathExtrapolation::at(double t) const {
    const auto& [x, before, first] = m_points;
    const Eigen::Matrix3Xd last = x - before, one_before = before - first;
    const double ratio = last.norm() / one_before.norm();
    // Newton's form with nodes 0, −1 and −1 − 1 / ratio.
    const Eigen::Matrix3Xd bend = (last - ratio * one_before) / (1 + 1 / ratio);
    return x + t * last + t * (t + 1) * bend;
}

}  // namespace chebnet
