#pragma once

#include "solve/parts/descent_direction.h"

namespace chebnet {

/// Steepest descent, −∇E, scaled so that a line search that starts at 1 tries twice the last accepted step first.
class GradientDirection : public DescentDirection {
public:
    void prepare(const FreePart&) override {}
    void restart() override { m_scale = 1; }
    bool find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow&) override {
        const double L = point.net.mean_length();
        direction = -m_scale * L * L * point.gradient;
        return true;
    }
    void accepted(double step) override { m_scale *= 2 * step; }

private:
    double m_scale = 1;  // of the step, in units of the mean length squared
};

}  // namespace chebnet
