#include "net/rods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

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
        : m_net(net), m_topology(topology), m_is_whole(static_cast<std::size_t>(net.edge_count())) {
        const double tolerance = whole_edge_tolerance(net, topology, shared);
        for (int e = 0; e < net.edge_count(); ++e) m_is_whole[e] = is_as_long(net.rest_lengths()[e], shared, tolerance);
        m_is_rod = m_is_whole;
        for (int e = 0; e < net.edge_count(); ++e)
            if (!is_on_boundary(e)) m_is_rod[e] = true;
        for (int f = 0; f < net.face_count(); ++f) find_rims(net.faces()[f]);
    }

    /// Of each edge of a line, whether it is of a rod.
    std::vector<bool> along(const std::vector<int>& line, bool is_closed) const {
        const std::size_t count = line.size() - 1;
        const auto edge = [&](std::size_t k) {
            return m_topology.edge_between(line[k % count], line[(k % count) + 1]);
        };
        std::vector<bool> is_rod(count);
        for (std::size_t k = 0; k < count; ++k) {
            is_rod[k] = m_is_rod[edge(k)];
            if (m_is_whole[edge(k)] || is_rod[k]) continue;
            const bool has_before = k > 0 || is_closed, has_next = k + 1 < count || is_closed;
            const bool follows = !has_before || goes_on(line, k + count - 1, edge(k + count - 1));
            const bool leads_on = !has_next || goes_on(line, k, edge(k + 1));
            is_rod[k] = (has_before || has_next) && follows && leads_on;
        }
        return is_rod;
    }

private:
    bool is_on_boundary(int edge) const { return m_net.edge_face_counts()[edge] == 1; }

    /// Sides of whole length that lead from the end of one rod to that of another: both sides beside them are shorter.
    /// Where a net is but one cell wide nothing tells them from rods that are as long.
    void find_rims(std::span<const int> face) {
        const std::size_t n = face.size();
        const auto edge = [&](std::size_t k) { return m_topology.edge_between(face[k % n], face[(k + 1) % n]); };
        for (std::size_t k = 0; k < n; ++k) {
            const bool lies_across = !m_is_whole[edge(k + 1)] && !m_is_whole[edge(k + n - 1)];
            if (is_on_boundary(edge(k)) && lies_across && (n != 4 || !is_on_boundary(edge(k + 2))))
                m_is_rod[edge(k)] = false;
        }
    }

    /// Whether a line goes straight on from edge k to the next, one of which, `other`, is a whole one of a rod.
    bool goes_on(const std::vector<int>& line, std::size_t k, int other) const {
        const std::size_t count = line.size() - 1;
        const int a = line[k % count], b = line[k % count + 1], c = line[(k + 1) % count + 1];
        const Positions& x = m_net.rest_positions();
        const Eigen::Vector3d before = x.col(b) - x.col(a), next = x.col(c) - x.col(b);
        return m_is_whole[other] && m_is_rod[other] && before.dot(next) > k_straight * before.norm() * next.norm();
    }

    const Net& m_net;
    const Topology& m_topology;
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
    const RodEdges edges(net, topology, *whole);
    const std::vector<bool> is_closed = closed_rods(topology, lines);
    std::vector<std::vector<int>> rods;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<int>& line = lines[i];
        std::vector<bool> is_rod = edges.along(line, is_closed[i]);
        if (is_closed[i]) begin_at_rim(line, is_rod);
        for (std::size_t k = 0; k < is_rod.size(); ++k) {
            if (!is_rod[k]) continue;
            if (k == 0 || !is_rod[k - 1]) rods.push_back({line[k]});
            rods.back().push_back(line[k + 1]);
        }
    }
    return rods;
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
