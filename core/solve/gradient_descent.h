#pragma once

#include <memory>

#include "solve/descent_direction.h"
#include "solve/method.h"

namespace chebnet {

/// Steepest descent, −∇E, scaled so that a line search that starts at 1 tries twice the last accepted step first.
class GradientDirection : public DescentDirection {
public:
    void prepare(const FreePart&) override {}
    void restart() override { m_scale = 1; }
    bool find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow& row) override;
    void accepted(double step) override { m_scale *= 2 * step; }

private:
    double m_scale = 1;  // of the step, in units of the mean length squared
};

/// Gradient descent on the paper's energy, with its exponents.
std::unique_ptr<Method> make_gradient_descent();

}  // namespace chebnet
