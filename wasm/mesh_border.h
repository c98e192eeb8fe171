// Meshes, and the names of what is done with them, across the border.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "border.h"
#include "edit/editor.h"
#include "net/mesh.h"
#include "net/topology.h"

namespace chebnet {

/// The mesh of a JavaScript object with `positions`, `faceStart` and `faceVertices`, which wasm/facade.js has checked:
/// the lengths fit, and the faces begin one after the other.
Mesh mesh_in(const val& object);

/// As such an object.
val mesh_out(const Mesh& mesh);

/// An array of objects with `vertexA`, `vertexB`, `distance` and `reach`.
val pairs_out(const std::vector<UnreachablePair>& pairs);

/// The lists one after another: list k of the object is `vertices[start[k]] … vertices[start[k + 1] − 1]`.
val lists_out(const std::vector<std::vector<int>>& lists);

/// An object with `places`, `columns` and `rows`, or with `reason` and what it names.
val flat_pattern_out(const Net& net, const Topology& topology);

template <typename T>
using Names = std::vector<std::pair<std::string_view, T>>;

template <typename T>
T named(const Names<T>& names, std::string_view name, const char* what) {
    const auto found = std::find_if(names.begin(), names.end(), [&](const auto& each) { return each.first == name; });
    if (found == names.end())
        throw Error(ErrorCode::bad_option, std::string("no ") + what + " is called " + quoted(name));
    return found->second;
}

/// Throws Error bad_option for a name that wasm/chebnet.d.ts does not have.
RestLengths rest_lengths_named(std::string_view name);

}  // namespace chebnet
