#include "net/rods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "net/cell_sides.h"
#include "net/corner_edges.h"
#include "net/measures.h"

namespace chebnet {

namespace {

bool is_as_long(double length, double shared) { return std::abs(length - shared) <= k_whole_edge * shared; }

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

/// Whether rods cross at several inner vertices that no edge joins, and all end at the border behind.
bool cross_apart(const Net& net, const Topology& topology) {
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 2 &&
            topology.is_boundary(net.edges()(0, e)) == topology.is_boundary(net.edges()(1, e)))
            return false;
    int crossings = 0;
    for (int v = 0; v < net.vertex_count(); ++v) {
        if (topology.is_singular(v)) return false;
        crossings += topology.is_boundary(v) ? 0 : 1;
    }
    return crossings > 1;
}

/// Whether a net has the lengths of a narrow one that a border has cut, hardly by chance: none between two faces is
/// longer than L, or shorter where no border can have cut it, of which there are several unless rods cross apart; and
/// all that are as long are of rods.
bool has_lengths_of_cut_rods(const Net& net, const Topology& topology, double length) {
    const std::vector<bool> is_corner = corners_of_cells(net), is_rod = rod_edges(net, topology, length);
    const double tolerance = whole_edge_tolerance(net, length);
    int uncut = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const double step = net.rest_lengths()[e] / length - 1;
        const bool is_whole = std::abs(step) <= tolerance;
        if (is_whole && !is_rod[e]) return false;
        if (net.edge_face_counts()[e] != 2) continue;
        const bool is_uncut = is_corner[net.edges()(0, e)] && is_corner[net.edges()(1, e)];
        if (!is_whole && (is_uncut || step > 0)) return false;
        uncut += is_uncut ? 1 : 0;
    }
    return uncut > 1 || cross_apart(net, topology);
}

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
    const std::vector<int> sides = cell_sides(net, topology, length);
    std::vector<bool> is_rod(static_cast<std::size_t>(net.edge_count()));
    for (int e = 0; e < net.edge_count(); ++e) is_rod[e] = net.edge_face_counts()[e] != 1;
    const std::vector<int> edges = corner_edges(net, topology);
    for (std::size_t corner = 0; corner < sides.size(); ++corner)
        if (sides[corner] != k_rim) is_rod[edges[corner]] = true;
    return is_rod;
}

double whole_length(const Net& net) {
    if (const std::optional<double> shared = shared_length(net)) return *shared;
    double longest = 0;
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 2) longest = std::max(longest, net.rest_lengths()[e]);
    return longest > 0 ? longest : net.rest_lengths().maxCoeff();
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
    if (!shared_length(net) && !has_whole_quad(net, topology, length) &&
        !has_lengths_of_cut_rods(net, topology, length))
        return false;
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
