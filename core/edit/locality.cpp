#include "edit/locality.h"

#include <algorithm>

namespace chebnet {

namespace {

// The weight of an edge: there a hold's influence ends about one edge away from it.
constexpr double k_most_weight = 1;
constexpr double k_rounding = 1e-9;

/// Where the influence of a hold ends 1/√w edges away, this one's ends s/(1 − s) parts of the zone's width from it.
double falloff_weight(double d, double radius) {
    const double zone = radius / 2, s = (d - zone) / zone;
    const double steepness = s / ((1 - s) * zone);
    return std::min(steepness * steepness, k_most_weight);
}

}  // namespace

Region region_around(const Net& net, const Topology& topology, const Positions& positions, std::span<const int> origins,
                     double radius) {
    const std::vector<NearestSource> nearest = topology.nearest_sources(origins);
    const auto edges_away = [&](int v) { return nearest[v].distance / net.mean_length(); };
    // Sums of lengths are as long as a whole number of edges but for their rounding.
    const auto may_move = [&](int v) { return edges_away(v) < (1 - k_rounding) * radius; };

    Region region;
    region.radius = radius;
    region.origins.assign(origins.begin(), origins.end());
    for (int v = 0; v < net.vertex_count(); ++v) {
        if (may_move(v)) {
            const bool in_zone = edges_away(v) > radius / 2;
            if (in_zone) region.holds.push_back({v, positions.col(v), falloff_weight(edges_away(v), radius)});
            continue;
        }
        region.outside.push_back(v);
        const std::span<const int> neighbours = topology.neighbours(v);
        if (std::any_of(neighbours.begin(), neighbours.end(), may_move))
            region.border.push_back({v, nearest[v].source, nearest[v].distance});
    }
    return region;
}

}  // namespace chebnet
