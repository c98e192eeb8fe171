#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "edit/handle_graph.h"
#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// A vertex on a line of the net that is pulled straight. It stands where that has it, whatever else happens.
struct TautVertex {
    int vertex;
    /// Between which the line runs: handles by their places, then vertices that are taut themselves, from the number of
    /// handles on, in their order; all of them before this one.
    int end_a, end_b;
    double part;  ///< of the way from one to the other

    bool operator==(const TautVertex&) const = default;
    /// `ends`: a column for each of them.
    Eigen::Vector3d place(const Eigen::Matrix3Xd& ends) const {
        return ends.col(end_a) + part * (ends.col(end_b) - ends.col(end_a));
    }
};

/// The places of taut vertices, a column for each; `handles`: those of the handles, likewise.
Eigen::Matrix3Xd places_of(std::span<const TautVertex> taut, const Eigen::Matrix3Xd& handles);

/// Which lines of a net its handles pull straight: the shortest paths between those that stand as far apart as the
/// path is long, and then those between the vertices of such lines; four corners hold a flat sheet. To first order a
/// vertex of such a line may move across it, though in truth it may not: what is to be solved has to know that it is
/// held. What was found is remembered, since handles that keep lines taut tend to do so for a while.
class TautLines {
public:
    /// Ends whose distance lacks no more than this part of the path's length pull it straight: it could sag by some
    /// two thousandths of an edge over thirteen, and its edges lack a squared part of 1e-14.
    static constexpr double k_slack = 1e-7;
    /// The searches for paths pass about as many edges at most in a call; lines beyond that are left for the next.
    static constexpr int k_most_steps = 2'000'000;

    /// Of other handles, or another net.
    void forget() { m_rounds.clear(); }
    /// Whether there was a line in the last find() whose ends are farther apart than it is long: no net has all in
    /// place.
    bool is_torn() const { return m_is_torn; }
    /// Of none of the lines that pass a vertex of `avoided` (V). `vertices`: of the handles, −1 for one that pulls
    /// nothing straight; `targets`: 3 × handles, where they are to be; `graph`: of these handles. Lines of which a
    /// vertex is farther than `nearness` from its place at `positions` are left out, since the net is not there yet;
    /// but for those that were as straight in the last net, and only move along.
    std::vector<TautVertex> find(const Net& net, const Topology& topology, const HandleGraph& graph,
                                 std::vector<int> vertices, const Eigen::Matrix3Xd& targets, std::vector<bool> avoided,
                                 const Positions& positions, const Positions& last_net, double nearness);

private:
    struct Line {
        int end_a, end_b;
        std::vector<TautVertex> inside;
    };
    /// What lies between certain ends.
    struct Round {
        std::vector<int> ends;    // vertices
        HandleGraph graph;        // of them; empty for the handles
        std::vector<Line> lines;  // by their ends
    };
    /// Null if it is not found yet. `longest`: of edges of the last net, in rest lengths.
    const Line* line(const Net& net, const Topology& topology, Round& round, int a, int b, double length,
                     const Positions& last_net, double longest);

    std::vector<Round> m_rounds;
    int m_steps_left = 0;
    bool m_is_torn = false;
};

}  // namespace chebnet
