#include "solve/lbfgs.h"

#include <utility>
#include <vector>

#include "energy/power_energy.h"
#include "solve/staged_descent.h"

namespace chebnet {

namespace {

constexpr std::size_t k_memory = 10;
// A correction without clearly positive curvature would spoil the positive definiteness of the whole; Armijo's rule
// alone does not exclude it.
constexpr double k_least_curvature = 1e-10;

double dot(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }

}  // namespace

void LbfgsDirection::restart() {
    GradientDirection::restart();
    m_history.clear();
    m_move.resize(3, 0);
}

bool LbfgsDirection::find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow& row) {
    if (m_move.cols() == point.gradient.cols()) learn(point.gradient);
    m_gradient = point.gradient;
    if (m_history.empty()) {
        GradientDirection::find(point, direction, row);
    } else {
        std::vector<double> alpha(m_history.size());
        direction = -point.gradient;
        for (std::size_t k = m_history.size(); k-- > 0;) {
            alpha[k] = dot(m_history[k].s, direction) / m_history[k].sy;
            direction -= alpha[k] * m_history[k].y;
        }
        direction *= m_history.back().sy / m_history.back().y.squaredNorm();
        for (std::size_t k = 0; k < m_history.size(); ++k)
            direction += (alpha[k] - dot(m_history[k].y, direction) / m_history[k].sy) * m_history[k].s;
    }
    m_move = direction;
    return true;
}

void LbfgsDirection::accepted(double step) {
    if (m_history.empty()) GradientDirection::accepted(step);
    m_move *= step;
}

/// Keeps what the last move has told about the curvature.
void LbfgsDirection::learn(const Eigen::Matrix3Xd& gradient) {
    Eigen::Matrix3Xd y = gradient - m_gradient;
    const double sy = dot(m_move, y);
    if (!(sy > k_least_curvature * m_move.norm() * y.norm())) return;
    m_history.push_back({m_move, std::move(y), sy});
    if (m_history.size() > k_memory) m_history.pop_front();
}

std::unique_ptr<Method> make_lbfgs() {
    return std::make_unique<StagedDescent>(make_energy<PowerEnergy>, std::make_unique<LbfgsDirection>(),
                                           keep_all_vertices);
}

}  // namespace chebnet
