#pragma once

#include <memory>
#include <span>
#include <vector>

#include "linear/graph_system.h"
#include "net/net.h"

namespace chebnet {

/// The vertices of a net that may move, the edges that feel it, and the linear system of their moves. Fixed vertices
/// are eliminated: an edge from a free to a fixed vertex adds to the free one's diagonal block only, which gives the
/// same step as the paper's KKT system (5).
class FreePart {
public:
    /// `is_free`: V. `order_like`: a part that contains this one and whose elimination order is taken over, which saves
    /// finding one; null: a new order is found.
    FreePart(const Net& net, const std::vector<bool>& is_free, const FreePart* order_like = nullptr);

    /// An edge with a free end. A fixed end has the node −1; an edge with two free ends has a link of the system.
    struct Edge {
        int index;
        int node_a, node_b;
        int link;
    };

    const std::vector<int>& vertices() const { return m_vertices; }  ///< node → vertex
    int size() const { return static_cast<int>(m_vertices.size()); }
    std::span<const Edge> edges() const { return m_edges; }
    BlockSystem& system() { return *m_system; }

private:
    std::vector<int> m_vertices;
    std::vector<int> m_node_of_vertex;  // −1: fixed
    std::vector<Edge> m_edges;
    std::unique_ptr<BlockSystem> m_system;
};

}  // namespace chebnet
