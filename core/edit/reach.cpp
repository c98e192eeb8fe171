#include "edit/reach.h"

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>

#include "net/measures.h"

namespace chebnet {

namespace {

bool are_joined(const Topology& topology, int a, int b) {
    const std::span<const int> neighbours = topology.neighbours(a);
    return std::binary_search(neighbours.begin(), neighbours.end(), b);
}

bool is_out_of_reach(const UnreachablePair& pair, const Topology& topology, double threshold) {
    // At best a path pulled straight has the same ratio in all its edges: no net has a smaller deviation.
    const bool off = !(deviation(pair.distance / pair.reach) < threshold);
    return off && (pair.distance > pair.reach || are_joined(topology, pair.vertex_a, pair.vertex_b));
}

bool are_of_the_same(const UnreachablePair& a, const UnreachablePair& b) {
    return std::minmax(a.vertex_a, a.vertex_b) == std::minmax(b.vertex_a, b.vertex_b);
}

/// A handle and what holds it back most of the vertices outside the region.
UnreachablePair worst_of_border(const Holds& holds, const Positions& positions) {
    UnreachablePair worst{0, 0, 0, 1};
    for (const auto& [vertex, origin, reach] : holds.region->border) {
        const Handle* handle = holds.handle(origin);
        if (handle == nullptr || !handle->is_pinned()) continue;
        const double distance = (handle->target - positions.col(vertex)).stableNorm();
        if (distance * worst.reach > worst.distance * reach) worst = {origin, vertex, distance, reach};
    }
    return worst;
}

/// The worst first; those of one strain, in the order of their vertices.
void sort_by_strain(std::vector<UnreachablePair>& pairs) {
    const auto strain = [](const UnreachablePair& pair) {
        return std::max(pair.distance / pair.reach, pair.reach / pair.distance);
    };
    std::sort(pairs.begin(), pairs.end(), [&](const UnreachablePair& a, const UnreachablePair& b) {
        return std::tuple(-strain(a), a.vertex_a, a.vertex_b) < std::tuple(-strain(b), b.vertex_a, b.vertex_b);
    });
}

}  // namespace

std::vector<UnreachablePair> unreachable_pairs(const Holds& holds, const HandleGraph& graph, const Topology& topology,
                                               const Positions& positions, double threshold) {
    std::vector<UnreachablePair> pairs;
    const auto add = [&](const UnreachablePair& pair) {
        if (is_out_of_reach(pair, topology, threshold)) pairs.push_back(pair);
    };
    for (int i = 0; i < graph.size(); ++i)
        for (const auto& [j, reach] : graph.neighbours(i)) {
            if (j < i) continue;
            const Handle &a = holds.handles[i], &b = holds.handles[j];
            add({a.vertex, b.vertex, (a.target - b.target).stableNorm(), reach});
        }
    if (holds.region != nullptr) {
        const UnreachablePair worst = worst_of_border(holds, positions);
        const auto is_worst = [&](const UnreachablePair& pair) { return are_of_the_same(pair, worst); };
        if (std::none_of(pairs.begin(), pairs.end(), is_worst)) add(worst);
    }
    sort_by_strain(pairs);
    return pairs;
}

std::vector<Ball> reach_of(int place, const Holds& holds, const HandleGraph& graph, const Positions& positions) {
    const Handle& handle = holds.handles[place];
    if (!handle.is_pinned()) return {};
    std::vector<Ball> balls;
    for (const auto& [other, radius] : graph.neighbours(place))
        balls.push_back({holds.handles[other].vertex, holds.handles[other].target, radius});
    if (holds.region != nullptr)
        for (const auto& [held, origin, distance] : holds.region->border)
            if (origin == handle.vertex) balls.push_back({held, positions.col(held), distance});
    return balls;
}

}  // namespace chebnet
