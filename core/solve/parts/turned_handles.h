#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/parts/held_vertices.h"

namespace chebnet {

/// Exact handles that are joined by edges and turn together, as a rim that is twisted: straight ways would shorten the
/// edges between them, and no net could follow. Each group turns about its middle, which goes straight, and changes its
/// shape evenly on the way.
class TurnedHandles {
public:
    /// Among what is held and moves between these places (3×V). Null: none.
    static std::shared_ptr<const TurnedHandles> find(const Topology& topology, const HeldVertices& held,
                                                     const Positions& from, const Positions& to);

    /// What they have to move, from where they are `now`, to be this part of their way: columns of `moves` (3×V).
    void go(double part, const Positions& from, const Positions& to, const Positions& now,
            Eigen::Matrix3Xd& moves) const;

private:
    struct Group {
        std::vector<int> vertices;
        Eigen::Vector3d from_middle, to_middle;
        Eigen::AngleAxisd turn;
    };
    static Group group_of(std::vector<int> vertices, const Positions& from, const Positions& to);

    std::vector<Group> m_groups;
};

}  // namespace chebnet
