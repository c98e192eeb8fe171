#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/pull.h"

namespace chebnet {

/// The part of a net that may move with some vertices, by the distance d along the net (Topology::nearest_sources) from
/// the nearest of them and the radius R: vertices with d ≥ R are fixed; the outer half of the others is held where it
/// stands, with weights that rise smoothly from 0 at d = R/2.
struct Region {
    /// A fixed vertex with a neighbour that may move.
    struct BorderVertex {
        int vertex;
        int origin;       ///< the nearest
        double distance;  ///< along the net from there
    };

    double radius = 0;         ///< in mean edge lengths
    std::vector<int> origins;  ///< the vertices it moves with
    std::vector<int> outside;  ///< the fixed vertices, ascending
    std::vector<BorderVertex> border;
    std::vector<Pull> pulls;

    bool is_outside(int vertex) const { return std::binary_search(outside.begin(), outside.end(), vertex); }
};

/// V, how freely each vertex would move in such a region: 1 up to half the radius, falling evenly to 0 where all is
/// fixed. Where the pull of a vertex has the weight w < 1, it is 1 / (1 + √w R/2): the reach 1/√w of the pull's
/// influence, as part of itself and the zone.
Eigen::VectorXf mobility(const Net& net, const Topology& topology, std::span<const int> origins, double radius);

/// `radius`: in mean edge lengths, above 0. `positions`: 3×V, where the net stands. The origins themselves may move.
Region region_around(const Net& net, const Topology& topology, const Positions& positions, std::span<const int> origins,
                     double radius);

}  // namespace chebnet
