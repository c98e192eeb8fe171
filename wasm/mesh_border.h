// Meshes across the border.
#pragma once

#include <vector>

#include "border.h"
#include "edit/editor.h"
#include "net/mesh.h"
#include "net/topology.h"

namespace chebnet {

/// The mesh of a JavaScript object with `positions`, `faceStart` and `faceVertices`, which wasm/facade.js has checked:
/// the lengths fit, and the faces begin one after the other.
Mesh mesh_in(const val& object);

/// As such an object.
val mesh_out(const Positions& positions, const Faces& faces);

/// An array of objects with `vertexA`, `vertexB`, `distance` and `reach`.
val pairs_out(const std::vector<UnreachablePair>& pairs);

/// The lists one after another: list k of the object is `vertices[start[k]] … vertices[start[k + 1] − 1]`.
val lists_out(const std::vector<std::vector<int>>& lists);

/// An object with `places`, `columns`, `rows` and `pieces`, or with `reason` and what it names. In file_border.cpp; for
/// chebnet_editor in left_out.cpp.
val flat_pattern_out(const Net& net, const Topology& topology);

}  // namespace chebnet
