#pragma once

#include <string>

#include "base/in_this_build.h"
#include "io/format.h"
#include "net/net.h"

namespace chebnet {

/// Writes binary STL: triangles without shared vertices, coordinates as floats, so that it is for printing and the
/// like, not for reading back. A quad is cut along its shorter diagonal, unless only the other leaves it without a
/// fold; a face of more vertices is cut into a fan from its first, which suits convex ones. Throws Error too_large for
/// a coordinate beyond the range of a float.
std::string write_stl(const Positions& positions, const Faces& faces);

constexpr FormatInfo k_stl = {"stl",   "STL",   "triangles, for printing", "model/stl", "holds loose triangles, no net",
                              nullptr, nullptr, in_this_build(write_stl),  nullptr};

}  // namespace chebnet
