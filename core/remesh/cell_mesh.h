#pragma once

#include <vector>

#include "net/mesh.h"
#include "remesh/cells.h"

namespace chebnet {

/// The mesh of quads that cells make, tidied: cells are collapsed along a diagonal, so that its two ends become one
/// vertex, where an inner vertex has less than three edges, and wherever that makes vertices more regular (Daniels et
/// al., Quadrilateral Mesh Simplification, 2008). One or two cells that hang by one side at the border, in a row, or
/// by none are left out, unless they are all there is of a piece of the surface. Each vertex stands in the middle of
/// where its cells would have it. What it is to be, a manifold without repeated edges, is left to Net to check.
Mesh mesh_of(const Cells& cells);

}  // namespace chebnet
