#include "energy/length_power_energy.h"

#include <cmath>

namespace chebnet {

double LengthPowerEnergy::value(double r) const { return std::pow(std::abs(r - 1), m_p); }

double LengthPowerEnergy::slope(double r) const {
    return std::copysign(m_p * std::pow(std::abs(r - 1), m_p - 1), r - 1);
}

double LengthPowerEnergy::second_derivative(double r) const {
    return m_p * (m_p - 1) * std::pow(std::abs(r - 1), m_p - 2);
}

}  // namespace chebnet
