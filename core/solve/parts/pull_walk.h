#pragma once

#include <Eigen/Core>
#include <cmath>
#include <span>
#include <vector>

#include "net/net.h"
#include "solve/pull.h"

namespace chebnet {

/// The way of what soft handles pull towards, from where the net knows it to where it is to be, gone in steps of an
/// edge length, or if it is far, in fifty, as a hand would: a stiff one that pulled from afar at once would crumple the
/// net around its vertex. What is softer, or yields, pulls towards its target from the beginning.
class PullWalk {
public:
    /// Whether a pull is stiff enough to walk.
    static bool walks(const Pull& pull) { return pull.weight >= k_stiff && std::isinf(pull.yields); }

    /// Other pulls, at their targets. Those of before are known until begin().
    void take(std::span<const Pull> pulls);
    /// A way to these targets begins, at those that the same pulls had before if they are known, or at their vertices
    /// where these are nearer. `edge_length`: the unit of the way. One that is no longer is at its end at once, unless
    /// it is to be gone all the same.
    void begin(const Positions& positions, bool are_known, double edge_length, bool also_short);
    /// The part of the way that has been gone.
    double walked() const { return m_walked; }
    /// The part at which the next step is to end.
    double next() const;
    void go_to(double part);
    /// What targets move on the way to a part of it, in place of targets.
    std::vector<Pull> moves_to(double part) const;
    /// With the targets that they have on their way.
    std::span<const Pull> now() const { return m_now; }

private:
    static constexpr double k_stiff = 0.5;

    Eigen::Vector3d target(std::size_t i, double part) const;

    std::vector<Pull> m_from, m_to, m_now;
    double m_walked = 1, m_stride = 1;  // parts of the way: gone, and of a step
};

}  // namespace chebnet
