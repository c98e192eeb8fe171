#pragma once

#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/hold.h"

namespace chebnet {

/// The part of a net that may move with one vertex, by distance d along the net (Topology::distances_from) and the
/// radius R: vertices with d ≥ R are fixed; the outer half of the others is held where it stands, with weights that rise
/// smoothly from 0 at d = R/2.
struct Region {
    /// A fixed vertex with a neighbour that may move.
    struct BorderVertex {
        int vertex;
        double distance;  ///< along the net from the origin
    };

    int origin;
    std::vector<int> outside;  ///< the fixed vertices, ascending
    std::vector<BorderVertex> border;
    std::vector<Hold> holds;  ///< ascending by vertex
};

/// `radius`: in mean edge lengths, above 0. `positions`: 3×V, where the net stands. The origin itself always may move.
Region region_around(const Net& net, const Topology& topology, const Positions& positions, int origin, double radius);

}  // namespace chebnet
