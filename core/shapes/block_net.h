#pragma once

#include "shapes/family.h"

namespace chebnet {

/// A net of oblong faces with their sides along the axes, and a place in space for each of its vertices.
struct BlockNet {
    Mesh blocks;          ///< its positions are lattice points
    Positions positions;  ///< where they are now
};

/// Cuts every face that is longer than `longest` cells in two, along either axis, and puts new vertices between old
/// ones.
BlockNet cut(const BlockNet& net, int longest);

}  // namespace chebnet
