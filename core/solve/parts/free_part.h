#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "net/net.h"

namespace chebnet {

/// V, true for each vertex that is no handle.
std::vector<bool> free_vertices(int vertex_count, std::span<const int> fixed);

/// The vertices of a net that may move, numbered as the nodes of a linear system, and the edges that feel their moves.
/// Fixed vertices are eliminated: an edge from a free to a fixed vertex adds to the free one's diagonal block only,
/// which gives the same step as the paper's KKT system (5).
class FreePart {
public:
    /// `is_free`: V.
    FreePart(const Net& net, const std::vector<bool>& is_free);

    /// An edge with a free end. A fixed end has the node −1; an edge with two free ends has a link of the system.
    struct Edge {
        int index;
        int node_a, node_b;
        int link;
    };

    const std::vector<int>& vertices() const { return m_vertices; }     ///< node → vertex
    int node_of(int vertex) const { return m_node_of_vertex[vertex]; }  ///< −1: fixed
    int size() const { return static_cast<int>(m_vertices.size()); }
    std::span<const Edge> edges() const { return m_edges; }
    /// 2×K, the nodes of each link.
    const Eigen::Matrix2Xi& links() const { return m_links; }
    /// One node of each piece of the net that no fixed vertex holds. The forces of edges on such a piece sum to zero,
    /// so that a system with anything positive added at this node is definite and has the same shape as solution, with
    /// this node at rest.
    const std::vector<int>& floating_nodes() const { return m_floating_nodes; }
    /// The one node that stands for the piece of the net in which a node is; if the piece floats, its floating node.
    int piece_of(int node) const { return m_piece_of_node[node]; }
    /// An order of elimination for this part (node → rank) from one for a part that contains it; saves finding one.
    std::vector<int> induced_order(const FreePart& whole, const std::vector<int>& rank_in_whole) const;

private:
    void find_pieces();

    std::vector<int> m_vertices;
    std::vector<int> m_node_of_vertex;  // −1: fixed
    std::vector<Edge> m_edges;
    Eigen::Matrix2Xi m_links;
    std::vector<int> m_floating_nodes, m_piece_of_node;
};

}  // namespace chebnet
