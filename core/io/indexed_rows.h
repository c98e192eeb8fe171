#pragma once

#include <string>

#include "net/net.h"

namespace chebnet {

/// What OFF and PLY as text have in common: a line `x y z` for each vertex, with 17 digits, then for each face a line
/// with its number of vertices and these, from 0.
std::string indexed_rows(const Positions& positions, const Faces& faces);

}  // namespace chebnet
