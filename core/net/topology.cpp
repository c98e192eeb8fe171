#include "net/topology.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <tuple>

namespace chebnet {

Topology::Topology(const Net& net)
    : m_net(net),
      m_start(static_cast<std::size_t>(net.vertex_count()) + 1, 0),
      m_neighbours(2 * static_cast<std::size_t>(net.edge_count())),
      m_incident_edges(m_neighbours.size()),
      m_is_boundary(static_cast<std::size_t>(net.vertex_count()), false) {
    const Eigen::Matrix2Xi& edges = net.edges();
    for (int e = 0; e < net.edge_count(); ++e)
        for (int side = 0; side < 2; ++side) ++m_start[edges(side, e) + 1];
    for (std::size_t v = 1; v < m_start.size(); ++v) m_start[v] += m_start[v - 1];

    // The smaller neighbours of a vertex come first, then the larger: as edges are in lexicographic order, both runs
    // are ascending.
    std::vector<int> next(m_start.begin(), m_start.end() - 1);
    for (int side = 1; side >= 0; --side)
        for (int e = 0; e < net.edge_count(); ++e) {
            const int slot = next[edges(side, e)]++;
            m_neighbours[slot] = edges(1 - side, e);
            m_incident_edges[slot] = e;
        }

    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 1)
            for (int side = 0; side < 2; ++side) m_is_boundary[edges(side, e)] = true;
}

std::span<const int> Topology::neighbours(int vertex) const {
    return {m_neighbours.data() + m_start[vertex], m_neighbours.data() + m_start[vertex + 1]};
}

std::span<const int> Topology::incident_edges(int vertex) const {
    return {m_incident_edges.data() + m_start[vertex], m_incident_edges.data() + m_start[vertex + 1]};
}

int Topology::edge_between(int a, int b) const {
    const int slot = slot_of(a, b);
    return slot < m_start[a + 1] && m_neighbours[slot] == b ? m_incident_edges[slot] : -1;
}

std::vector<std::vector<int>> Topology::boundary_loops() const {
    std::vector<bool> walked(static_cast<std::size_t>(m_net.edge_count()), false);
    std::vector<int> next(m_start.begin(), m_start.end() - 1);  // slots before it have been walked
    const auto next_slot = [&](int vertex) {
        for (int& slot = next[vertex]; slot < m_start[vertex + 1]; ++slot) {
            const int e = m_incident_edges[slot];
            if (m_net.edge_face_counts()[e] == 1 && !walked[e]) return slot;
        }
        return -1;
    };
    // Every vertex has an even number of boundary edges (each of its fans of faces has two ends), so a walk along
    // unwalked edges ends where it began. Whenever it meets itself, what lies between is a loop of its own.
    std::vector<std::vector<int>> loops;
    std::vector<int> place_in_walk(static_cast<std::size_t>(m_net.vertex_count()), -1);
    for (int origin = 0; origin < m_net.vertex_count(); ++origin) {
        std::vector<int> walk{origin};
        place_in_walk[origin] = 0;
        for (int slot = next_slot(origin); slot >= 0; slot = next_slot(walk.back())) {
            walked[m_incident_edges[slot]] = true;
            const int vertex = m_neighbours[slot];
            if (const int place = place_in_walk[vertex]; place >= 0) {
                loops.emplace_back(walk.begin() + place, walk.end());
                for (int v : loops.back()) place_in_walk[v] = -1;
                walk.resize(static_cast<std::size_t>(place));
            }
            place_in_walk[vertex] = static_cast<int>(walk.size());
            walk.push_back(vertex);
        }
        place_in_walk[origin] = -1;
    }
    return loops;
}

std::vector<std::vector<int>> Topology::net_lines(InwardCorners corners) const {
    const std::vector<int> across = straight_on(corners);
    std::vector<bool> walked(static_cast<std::size_t>(m_net.edge_count()), false);
    std::vector<std::vector<int>> lines;
    const auto walk = [&](int vertex, int slot) {
        std::vector<int>& line = lines.emplace_back(1, vertex);
        while (slot >= 0 && !walked[m_incident_edges[slot]]) {
            walked[m_incident_edges[slot]] = true;
            const int next = m_neighbours[slot];
            line.push_back(next);
            slot = across[slot_of(next, vertex)];
            vertex = next;
        }
    };
    // Lines that no walk from an end has reached are closed.
    for (const bool closed : {false, true})
        for (int v = 0; v < m_net.vertex_count(); ++v)
            for (int slot = m_start[v]; slot < m_start[v + 1]; ++slot)
                if (!walked[m_incident_edges[slot]] && (closed || across[slot] < 0)) walk(v, slot);
    return lines;
}

bool Topology::is_closed(const std::vector<int>& line) const {
    constexpr int k_straight_valence = 3;  // on the boundary
    const int v = line.front();
    return v == line.back() && valence(v) == (is_boundary(v) ? k_straight_valence : k_regular_valence);
}

bool Topology::is_closed(const std::vector<int>& line, const std::vector<int>& straight_on) const {
    const int v = line.front();
    return v == line.back() && straight_on[slot_of(v, line[1])] == slot_of(v, line[line.size() - 2]);
}

int Topology::slot_of(int vertex, int neighbour) const {
    const std::span<const int> others = neighbours(vertex);
    return m_start[vertex] +
           static_cast<int>(std::lower_bound(others.begin(), others.end(), neighbour) - others.begin());
}

