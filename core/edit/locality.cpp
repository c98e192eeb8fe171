#include "edit/locality.h"

#include <algorithm>
#include <limits>

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

struct Nearest {
    int origin;
    double distance;  // in mean edge lengths
};

std::vector<Nearest> nearest_origins(const Net& net, const Topology& topology, std::span<const int> origins) {
    std::vector<Nearest> nearest(static_cast<std::size_t>(net.vertex_count()),
                                 {-1, std::numeric_limits<double>::infinity()});
    for (int origin : origins) {
        const std::vector<double> distance = topology.distances_from(origin);
        for (std::size_t v = 0; v < nearest.size(); ++v) {
            const double d = distance[v] / net.mean_length();
            if (d < nearest[v].distance) nearest[v] = {origin, d};
        }
    }
    return nearest;
}

}  // namespace

Region region_around(const Net& net, const Topology& topology, const Positions& positions, std::span<const int> origins,
                     double radius) {
    const std::vector<Nearest> nearest = nearest_origins(net, topology, origins);
    // Sums of lengths are as long as a whole number of edges but for their rounding.
    const auto may_move = [&](int v) { return nearest[v].distance < (1 - k_rounding) * radius; };

    Region region;
    region.radius = radius;
    region.origins.assign(origins.begin(), origins.end());
    for (int v = 0; v < net.vertex_count(); ++v) {
        const auto [origin, distance] = nearest[v];
        if (may_move(v)) {
            const bool in_zone = distance > radius / 2;
            if (in_zone) region.holds.push_back({v, positions.col(v), falloff_weight(distance, radius)});
            continue;
        }
        region.outside.push_back(v);
        const std::span<const int> neighbours = topology.neighbours(v);
        if (std::any_of(neighbours.begin(), neighbours.end(), may_move))
            region.border.push_back({v, origin, distance * net.mean_length()});
    }
    return region;
}

}  // namespace chebnet
