#pragma once

#include <optional>
#include <vector>

#include "net/net.h"

namespace chebnet {

/// The two families of net lines, as warp and weft of a cloth: opposite edges of a quad are of one family, adjacent
/// ones of both. E, 0 for the family of the net's first edge, 1 for the other. Every further piece has them as that
/// edge's has: the family that has the first and third sides of most quads is the same, where neither has, that of its
/// first quad. So nets whose quads all begin alike keep their families where they are cut. None where a face is no
/// quad, or where that contradicts itself, as around an inner vertex at which an odd number of edges meets.
std::optional<std::vector<int>> edge_families(const Net& net);

}  // namespace chebnet
