#include "solve/parts/lbfgs_direction.h"

namespace chebnet {

void LbfgsDirection::restart() {
    GradientDirection::restart();
    m_history.clear();
    m_move.resize(3, 0);
}

bool LbfgsDirection::find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow& row) {
    if (m_move.cols() == point.gradient.cols()) m_history.learn(m_move, point.gradient - m_gradient);
    m_gradient = point.gradient;
    if (m_history.empty()) {
        GradientDirection::find(point, direction, row);
    } else {
        direction = -point.gradient;
        m_history.apply(direction, [&](Eigen::Matrix3Xd& d) { d *= m_history.latest_scale(); });
    }
    m_move = direction;
    return true;
}

void LbfgsDirection::accepted(double step) {
    if (m_history.empty()) GradientDirection::accepted(step);
    m_move *= step;
}

}  // namespace chebnet
