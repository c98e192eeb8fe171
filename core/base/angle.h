#pragma once

#include <numbers>

namespace chebnet {

/// In radians.
inline constexpr double k_degree = std::numbers::pi / 180;

/// The sharpest corner that a net may have unless something else is asked for: what wire mesh and draped cloth bear.
inline constexpr double k_usual_limit_degrees = 30, k_usual_shear_limit = k_usual_limit_degrees * k_degree;

}  // namespace chebnet
