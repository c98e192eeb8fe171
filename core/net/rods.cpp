#include "net/rods.h"

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
    if (!shared || net.is_chebyshev() || faces_by_arity(net.faces()).size() < 2) return false;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (!is_as_long(net.rest_lengths()[e], *shared) && !topology.is_boundary(net.edges()(0, e)) &&
            !topology.is_boundary(net.edges()(1, e)))
            return false;
    }
    return true;
}

}  // namespace chebnet
