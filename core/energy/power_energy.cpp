#include "energy/power_energy.h"

#include <cmath>

namespace chebnet {

double PowerEnergy::value(double r) const {
    const double h = std::pow(r, m_p / 2);
    return (h - 1 / h) * (h - 1 / h);
}

double PowerEnergy::slope(double r) const {
    const double h = std::pow(r, m_p / 2);
    return m_p / r * (h - 1 / h) * (h + 1 / h);
}

double PowerEnergy::second_derivative(double r) const {
    const double g = std::pow(r, m_p);
    return m_p / (r * r) * ((m_p - 1) * g + (m_p + 1) / g);
}

EdgeCurvature PowerEnergy::curvature(double r) const {
    const double g = std::pow(r, m_p);
    return {m_p / (r * r) * ((m_p - 1) * g + 2 * m_p / g), m_p / (r * r) * g};
}

}  // namespace chebnet