std::vector<int> Topology::straight_on(InwardCorners corners) const {
    // An edge has two faces at most, and with each a neighbour at the vertex.
    std::vector<std::array<int, 2>> beside(m_neighbours.size(), {-1, -1});
    const auto add = [&](int slot, int other) { beside[slot][beside[slot][0] < 0 ? 0 : 1] = other; };
    for (int f = 0; f < m_net.face_count(); ++f) {
        const std::span<const int> face = m_net.faces()[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            const int v = face[k];
            const int a = slot_of(v, face[(k + 1) % face.size()]);
            const int b = slot_of(v, face[(k + face.size() - 1) % face.size()]);
            add(a, b);
            add(b, a);
        }
    }
    const auto across = [&](int vertex, int slot) {
        int found = -1, candidates = 0, inner = 0;
        for (int other = m_start[vertex]; other < m_start[vertex + 1]; ++other) {
            if (other == slot || other == beside[slot][0] || other == beside[slot][1]) continue;
            const bool has_two_faces = beside[other][1] >= 0;
            ++candidates;
            if (has_two_faces) ++inner;
            // Two show that there is none, which is known soon also where very many edges meet.
            if (inner == 2 || (candidates == 2 && corners == InwardCorners::end)) return -1;
            if (candidates == 1 || has_two_faces) found = other;
        }
        return candidates == 1 || (inner == 1 && corners == InwardCorners::pass) ? found : -1;
    };
    std::vector<int> straight(m_neighbours.size(), -1);
    for (int v = 0; v < m_net.vertex_count(); ++v)
        for (int slot = m_start[v]; slot < m_start[v + 1]; ++slot) {
            const int other = across(v, slot);
            if (other >= 0 && across(v, other) == slot) straight[slot] = other;
        }
    return straight;
}

std::vector<std::vector<int>> Topology::components() const {
    std::vector<bool> seen(static_cast<std::size_t>(m_net.vertex_count()), false);
    std::vector<std::vector<int>> components;
    for (int root = 0; root < m_net.vertex_count(); ++root) {
        if (seen[root]) continue;
        seen[root] = true;
        std::vector<int>& reached = components.emplace_back(1, root);
        for (std::size_t i = 0; i < reached.size(); ++i)
            for (int n : neighbours(reached[i]))
                if (!seen[n]) {
                    seen[n] = true;
                    reached.push_back(n);
                }
    }
    return components;
}

std::vector<bool> Topology::in_pieces_without(const std::vector<bool>& is_marked) const {
    std::vector<bool> without(is_marked.size(), false);
    for (const std::vector<int>& piece : components())
        if (std::none_of(piece.begin(), piece.end(), [&](int v) { return is_marked[v]; }))
            for (int v : piece) without[v] = true;
    return without;
}

std::map<int, int> Topology::singular_vertices() const {
    std::map<int, int> counts;
    for (int v = 0; v < m_net.vertex_count(); ++v)
        if (is_singular(v)) ++counts[valence(v)];
    return counts;
}

std::vector<double> Topology::distances_from(std::span<const int> sources) const {
    const std::vector<NearestSource> nearest = nearest_sources(sources);
    std::vector<double> distances(nearest.size());
    std::transform(nearest.begin(), nearest.end(), distances.begin(),
                   [](const NearestSource& n) { return n.distance; });
    return distances;
}

std::vector<NearestSource> Topology::nearest_sources(std::span<const int> sources) const {
    const bool equal_lengths = m_net.rest_lengths().minCoeff() == m_net.rest_lengths().maxCoeff();
    return equal_lengths ? nearest_by_steps(sources) : nearest_by_length(sources);
}

/// Breadth first. Within a layer, vertices of earlier sources come first.
std::vector<NearestSource> Topology::nearest_by_steps(std::span<const int> sources) const {
    const double L = m_net.rest_lengths()[0];
    std::vector<NearestSource> nearest(static_cast<std::size_t>(m_net.vertex_count()));
    std::vector<int> reached;
    reached.reserve(nearest.size());
    const auto reach = [&](int v, const NearestSource& from) {
        if (nearest[v].source >= 0) return;
        nearest[v] = from;
        reached.push_back(v);
    };
    for (int source : sources) reach(source, {source, 0});
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const auto [source, distance] = nearest[reached[i]];
        for (int n : neighbours(reached[i])) reach(n, {source, distance + L});
    }
    return nearest;
}

/// Dijkstra 1959.
std::vector<NearestSource> Topology::nearest_by_length(std::span<const int> sources) const {
    std::vector<NearestSource> nearest(static_cast<std::size_t>(m_net.vertex_count()));
    struct Way {
        double distance;
        int place;  // of its source
        int vertex;
        bool operator>(const Way& other) const {
            return std::tie(distance, place, vertex) > std::tie(other.distance, other.place, other.vertex);
        }
    };
    std::priority_queue<Way, std::vector<Way>, std::greater<>> queue;
    for (int place = 0; place < static_cast<int>(sources.size()); ++place) queue.push({0, place, sources[place]});
    std::vector<bool> settled(nearest.size(), false);
    while (!queue.empty()) {
        const auto [distance, place, v] = queue.top();
        queue.pop();
        if (settled[v]) continue;
        settled[v] = true;
        nearest[v] = {sources[place], distance};
        for (int slot = m_start[v]; slot < m_start[v + 1]; ++slot) {
            const int n = m_neighbours[slot];
            const double along = distance + m_net.rest_lengths()[m_incident_edges[slot]];
            if (settled[n] || along > nearest[n].distance) continue;
            nearest[n].distance = along;
            queue.push({along, place, n});
        }
    }
    return nearest;
}

}  // namespace chebnet
