#pragma once

#include <map>
#include <span>
#include <vector>

#include "net/net.h"

namespace chebnet {

/// Incidence of a net, built once in O(E): who is next to whom, what is boundary, how far along the net.
/// Keeps a reference to the net, which must outlive it.
class Topology {
public:
    explicit Topology(const Net& net);

    /// The vertices joined to `vertex` by an edge, ascending.
    std::span<const int> neighbours(int vertex) const;
    /// The edges at `vertex`, in the order of `neighbours`.
    std::span<const int> incident_edges(int vertex) const;
    int valence(int vertex) const { return m_start[vertex + 1] - m_start[vertex]; }
    bool is_boundary(int vertex) const { return m_is_boundary[vertex]; }

    /// Closed walks along the boundary edges, each a list of vertices without repetition of the first. A vertex where
    /// several boundary loops touch appears in each of them.
    std::vector<std::vector<int>> boundary_loops() const;
    /// The pieces that no edge joins, each a list of its vertices.
    std::vector<std::vector<int>> components() const;
    int component_count() const { return static_cast<int>(components().size()); }
    /// Inner vertices of a valence other than 4 (Li et al. 2022, section 2): valence → how many.
    std::map<int, int> singular_vertices() const;

    /// V, length of the shortest path along edges from `source`, by rest lengths; infinity where there is none. No net
    /// can hold two vertices farther apart than this.
    std::vector<double> distances_from(int source) const;

private:
    std::vector<double> distances_by_steps(int source) const;
    std::vector<double> distances_by_length(int source) const;

    const Net& m_net;
    std::vector<int> m_start;  // V + 1
    std::vector<int> m_neighbours, m_incident_edges;
    std::vector<bool> m_is_boundary;
};

}  // namespace chebnet
