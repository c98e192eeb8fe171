// Meshes, and the names of what is done with them, across the border.
#pragma once

#include <string_view>
#include <vector>

#include "border.h"
#include "edit/editor.h"
#include "io/mesh_file.h"
#include "net/mesh.h"

namespace chebnet {

/// The mesh of a JavaScript object with `positions`, `faceStart` and `faceVertices`, which wasm/chebnet.js has checked:
/// the lengths fit, and the faces begin one after the other.
Mesh mesh_in(const val& object);

/// An array of objects with `vertexA`, `vertexB`, `distance` and `reach`.
val pairs_out(const std::vector<UnreachablePair>& pairs);

/// Throw Error bad_option for a name that wasm/chebnet.d.ts does not have.
FileFormat file_format_named(std::string_view name);
RestLengths rest_lengths_named(std::string_view name);

}  // namespace chebnet
