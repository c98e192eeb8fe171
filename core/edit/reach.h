#pragma once

#include <Eigen/Core>
#include <vector>

#include "edit/handle_graph.h"
#include "edit/holds.h"
#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// Two vertices that no net can hold: they are to stand farther apart than the net between them is long.
struct UnreachablePair {
    int vertex_a, vertex_b;  ///< exact handles; b may also be a vertex outside the region that may move
    double distance;         ///< between where they are to stand
    double reach;            ///< length of the shortest path along edges between the vertices
};

/// The points no farther than `radius` from `centre`, where a vertex is held.
struct Ball {
    int vertex;
    Eigen::Vector3d centre;
    double radius;
};

/// See Editor::unreachable_pairs(). `graph`: of these handles; `positions`: 3×V, where the net stands; `threshold`: the
/// largest dL of a net.
std::vector<UnreachablePair> unreachable_pairs(const Holds& holds, const HandleGraph& graph, const Topology& topology,
                                               const Positions& positions, double threshold);
/// See Editor::reach(): of the handle at this place.
std::vector<Ball> reach_of(int place, const Holds& holds, const HandleGraph& graph, const Positions& positions);

}  // namespace chebnet
