#pragma once

#include <optional>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// Which handles bound each other directly, and how far apart the net lets them stand.
///
/// Let d_ij be the length of the shortest path between handles i and j. Their targets must satisfy |t_i − t_j| ≤ d_ij
/// for every pair, but pairs with a third handle k on a shortest path need no check: if |t_i − t_k| ≤ s d_ik and
/// |t_k − t_j| ≤ s d_kj, then |t_i − t_j| ≤ s (d_ik + d_kj) = s d_ij. By induction on the length the largest strain
/// |t_i − t_j| / d_ij of all pairs is attained by one with no handle in between: only those are kept. So are all pairs
/// joined by an edge, which must not be too close either.
///
/// Handles spread over a net have few such neighbours. Where they have many, or the net between them is vast, each
/// keeps its nearest ones, so that time and memory stay bounded (k_most_neighbours, k_most_steps); the bounds that are
/// left out are implied less tightly by those kept. Up to 2,000 handles on a net of up to 25,000 vertices of valence 4
/// meet neither bound.
class HandleGraph {
public:
    struct Neighbour {
        int handle;
        double distance;  ///< the length of the shortest path, d_ij
    };

    /// All handles' neighbours together are about as many at most; those joined by an edge are not counted.
    static constexpr int k_most_neighbours = 4'000'000;
    /// All searches together pass about as many edges at most.
    static constexpr int k_most_steps = 200'000'000;

    HandleGraph() = default;
    /// `vertices`: of the handles, all different; −1 for one that bounds no other. They are numbered as they come.
    HandleGraph(const Net& net, const Topology& topology, std::span<const int> vertices);

    int size() const { return static_cast<int>(m_start.size()) - 1; }
    /// The neighbours of a handle, ascending. It is among the neighbours of each of them.
    std::span<const Neighbour> neighbours(int handle) const {
        return std::span(m_neighbours).subspan(m_start[handle], m_start[handle + 1] - m_start[handle]);
    }

private:
    std::vector<std::size_t> m_start{0};
    std::vector<Neighbour> m_neighbours;
};

/// A vertex on a path, and how far along it.
struct OnPath {
    int vertex;
    double distance;
};
/// The vertices between two on a shortest path of this `length`, from the second to the first; none if they are
/// neighbours. Only vertices are looked at by which a path may be as short as that, as straight ways at `positions`
/// tell, where no edge has more than `longest` times its rest length. Nothing if the path is not found in so many
/// steps, of which those that it took are taken off.
std::optional<std::vector<OnPath>> inside_of_shortest_path(const Net& net, const Topology& topology, int from, int to,
                                                           double length, const Positions& positions, double longest,
                                                           int& steps_left);

}  // namespace chebnet
