#include "net/rods.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "net/measures.h"

namespace chebnet {

namespace {

bool is_as_long(double length, double shared) { return std::abs(length - shared) <= k_whole_edge * shared; }

}  // namespace

std::vector<std::vector<int>> rods(const Net& net, const Topology& topology) {
    std::vector<std::vector<int>> lines = topology.net_lines();
    const std::optional<double> shared = shared_length(net);
    if (!shared) return lines;
    const auto is_rim = [&](int edge) {
        return net.edge_face_counts()[edge] == 1 && !is_as_long(net.rest_lengths()[edge], *shared);
    };
    std::erase_if(lines, [&](const std::vector<int>& line) { return is_rim(topology.edge_between(line[0], line[1])); });
    return lines;
}

bool is_cut(const Net& net, const Topology& topology) {
    const std::optional<double> shared = shared_length(net);
    if (!shared || net.is_chebyshev()) return false;
    const auto is_whole = [&](int edge) { return is_as_long(net.rest_lengths()[edge], *shared); };
    for (int e = 0; e < net.edge_count(); ++e)
        if (!is_whole(e) && !topology.is_boundary(net.edges()(0, e)) && !topology.is_boundary(net.edges()(1, e)))
            return false;
    if (faces_by_arity(net.faces()).size() > 1) return true;
    // A border along the lines leaves quads alone: of whole edges in a line the last is cut short.
    const auto is_cut_short = [&](int end, int before, int further) {
        const int edge = topology.edge_between(end, before);
        return topology.is_boundary(end) && net.edge_face_counts()[edge] == 2 && !is_whole(edge) &&
               net.rest_lengths()[edge] < *shared && is_whole(topology.edge_between(before, further));
    };
    const std::vector<std::vector<int>> lines = topology.net_lines();
    return std::any_of(lines.begin(), lines.end(), [&](const std::vector<int>& line) {
        const std::size_t n = line.size();
        return n > 2 &&
               (is_cut_short(line[0], line[1], line[2]) || is_cut_short(line[n - 1], line[n - 2], line[n - 3]));
    });
}

}  // namespace chebnet
