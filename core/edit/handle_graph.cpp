#include "edit/handle_graph.h"

#include <algorithm>
#include <functional>

namespace chebnet {

namespace {

// Paths whose lengths differ by less than this part are equally long. A tie that is missed only adds a pair.
constexpr double k_rounding = 1e-12;

struct QueueEntry {
    double distance;
    int vertex;
    bool operator>(const QueueEntry& other) const { return distance > other.distance; }
};

/// For edges of one length: entries come in the order of their distance.
class FifoQueue {
public:
    void clear() { m_entries.clear(), m_next = 0; }
    bool empty() const { return m_next == m_entries.size(); }
    void push(const QueueEntry& entry) { m_entries.push_back(entry); }
    QueueEntry pop() { return m_entries[m_next++]; }

private:
    std::vector<QueueEntry> m_entries;
    std::size_t m_next = 0;
};

class PriorityQueue {
public:
    void clear() { m_entries.clear(); }
    bool empty() const { return m_entries.empty(); }
    void push(const QueueEntry& entry) {
        m_entries.push_back(entry);
        std::push_heap(m_entries.begin(), m_entries.end(), std::greater<>());
    }
    QueueEntry pop() {
        std::pop_heap(m_entries.begin(), m_entries.end(), std::greater<>());
        const QueueEntry nearest = m_entries.back();
        m_entries.pop_back();
        return nearest;
    }

private:
    std::vector<QueueEntry> m_entries;
};

struct Found {
    int from, to;  // handles, from < to
    double distance;
};

/// Shortest paths from one handle after the other, each search as far as paths without a handle in between lead.
template <typename Queue>
class Search {
public:
    Search(const Net& net, const Topology& topology, std::span<const int> vertices)
        : m_net(net),
          m_topology(topology),
          m_vertices(vertices),
          m_handle_at(static_cast<std::size_t>(net.vertex_count()), -1),
          m_labels(static_cast<std::size_t>(net.vertex_count())) {
        for (int i = 0; i < static_cast<int>(vertices.size()); ++i)
            if (vertices[i] >= 0) m_handle_at[vertices[i]] = i;
    }

    std::vector<Found> all_pairs() {
        for (int i = 0; i < static_cast<int>(m_vertices.size()); ++i)
            if (m_vertices[i] >= 0) search(i);
        return std::move(m_found);
    }

private:
    /// The state of a vertex in the present search.
    struct Label {
        int search = -1;  // number of the search that wrote it
        bool settled = false;
        bool covered = false;  // a handle lies on a shortest path to it
        double distance = 0;
    };

    void search(int from) {
        const int source = m_vertices[from];
        int steps_left = HandleGraph::k_most_steps / static_cast<int>(m_vertices.size());
        int finds_left = HandleGraph::k_most_neighbours / static_cast<int>(m_vertices.size());
        m_from = from;
        m_open = 0;
        m_queue.clear();
        add_joined();
        reach(source, 0, false);
        while (!m_queue.empty()) {
            const auto [distance, v] = m_queue.pop();
            Label& label = m_labels[v];
            if (label.settled) continue;
            label.settled = true;
            if (!label.covered) --m_open;
            const bool is_other = m_handle_at[v] >= 0 && v != source;
            if (is_other && !label.covered) {
                if (finds_left-- == 0) return;
                add(v, distance);
            }
            const bool covers = label.covered || is_other;
            if (covers && m_open == 0) return;  // beyond what is in the queue now, all is covered
            const std::span<const int> neighbours = m_topology.neighbours(v), edges = m_topology.incident_edges(v);
            for (std::size_t k = 0; k < neighbours.size(); ++k) {
                if (steps_left-- == 0) return;
                reach(neighbours[k], distance + m_net.rest_lengths()[edges[k]], covers);
            }
        }
    }

    void reach(int v, double distance, bool covered) {
        Label& label = m_labels[v];
        if (label.search != m_from) {
            label = {m_from, false, covered, distance};
            if (!covered) ++m_open;
            m_queue.push({distance, v});
            return;
        }
        if (label.settled || distance > (1 + k_rounding) * label.distance) return;
        const bool is_shorter = distance < (1 - k_rounding) * label.distance;
        const bool now_covered = covered || (label.covered && !is_shorter);
        m_open += static_cast<int>(label.covered) - static_cast<int>(now_covered);
        label.covered = now_covered;
        if (distance >= label.distance) return;
        label.distance = distance;
        m_queue.push({distance, v});
    }

