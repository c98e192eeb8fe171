#pragma once

#include <string>

#include "net/net.h"

namespace chebnet {

/// The part that OFF and text PLY share: a line `x y z` for each vertex, with 17 digits, then for each face a line
/// with its number of vertices and these, from 0.
std::string indexed_rows(const Positions& positions, const Faces& faces);

}  // namespace chebnet
