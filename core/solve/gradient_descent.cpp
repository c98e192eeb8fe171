#include "solve/gradient_descent.h"

#include "energy/power_energy.h"
#include "solve/staged_descent.h"

namespace chebnet {

bool GradientDirection::find(const DescentPoint& point, Eigen::Matrix3Xd& direction, TraceRow&) {
    const double L = point.net.mean_length();
    direction = -m_scale * L * L * point.gradient;
    return true;
}

std::unique_ptr<Method> make_gradient_descent() {
    return std::make_unique<StagedDescent>(make_energy<PowerEnergy>, std::make_unique<GradientDirection>(),
                                           keep_all_vertices);
}

}  // namespace chebnet
