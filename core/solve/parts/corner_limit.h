#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "net/net.h"
#include "solve/options.h"
#include "solve/parts/length_system.h"
#include "solve/terms/distance_constraint.h"

namespace chebnet {

/// The shear limit as an active set (Nocedal & Wright 2006, section 16.5): the diagonals that stand at their limit are
/// rows of the system of lengths, switched on while they push and off when they would pull. The system has rows for the
/// watched ones only, which are those not far from their limit.
class CornerLimit {
public:
    /// No limit.
    CornerLimit() = default;
    /// `angle`: radians.
    CornerLimit(const Net& net, double angle);

    /// Whether a diagonal that is not watched has come to its limit; then a system with other rows is needed.
    bool needs_more_rows(const Positions& positions) const;
    /// Watches those near their limit, and those that are held.
    void watch(const Positions& positions);
    /// What the system is to have beside the edges.
    std::vector<Distance> watched() const;
    /// Switches the rows of the system on and off.
    void apply(LengthSystem& system) const;

    /// Holds the diagonals that are too short: at their limit, or if that is far, some way towards it. Returns how many
    /// that changes.
    int hold_short_ones(const Positions& positions);
    /// Whether a diagonal that is not watched is not far from its limit, and would be short after such a move.
    bool is_blocked_by_unwatched(const Positions& positions, const Eigen::Matrix3Xd& moves) const;
    /// Holds those that would, as long as they are: what they exceed their limit by, the next move may take off.
    /// Returns how many that changes.
    int hold_blocking_ones(const Positions& positions, const Eigen::Matrix3Xd& moves);
    /// The part of a move, 1 at most, by which none that is not held becomes short by more than the tolerance, to first
    /// order.
    double part_until_short(const Positions& positions, const Eigen::Matrix3Xd& moves) const;
    /// For each row of the system by how much what is held exceeds its limit, in edge lengths; 0 for the others.
    Eigen::VectorXd excess(const LengthSystem& system) const;
    /// What held() was `from` is held closer to its limit by this part.
    void approach(const std::vector<double>& from, double part);
    /// Lets go of those whose multipliers pull. Returns how many.
    int release(const Eigen::VectorXd& multipliers);
    /// Lets go of the one that pulls most: where diagonals depend on each other, those that pull need not all be free.
    int release_one(const Eigen::VectorXd& multipliers);
    /// Lets go of those that are held before they have come to their limit. Returns how many.
    int release_early_ones();
    /// For each diagonal the distance at which it is held, 0 if it is not.
    const std::vector<double>& held() const { return m_held; }
    void set_held(const std::vector<double>& held) { m_held = held; }

    /// By how much a diagonal is too short at most, in edge lengths; 0 if none is.
    double largest_lack(const Positions& positions) const;
    /// Whether positions that were solved for keep the limit, that is whether none lacks more than k_kept.
    bool is_kept(const Positions& positions) const;

    /// A lack up to this, in edge lengths, is none to the active set.
    static constexpr double k_tolerance = 1e-4;
    /// What it lets pass, and as much again, which the projection onto the lengths may take off afterwards.
    static constexpr double k_kept = 2 * k_tolerance;

private:
    double lack(const Positions& positions, const Distance& limit) const;
    bool blocks(const Positions& positions, const Eigen::Matrix3Xd& moves, const Distance& limit) const;
    double shortening(const Positions& positions, const Eigen::Matrix3Xd& moves, const Distance& limit) const;

    std::vector<Distance> m_limits;
    std::vector<int> m_watched;  // in the order of the rows
    std::vector<bool> m_is_watched;
    std::vector<double> m_held;
};

/// That of Options::shear_limit, wider by `margin`, radians; none where that is 0.
CornerLimit corner_limit(const Net& net, const Options& options, double margin = 0);

}  // namespace chebnet
