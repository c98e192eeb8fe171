#include "net/rods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "net/measures.h"

namespace chebnet {

namespace {

// Of a length: what is nearer to it is as long, also of a net whose dL is 1e-9.
constexpr double k_as_long = 1e-4;

bool is_as_long(double length, double shared, double tolerance = k_whole_edge) {
    return std::abs(length - shared) <= tolerance * shared;
}

// A cosine, of 30°: a rod turns by less from one edge to the next, sheared and coarse as a net may be.
constexpr double k_straight = 0.866;

/// Whether a border may have cut the edge.
bool is_at_border(const Net& net, const Topology& topology, int edge) {
    return topology.is_boundary(net.edges()(0, edge)) || topology.is_boundary(net.edges()(1, edge));
}

bool has_whole_quad(const Net& net, const Topology& topology, double length) {
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        bool is_whole = face.size() == 4;
        for (std::size_t k = 0; k < 4 && is_whole; ++k)
            is_whole = is_as_long(net.rest_lengths()[topology.edge_between(face[k], face[(k + 1) % 4])], length);
        if (is_whole) return true;
    }
    return false;
}

/// Which edges are of rods, where all share a length but those that a border may have cut.
class RodEdges {
public:
    RodEdges(const Net& net, const Topology& topology, double shared)
        : m_net(net), m_topology(topology), m_shared(shared), m_is_whole(static_cast<std::size_t>(net.edge_count())) {
        const double tolerance = whole_edge_tolerance(net, topology, shared);
        for (int e = 0; e < net.edge_count(); ++e) m_is_whole[e] = is_as_long(net.rest_lengths()[e], shared, tolerance);
        m_is_rod = m_is_whole;
        for (int e = 0; e < net.edge_count(); ++e)
            if (!is_on_boundary(e)) m_is_rod[e] = true;
        const std::vector<int> straight_on = topology.straight_on(InwardCorners::pass);
        const std::vector<bool> is_cut = cut_along_border(straight_on);
        for (int f = 0; f < net.face_count(); ++f) find_rims(net.faces()[f], is_cut);
        // Not those that go on from a rim.
        const std::vector<bool> is_cut_rod = cut_along_border(straight_on);
        for (int e = 0; e < net.edge_count(); ++e)
            if (is_cut_rod[e]) m_is_rod[e] = true;
    }

    std::vector<bool> take() { return std::move(m_is_rod); }

private:
    bool is_on_boundary(int edge) const { return m_net.edge_face_counts()[edge] == 1; }
    bool is_shorter(int edge) const { return !m_is_whole[edge] && m_net.rest_lengths()[edge] < m_shared; }

    /// E: edges on the boundary that are not whole and go on straight, wherever they go on, from a whole one of a rod.
    std::vector<bool> cut_along_border(const std::vector<int>& straight_on) const {
        std::vector<bool> goes_on(m_is_whole.size()), bends(m_is_whole.size());
        for (int v = 0, first = 0; v < m_net.vertex_count(); first += m_topology.valence(v++))
            for (int k = 0; k < m_topology.valence(v); ++k) {
                if (straight_on[first + k] < 0) continue;
                const int edge = m_topology.incident_edges(v)[k];
                (is_straight(v, k, straight_on[first + k] - first) ? goes_on : bends)[edge] = true;
            }
        for (int e = 0; e < m_net.edge_count(); ++e)
            goes_on[e] = goes_on[e] && !bends[e] && is_on_boundary(e) && !m_is_whole[e];
        return goes_on;
    }

    /// Of two edges at a vertex, by their numbers there, whether one goes on straight from the other, a whole one of a
    /// rod.
    bool is_straight(int v, int edge, int other) const {
        const Positions& x = m_net.rest_positions();
        const Eigen::Vector3d before = x.col(v) - x.col(m_topology.neighbours(v)[other]),
                              next = x.col(m_topology.neighbours(v)[edge]) - x.col(v);
        const int whole = m_topology.incident_edges(v)[other];
        return m_is_whole[whole] && m_is_rod[whole] && before.dot(next) > k_straight * before.norm() * next.norm();
    }

    /// Sides of whole length that lead from the end of one rod to that of another: both sides beside them are rods that
    /// were cut. In a quad all that is shorter is a rod, across from one between two faces; in a triangle it may be a
    /// rim beside a whole rod. Where a net is but one cell wide nothing tells rims from rods that are as long.
    void find_rims(std::span<const int> face, const std::vector<bool>& is_cut) {
        const std::size_t n = face.size();
        const auto edge = [&](std::size_t k) { return m_topology.edge_between(face[k % n], face[(k + 1) % n]); };
        const auto is_cut_rod = [&](int e) { return is_shorter(e) && (n == 4 || !is_on_boundary(e) || is_cut[e]); };
        for (std::size_t k = 0; k < n; ++k) {
            const bool lies_across = is_cut_rod(edge(k + 1)) && is_cut_rod(edge(k + n - 1));
            if (is_on_boundary(edge(k)) && lies_across && (n != 4 || !is_on_boundary(edge(k + 2))))
                m_is_rod[edge(k)] = false;
        }
    }

