#pragma once

#include <Eigen/Core>

#include "solve/parts/gradient_direction.h"
#include "solve/parts/lbfgs_history.h"

namespace chebnet {

/// L-BFGS (Liu & Nocedal 1989). Steepest descent while there is no history.
class LbfgsDirection : public GradientDirection {
public:
    void restart() override;
    bool find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow& row) override;
    void accepted(double step) override;

private:
    LbfgsHistory<Eigen::Matrix3Xd> m_history{10};
    Eigen::Matrix3Xd m_gradient;  // where the last direction began
    Eigen::Matrix3Xd m_move;      // the last direction; once accepted, the part that was gone
};

}  // namespace chebnet
