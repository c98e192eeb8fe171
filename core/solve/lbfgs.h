#pragma once

#include <deque>
#include <memory>

#include "solve/gradient_descent.h"

namespace chebnet {

/// The two-loop recursion of L-BFGS (Nocedal 1980; Liu & Nocedal 1989). Steepest descent while there is no history.
class LbfgsDirection : public GradientDirection {
public:
    void restart() override;
    bool find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow& row) override;
    void accepted(double step) override;

private:
    struct Correction {
        Eigen::Matrix3Xd s, y;  // change of the positions, of the gradient
        double sy;              // their product, positive
    };
    void learn(const Eigen::Matrix3Xd& gradient);

    std::deque<Correction> m_history;  // the latest last
    Eigen::Matrix3Xd m_gradient;       // where the last direction began
    Eigen::Matrix3Xd m_move;           // the last direction; once accepted, the part that was gone
};

/// L-BFGS on the paper's energy, with its exponents.
std::unique_ptr<Method> make_lbfgs();

}  // namespace chebnet
