#include "edit/locality.h"

#include <algorithm>

namespace chebnet {

namespace {

// The weight of an edge: there a pull's influence ends about one edge away from it.
constexpr double k_most_weight = 1;
constexpr double k_within = 1e-9;

/// How firmly a vertex is held so many edges away: 0 up to half the radius, 1 from the radius on.
double firmness(double edges_away, double radius) {
    // Sums of lengths are as long as a whole number of edges but for their rounding.
    if (edges_away >= (1 - k_within) * radius) return 1;
    const double zone = radius / 2;
    return std::max(0.0, (edges_away - zone) / zone);
}

/// Where the influence of a pull ends 1/√w edges away, this one's ends (1 − s)/s parts of the zone's width from it.
double falloff_weight(double s, double radius) {
    const double zone = radius / 2;
    const double steepness = s / ((1 - s) * zone);
    return std::min(steepness * steepness, k_most_weight);
}

}  // namespace

Eigen::VectorXf mobility(const Net& net, const Topology& topology, std::span<const int> origins, double radius) {
    const std::vector<NearestSource> nearest = topology.nearest_sources(origins);
    Eigen::VectorXf mobility(net.vertex_count());
    for (int v = 0; v < net.vertex_count(); ++v)
        mobility[v] = static_cast<float>(1 - firmness(nearest[v].distance / net.mean_length(), radius));
    return mobility;
}

Region region_around(const Net& net, const Topology& topology, const Positions& positions, std::span<const int> origins,
                     double radius) {
    const std::vector<NearestSource> nearest = topology.nearest_sources(origins);
    const auto firmness_at = [&](int v) { return firmness(nearest[v].distance / net.mean_length(), radius); };
    const auto may_move = [&](int v) { return firmness_at(v) < 1; };

    Region region;
    region.radius = radius;
    region.origins.assign(origins.begin(), origins.end());
    for (int v = 0; v < net.vertex_count(); ++v) {
        if (may_move(v)) {
            const double s = firmness_at(v);
            if (s > 0) region.pulls.push_back({v, positions.col(v), falloff_weight(s, radius)});
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
