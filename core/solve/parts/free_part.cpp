#include "solve/parts/free_part.h"

#include <algorithm>
#include <numeric>

#include "base/sets.h"

namespace chebnet {

std::vector<bool> free_vertices(int vertex_count, std::span<const int> fixed) {
    std::vector<bool> is_free(static_cast<std::size_t>(vertex_count), true);
    for (int v : fixed) is_free[v] = false;
    return is_free;
}

FreePart::FreePart(const Net& net, const std::vector<bool>& is_free)
    : m_node_of_vertex(is_free.size(), -1), m_links(2, net.edge_count()) {
    for (int v = 0; v < net.vertex_count(); ++v)
        if (is_free[v]) {
            m_node_of_vertex[v] = size();
            m_vertices.push_back(v);
        }

    int link_count = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const int a = m_node_of_vertex[net.edges()(0, e)], b = m_node_of_vertex[net.edges()(1, e)];
        if (a < 0 && b < 0) continue;
        const bool linked = a >= 0 && b >= 0;
        m_edges.push_back({e, a, b, linked ? link_count : -1});
        if (linked) m_links.col(link_count++) << a, b;
    }
    m_links.conservativeResize(2, link_count);
    find_pieces();
}

/// A piece is held if an edge joins it to a fixed vertex.
void FreePart::find_pieces() {
    Sets pieces(size());
    for (int k = 0; k < m_links.cols(); ++k) pieces.join(m_links(0, k), m_links(1, k));
    std::vector<bool> is_held(m_vertices.size(), false);
    for (const Edge& edge : m_edges)
        if (edge.link < 0) is_held[pieces.of(std::max(edge.node_a, edge.node_b))] = true;
    for (int node = 0; node < size(); ++node) {
        m_piece_of_node.push_back(pieces.of(node));
        if (pieces.of(node) == node && !is_held[node]) m_floating_nodes.push_back(node);
    }
}

std::vector<int> FreePart::induced_order(const FreePart& whole, const std::vector<int>& rank_in_whole) const {
    const auto rank_of = [&](int node) { return rank_in_whole[whole.m_node_of_vertex[m_vertices[node]]]; };
    std::vector<int> nodes(m_vertices.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return rank_of(a) < rank_of(b); });
    std::vector<int> rank(nodes.size());
    for (int place = 0; place < size(); ++place) rank[nodes[place]] = place;
    return rank;
}

}  // namespace chebnet
