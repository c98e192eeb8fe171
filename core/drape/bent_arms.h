#pragma once

#include <Eigen/Core>
#include <array>

#include "drape/drape.h"

namespace chebnet {

/// The four arms of a net from its seed: along the first family, along the second, and against each.
inline constexpr int k_arms = 4;

/// How far arms have turned left from the geodesics along which they leave the seed.
struct BentArms {
    double spacing = 1;                            ///< of the numbers, along an arm
    std::array<Eigen::VectorXd, k_arms> turned{};  ///< radians, in the middles of stretches of that length; none: 0

    /// So far from the seed, between the numbers in proportion to the way, behind the last as there.
    double at(int arm, double way) const;
};

/// drape() with arms along geodesics (or the curve that `options` has) but for how they are bent.
Drape drape_with(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options, const BentArms& bent);

}  // namespace chebnet
