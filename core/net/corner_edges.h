#pragma once

#include <vector>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// For each corner of each face, in the order of Faces::vertices, the edge from there to the face's next corner.
std::vector<int> corner_edges(const Net& net, const Topology& topology);

/// The corner of its face that comes after, and the one before, both in the order of Faces::vertices.
int corner_after(const Faces& faces, int face, int corner);
int corner_before(const Faces& faces, int face, int corner);

}  // namespace chebnet
