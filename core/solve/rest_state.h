#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>

#include "net/net.h"
#include "solve/pull.h"

namespace chebnet {

class LengthSystem;
class RestEnergy;

/// What is left until a net is at rest.
struct ToRest {
    /// ‖∇E + Jᵀλ‖ over what may move, in units of 1 / mean length: what force is left beside the multipliers of lengths
    /// and limit. While handles are on their way, that before the last step.
    double gradient_norm = 0;
    /// By how much a quad's diagonal is too short for the shear limit at most, in edge lengths.
    double corner_lack = 0;
    /// About how far the vertex that moves most still goes, in edge lengths: as the last step went, if the gradient
    /// goes on falling as it did on it. Infinite: not known.
    double motion = std::numeric_limits<double>::infinity();
};

/// A net that a method has brought to rest, or on the way there. Lengths are in the solver's unit. Keeps references to
/// what the method has, valid until it goes on.
struct RestState {
    ToRest left;
    /// Whether the multipliers are of these positions; while handles are on their way they are older.
    bool is_balanced;
    const Net& net;
    const Positions& positions;
    const RestEnergy& energy;          ///< last evaluated there
    const Eigen::Matrix3Xd& gradient;  ///< ∇E
    std::span<const Pull> pulls;
    const LengthSystem& system;          ///< of the lengths, and of the corners at their limit
    const Eigen::VectorXd& multipliers;  ///< λ of each of its rows, the edges first: positive where it pulls
};

/// E, how hard each edge pulls its ends together, or below 0 pushes them apart: a force, in the unit of
/// Options::gravity, of which an edge of mean length has its weight.
Eigen::VectorXd edge_forces(const RestState& state);

}  // namespace chebnet
