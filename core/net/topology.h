#pragma once

#include <limits>
#include <map>
#include <span>
#include <vector>

#include "net/net.h"

namespace chebnet {

/// Of inner vertices at which two net lines cross; others inside are singular.
inline constexpr int k_regular_valence = 4;

/// Which of some vertices is nearest, and the length of the shortest path along edges to it, by rest lengths.
struct NearestSource {
    int source = -1;  ///< −1: no path leads there
    double distance = std::numeric_limits<double>::infinity();
};

/// What net lines do at an inward corner of the boundary, as a vertex with three quads: one that comes along the
/// boundary has two edges before it with which it shares no face, of which one alone has two faces.
enum class InwardCorners {
    end,
    pass,  ///< by the edge that has two faces, as a rod goes on that lies at the border only up to there
};

/// Incidence of a net, built once in O(E): neighbours, boundary loops, net lines, distances along edges.
/// Keeps a reference to the net, which must outlive it.
class Topology {
public:
    explicit Topology(const Net& net);

    /// The vertices joined to `vertex` by an edge, ascending.
    std::span<const int> neighbours(int vertex) const;
    /// The edges at `vertex`, in the order of `neighbours`.
    std::span<const int> incident_edges(int vertex) const;
    /// The edge between two vertices; −1: none.
    int edge_between(int a, int b) const;
    int valence(int vertex) const { return m_start[vertex + 1] - m_start[vertex]; }
    bool is_boundary(int vertex) const { return m_is_boundary[vertex]; }
    bool is_singular(int vertex) const { return !is_boundary(vertex) && valence(vertex) != k_regular_valence; }

    /// Closed walks along the boundary edges, each a list of vertices without repetition of the first. A vertex where
    /// several boundary loops touch appears in each of them.
    std::vector<std::vector<int>> boundary_loops() const;
    /// Net lines: chains of edges that go straight on, each a list of vertices from end to end; a closed one ends with
    /// the vertex it begins with. Every edge lies on exactly one line; a line may cross itself.
    /// Straight on from an edge is the one edge at the vertex that shares no face with it, if there is just one and the
    /// same holds the other way round. So two lines cross at an inner vertex of valence 4, one follows the boundary
    /// through a vertex of valence 3, and at all other vertices, corners and singular ones, all lines end. The same
    /// holds where faces are no quads. What is to be done along a line, as a row that is put in, is done from border to
    /// border: so lines end at inward corners of the boundary, too, unless they are to pass these, as rods do.
    std::vector<std::vector<int>> net_lines(InwardCorners corners = InwardCorners::end) const;
    /// Of one of them. One that ends where it began, at a vertex at which it does not go straight on, is not closed.
    bool is_closed(const std::vector<int>& line) const;
    /// The same of lines that pass inward corners, or of parts of lines. `straight_on`: how they go on, see below.
    bool is_closed(const std::vector<int>& line, const std::vector<int>& straight_on) const;
    /// 2E. For each edge at each vertex, in the order of incident_edges() of one vertex after the other, the place in
    /// this order of the edge straight on from it, −1 where its line ends.
    std::vector<int> straight_on(InwardCorners corners) const;
    /// The pieces that no edge joins, each a list of its vertices.
    std::vector<std::vector<int>> components() const;
    int component_count() const { return static_cast<int>(components().size()); }
    /// V: whether no vertex of the piece is marked. `is_marked`: V.
    std::vector<bool> in_pieces_without(const std::vector<bool>& is_marked) const;
    /// Inner vertices of a valence other than 4 (Li et al. 2022, section 2): valence → how many.
    std::map<int, int> singular_vertices() const;

    /// V, length of the shortest path along edges from `source`, by rest lengths; infinity where there is none. No net
    /// can hold two vertices farther apart than this.
    std::vector<double> distances_from(int source) const { return distances_from(std::span(&source, 1)); }
    /// To the nearest of the `sources`.
    std::vector<double> distances_from(std::span<const int> sources) const;
    /// V, the nearest of the `sources` along edges, the first of equally near ones. One search, however many they are.
    std::vector<NearestSource> nearest_sources(std::span<const int> sources) const;

private:
    int slot_of(int vertex, int neighbour) const;
    std::vector<NearestSource> nearest_by_steps(std::span<const int> sources) const;
    std::vector<NearestSource> nearest_by_length(std::span<const int> sources) const;

    const Net& m_net;
    std::vector<int> m_start;  // V + 1; the slots of vertex v, one for each edge, are m_start[v] … m_start[v + 1] − 1
    std::vector<int> m_neighbours, m_incident_edges;
    std::vector<bool> m_is_boundary;
};

}  // namespace chebnet