    const Net& m_net;
    const Topology& m_topology;
    double m_shared;
    std::vector<bool> m_is_whole, m_is_rod;
};

/// So that a closed line does not begin within a rod that ends elsewhere.
void begin_at_rim(std::vector<int>& line, std::vector<bool>& is_rod) {
    const auto rim = std::find(is_rod.begin(), is_rod.end(), false);
    if (rim == is_rod.end()) return;
    const auto at = rim - is_rod.begin();
    line.pop_back();
    std::rotate(line.begin(), line.begin() + at, line.end());
    line.push_back(line.front());
    std::rotate(is_rod.begin(), is_rod.begin() + at, is_rod.end());
}

}  // namespace

std::vector<std::vector<int>> rods(const Net& net, const Topology& topology, std::optional<double> length) {
    std::vector<std::vector<int>> lines = topology.net_lines(InwardCorners::pass);
    if (net.is_chebyshev()) return lines;
    std::optional<double> whole = shared_length(net);
    if (!whole) whole = length;
    if (!whole && is_cut(net, topology)) whole = whole_length(net);
    if (!whole) return lines;
    const std::vector<bool> is_of_rod = rod_edges(net, topology, *whole);
    const std::vector<bool> is_closed = closed_rods(topology, lines);
    std::vector<std::vector<int>> rods;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<int>& line = lines[i];
        std::vector<bool> is_rod;
        for (std::size_t k = 1; k < line.size(); ++k)
            is_rod.push_back(is_of_rod[topology.edge_between(line[k - 1], line[k])]);
        if (is_closed[i]) begin_at_rim(line, is_rod);
        for (std::size_t k = 0; k < is_rod.size(); ++k) {
            if (!is_rod[k]) continue;
            if (k == 0 || !is_rod[k - 1]) rods.push_back({line[k]});
            rods.back().push_back(line[k + 1]);
        }
    }
    return rods;
}

std::vector<bool> rod_edges(const Net& net, const Topology& topology, double length) {
    return RodEdges(net, topology, length).take();
}

double whole_length(const Net& net) {
    if (const std::optional<double> shared = shared_length(net)) return *shared;
    double longest = 0;
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 2) longest = std::max(longest, net.rest_lengths()[e]);
    return longest > 0 ? longest : net.rest_lengths().maxCoeff();
}

double whole_edge_tolerance(const Net& net, const Topology& topology, double shared) {
    constexpr double k_farther = 2;  // those that end at the border may be
    double spread = 0, nearly = 0;
    bool has_uncut = false;
    for (int e = 0; e < net.edge_count(); ++e) {
        const double step = std::abs(net.rest_lengths()[e] - shared) / shared;
        if (step <= k_whole_edge) nearly = std::max(nearly, step);
        if (is_at_border(net, topology, e)) continue;
        has_uncut = true;
        spread = std::max(spread, step);
    }
    return std::clamp(k_farther * (has_uncut ? spread : nearly), k_as_long, k_whole_edge);
}

std::vector<bool> closed_rods(const Topology& topology, const std::vector<std::vector<int>>& rods) {
    const std::vector<int> straight_on = topology.straight_on(InwardCorners::pass);
    std::vector<bool> is_closed;
    for (const std::vector<int>& rod : rods) is_closed.push_back(topology.is_closed(rod, straight_on));
    return is_closed;
}

bool is_cut(const Net& net, const Topology& topology) {
    if (net.is_chebyshev()) return false;
    const double length = whole_length(net);
    if (!shared_length(net) && !has_whole_quad(net, topology, length)) return false;
    const auto is_whole = [&](int edge) { return is_as_long(net.rest_lengths()[edge], length); };
    for (int e = 0; e < net.edge_count(); ++e)
        if (!is_whole(e) && !is_at_border(net, topology, e)) return false;
    if (faces_by_arity(net.faces()).size() > 1) return true;
    // A border along the lines leaves quads alone: of whole edges in a line the last is cut short.
    const auto is_cut_short = [&](int end, int before, int further) {
        const int edge = topology.edge_between(end, before);
        return topology.is_boundary(end) && net.edge_face_counts()[edge] == 2 && !is_whole(edge) &&
               net.rest_lengths()[edge] < length && is_whole(topology.edge_between(before, further));
    };
    const std::vector<std::vector<int>> lines = topology.net_lines();
    return std::any_of(lines.begin(), lines.end(), [&](const std::vector<int>& line) {
        const std::size_t n = line.size();
        return n > 2 &&
               (is_cut_short(line[0], line[1], line[2]) || is_cut_short(line[n - 1], line[n - 2], line[n - 3]));
    });
}

}  // namespace chebnet
