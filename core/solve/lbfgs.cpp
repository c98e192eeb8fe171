#include "solve/lbfgs.h"

#include "energy/power_energy.h"
#include "solve/staged_descent.h"

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

std::unique_ptr<Method> make_lbfgs() {
    return std::make_unique<StagedDescent>(make_energy<PowerEnergy>, std::make_unique<LbfgsDirection>(),
                                           keep_all_vertices);
}

}  // namespace chebnet
