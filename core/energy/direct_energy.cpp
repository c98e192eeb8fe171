#include "energy/direct_energy.h"

#include <cmath>

#include "net/measures.h"

namespace chebnet {

double DirectEnergy::value(double r) const { return std::pow(deviation(r), m_p); }

double DirectEnergy::slope(double r) const { return m_p * std::pow(deviation(r), m_p - 1) * (1 - 1 / r) * (1 + 1 / r); }

double DirectEnergy::second_derivative(double r) const {
    // dL′² / dL = (r + 1)² / r³ has no pole at r = 1.
    return m_p * std::pow(deviation(r), m_p - 1) * ((m_p - 1) * (r + 1) * (r + 1) + 2) / (r * r * r);
}

}  // namespace chebnet
