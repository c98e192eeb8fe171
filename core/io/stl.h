#pragma once

#include <string>
#include <string_view>

#include "base/in_this_build.h"
#include "io/format.h"
#include "net/mesh.h"

namespace chebnet {

/// True if `bytes` are of the size that binary STL says it has, or begin as text STL does, with "solid".
bool is_stl(std::string_view bytes);

/// Reads binary or text STL. Corners at the very same place become one vertex, in the order in which they come; normals
/// and attributes are passed over. `name` is what messages call the file.
/// Throws Error bad_syntax, non_finite, too_large; each message is `name:line: what` of text, `name: what` of bytes.
Mesh read_stl(std::string_view bytes, std::string_view name);

/// Writes binary STL: triangles without shared vertices, coordinates as floats, so that a net does not come back as it
/// was. A quad is cut along its shorter diagonal, unless only the other leaves it without a fold; a face of more
/// vertices is cut into a fan from its first, which suits convex ones. Throws Error too_large for a coordinate beyond
/// the range of a float, bad_scale where the corners of a triangle are one as floats, which they were not.
std::string write_stl(const Positions& positions, const Faces& faces);

constexpr FormatInfo k_stl = {"stl",
                              "STL",
                              "triangles, for printing",
                              "model/stl",
                              in_this_build(is_stl),
                              in_this_build(read_stl),
                              in_this_build(write_stl),
                              nullptr};

}  // namespace chebnet
