#include "drape/bent_arms.h"

#include <algorithm>

namespace chebnet {

double BentArms::at(int arm, double way) const {
    const Eigen::VectorXd& numbers = turned[static_cast<std::size_t>(arm)];
    if (numbers.size() == 0) return 0;
    const double place = std::clamp(way / spacing - 0.5, 0.0, static_cast<double>(numbers.size() - 1));
    const auto before = static_cast<Eigen::Index>(place), behind = std::min(before + 1, numbers.size() - 1);
    return numbers[before] + (place - static_cast<double>(before)) * (numbers[behind] - numbers[before]);
}

}  // namespace chebnet