    void add_joined() {
        const int source = m_vertices[m_from];
        const std::span<const int> neighbours = m_topology.neighbours(source);
        const std::span<const int> edges = m_topology.incident_edges(source);
        for (std::size_t k = 0; k < neighbours.size(); ++k)
            if (const int to = m_handle_at[neighbours[k]]; to > m_from)
                m_found.push_back({m_from, to, m_net.rest_lengths()[edges[k]]});
    }

    void add(int vertex, double distance) {
        const int to = m_handle_at[vertex];
        const std::span<const int> joined = m_topology.neighbours(m_vertices[m_from]);
        if (to > m_from && !std::binary_search(joined.begin(), joined.end(), vertex))
            m_found.push_back({m_from, to, distance});
    }

    const Net& m_net;
    const Topology& m_topology;
    const std::span<const int> m_vertices;
    std::vector<int> m_handle_at;  // V, −1 where there is none
    std::vector<Label> m_labels;   // V
    Queue m_queue;
    int m_from = 0;
    int m_open = 0;  // vertices in the queue that are not covered
    std::vector<Found> m_found;
};

std::vector<Found> find_pairs(const Net& net, const Topology& topology, std::span<const int> vertices) {
    if (net.rest_lengths().minCoeff() == net.rest_lengths().maxCoeff())
        return Search<FifoQueue>(net, topology, vertices).all_pairs();
    return Search<PriorityQueue>(net, topology, vertices).all_pairs();
}

}  // namespace

HandleGraph::HandleGraph(const Net& net, const Topology& topology, std::span<const int> vertices)
    : m_start(vertices.size() + 1, 0) {
    const std::vector<Found> pairs = find_pairs(net, topology, vertices);
    for (const auto& [from, to, distance] : pairs) ++m_start[from + 1], ++m_start[to + 1];
    for (std::size_t i = 1; i < m_start.size(); ++i) m_start[i] += m_start[i - 1];
    m_neighbours.resize(m_start.back());
    std::vector<std::size_t> next(m_start.begin(), m_start.end() - 1);
    for (const auto& [from, to, distance] : pairs) {
        m_neighbours[next[from]++] = {to, distance};
        m_neighbours[next[to]++] = {from, distance};
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
        std::sort(m_neighbours.begin() + static_cast<std::ptrdiff_t>(m_start[i]),
                  m_neighbours.begin() + static_cast<std::ptrdiff_t>(m_start[i + 1]),
                  [](const Neighbour& a, const Neighbour& b) { return a.handle < b.handle; });
}

std::optional<std::vector<OnPath>> inside_of_shortest_path(const Net& net, const Topology& topology, int from, int to,
                                                           double length, const Positions& positions, double longest,
                                                           int& steps_left) {
    const std::span<const int> joined = topology.neighbours(from);
    if (std::binary_search(joined.begin(), joined.end(), to)) return std::vector<OnPath>();
    constexpr int k_vertices_a_step = 16;  // to forget what was
    steps_left -= net.vertex_count() / k_vertices_a_step;
    if (steps_left <= 0) return std::nullopt;
    std::vector<OnPath> before(static_cast<std::size_t>(net.vertex_count()), {-1, -1});  // each vertex
    PriorityQueue queue;
    before[from].distance = 0;
    queue.push({0, from});
    while (!queue.empty()) {
        const auto [distance, v] = queue.pop();
        if (v == to) break;
        if (distance > before[v].distance) continue;
        const std::span<const int> neighbours = topology.neighbours(v), edges = topology.incident_edges(v);
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            if (steps_left-- <= 0) return std::nullopt;
            const double next = distance + net.rest_lengths()[edges[k]];
            const double least_left = (positions.col(neighbours[k]) - positions.col(to)).norm() / longest;
            if (next + least_left > (1 + k_rounding) * length) continue;
            OnPath& known = before[neighbours[k]];
            if (known.distance >= 0 && known.distance <= next) continue;
            known = {v, next};
            queue.push({next, neighbours[k]});
        }
    }
    if (before[to].vertex < 0) return std::nullopt;
    std::vector<OnPath> path;
    for (int v = before[to].vertex; v >= 0 && v != from; v = before[v].vertex) path.push_back({v, before[v].distance});
    return path;
}

}  // namespace chebnet
