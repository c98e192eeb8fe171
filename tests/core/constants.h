#pragma once

#include <limits>
#include <numbers>

namespace chebnet::samples {

inline constexpr double k_pi = std::numbers::pi;
inline constexpr double k_degree = k_pi / 180;
inline constexpr double k_infinity = std::numeric_limits<double>::infinity();
inline constexpr double k_exact = 1e-12;  ///< max dL of what is made with compasses

}  // namespace chebnet::samples
