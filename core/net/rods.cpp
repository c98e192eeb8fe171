#include "net/rods.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace chebnet {

double length_of_most(const Net& net) {
    Eigen::VectorXd lengths = net.rest_lengths();
    const auto middle = lengths.begin() + lengths.size() / 2;
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

std::vector<std::vector<int>> rods(const Net& net, const Topology& topology) {
    const double length = length_of_most(net);
    const auto is_rim = [&](int edge) {
        return net.edge_face_counts()[edge] == 1 && std::abs(net.rest_lengths()[edge] - length) > k_whole_edge * length;
    };
    std::vector<std::vector<int>> lines = topology.net_lines();
    std::erase_if(lines, [&](const std::vector<int>& line) { return is_rim(topology.edge_between(line[0], line[1])); });
    return lines;
}

}  // namespace chebnet
