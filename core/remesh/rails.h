#pragma once

#include <Eigen/Core>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "remesh/fit.h"
#include "solve/pull.h"
#include "surface/segment_tree.h"
#include "surface/surface.h"

namespace chebnet {

/// Lines on the surface, and vertices of a net that are drawn to them and may slide along.
struct Rail {
    SegmentTree lines;
    std::vector<int> vertices;
};

struct WayFromRail {
    Eigen::Vector3d away = Eigen::Vector3d::Zero();   ///< from the nearest point of the lines
    Eigen::Vector3d along = Eigen::Vector3d::Zero();  ///< of length 1, the direction of the line there
};
WayFromRail way_from(const Rail& rail, const Eigen::Vector3d& point);

/// What the vertices of a mesh slide along while it is fitted to a surface.
struct Rails {
    Rail border;                ///< where that is one of the net's lines,
    Rail steps;                 ///< and where it is not: each vertex of the mesh's border is on one, but for
    std::vector<Pull> corners;  ///< those that are drawn to corners of the border,
    Rail creases;               ///< on which vertices are that nothing else draws
};
/// `mesh`: a net near the surface, edges about as long as `length`.
Rails rails_of(const Surface& surface, const Net& mesh, const Topology& topology, const FitOptions& options,
               double length);

}  // namespace chebnet
