#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/length_projection.h"
#include "solve/pull.h"
#include "solve/slide.h"

namespace chebnet {

/// What positions have to keep to be a net that can be built: the length of every edge, and the limit of the corners.
/// Both are rows of one system of lengths: the edges, then the corners that are watched, of which those are switched on
/// that are held.
class NetConstraints {
public:
    /// Watches what is near its limit at `positions`. Keeps references to net and topology. Throws what LengthSystem
    /// does.
    NetConstraints(const Net& net, const Topology& topology, CornerLimit limit, const std::vector<bool>& is_free,
                   std::span<const Slide> slides, std::span<const Pull> pulls, const Positions& positions);
    /// V: the vertices that may move, those of them that slide, and those that are pulled, which give way the less to
    /// lengths the harder they are, but for those whose pull yields.
    void set_free(const std::vector<bool>& is_free, std::span<const Slide> slides, std::span<const Pull> pulls);

    /// Onto the lengths, and out of corners that are too sharp, which are held from now on. The system is left
    /// assembled for where that ends. `threshold`: of max dL. False if the lengths are not reached.
    bool project(Positions& positions, double threshold);
    /// Whether project() is to come as near to the lengths as it can where it comes nearer slowly, beside lines that
    /// are nearly straight.
    void set_patient(bool on) { m_is_patient = on; }
    /// The system for the edges and corners.
    LengthProjection& lengths() { return *m_lengths; }
    const LengthSystem& system() const { return m_lengths->system(); }

    /// By how much a corner is too sharp at most, in edge lengths of its diagonal; 0 if none is.
    double lack(const Positions& positions) const { return m_limit.largest_lack(positions); }
    /// For each diagonal the distance at which it is held, 0 if it is not.
    const std::vector<double>& held() const { return m_limit.held(); }
    void hold(const std::vector<double>& held);
    /// Holds these closer to their limit by this part of what they lack or exceed.
    void hold_closer(const std::vector<double>& held, double part);
    /// Holds those near their limit that such a move would bring beyond it. False if there are none.
    bool hold_blocking_ones(const Positions& positions, const Eigen::Matrix3Xd& move);
    /// Lets go of those that pull, or of the one that pulls most. False if there are none.
    bool release(const Eigen::VectorXd& multipliers, bool one_only);
    /// Lets go of those that are held before they have come to their limit.
    void release_early_ones();
    /// For each row by how much what is held exceeds its limit, in edge lengths.
    Eigen::VectorXd excess() const { return m_limit.excess(m_lengths->system()); }
    /// The part of a move, 1 at most, by which no other corner comes beyond its limit.
    double part_until_short(const Positions& positions, const Eigen::Matrix3Xd& move) const {
        return m_limit.part_until_short(positions, move);
    }

private:
    void watch(const Positions& positions);
    void set_free();
    bool project_lengths(Positions& positions, double threshold);

    const Net& m_net;
    const Topology& m_topology;
    CornerLimit m_limit;
    std::vector<bool> m_is_free;
    std::vector<Slide> m_slides;
    std::vector<Pull> m_pulls;
    bool m_is_patient = false;
    std::unique_ptr<LengthProjection> m_lengths;  // has rows for the corners watched
};

}  // namespace chebnet
