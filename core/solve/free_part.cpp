#include "solve/free_part.h"

#include <algorithm>

namespace chebnet {

namespace {

/// The order of `whole` (vertex → rank) restricted to some vertices: node → rank among them.
std::vector<int> induced_order(const std::vector<int>& rank_in_whole) {
    const int n = static_cast<int>(rank_in_whole.size());
    std::vector<int> nodes(rank_in_whole.size());
    for (int i = 0; i < n; ++i) nodes[i] = i;
    std::sort(nodes.begin(), nodes.end(), [&](int a, int b) { return rank_in_whole[a] < rank_in_whole[b]; });
    std::vector<int> rank(nodes.size());
    for (int place = 0; place < n; ++place) rank[nodes[place]] = place;
    return rank;
}

}  // namespace

FreePart::FreePart(const Net& net, const std::vector<bool>& is_free, const FreePart* order_like)
    : m_node_of_vertex(is_free.size(), -1) {
    for (int v = 0; v < net.vertex_count(); ++v)
        if (is_free[v]) {
            m_node_of_vertex[v] = size();
            m_vertices.push_back(v);
        }

    Eigen::Matrix2Xi links(2, net.edge_count());
    int link_count = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const int a = m_node_of_vertex[net.edges()(0, e)], b = m_node_of_vertex[net.edges()(1, e)];
        if (a < 0 && b < 0) continue;
        const bool linked = a >= 0 && b >= 0;
        m_edges.push_back({e, a, b, linked ? link_count : -1});
        if (linked) links.col(link_count++) << a, b;
    }
    links.conservativeResize(2, link_count);

    std::vector<int> order;
    if (order_like != nullptr) {
        const std::vector<int>& whole = order_like->m_system->elimination_rank();
        for (int v : m_vertices) order.push_back(whole[order_like->m_node_of_vertex[v]]);
        order = induced_order(order);
    }
    m_system = std::make_unique<BlockSystem>(size(), links, std::move(order));
}

}  // namespace chebnet
