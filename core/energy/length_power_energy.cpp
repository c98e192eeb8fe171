#include "energy/length_power_energy.h"

#include <algorithm>
#include <cmath>

namespace chebnet {

namespace {

// For p < 2, f'' grows beyond all numbers towards r = 1, where most edges of a net at rest are. It grows no more once
// they are nearer than this.
constexpr double k_nearest = 1e-8;

}  // namespace

double LengthPowerEnergy::value(double r) const { return std::pow(std::abs(r - 1), m_p); }

double LengthPowerEnergy::slope(double r) const {
    return std::copysign(m_p * std::pow(std::abs(r - 1), m_p - 1), r - 1);
}

double LengthPowerEnergy::second_derivative(double r) const {
    return m_p * (m_p - 1) * std::pow(std::max(std::abs(r - 1), m_p < 2 ? k_nearest : 0), m_p - 2);
}

double LengthPowerEnergy::relative_slope(double deviation) const {
    return m_p > 2 ? m_p / 2 * std::pow(std::sqrt(deviation), m_p - 2) : 1;
}

}  // namespace chebnet
