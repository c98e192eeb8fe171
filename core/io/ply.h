#pragma once

#include <string>
#include <string_view>

#include "base/in_this_build.h"
#include "io/format.h"
#include "net/mesh.h"

namespace chebnet {

/// True if `bytes` begin as a PLY file does, with a line `ply`.
bool is_ply(std::string_view bytes);

/// Reads PLY (Turk 1994), as text or binary in either byte order. Vertices are the element `vertex` with properties x,
/// y and z of any type, faces the element `face` with a list `vertex_indices` or `vertex_index` of any types; a file
/// without faces is a mesh without faces. Faces keep their arity and order, vertices their order. Other properties and
/// elements are passed over, and what follows the last element of a binary file. Text has one row a line and is read as
/// double whatever the type of its property. `name` is what messages call the file.
/// Throws Error bad_syntax, index_out_of_range, small_face, non_finite, too_large; each message is `name:line: what`,
/// or `name: vertex number: what` and the like within binary data, counted from 0.
Mesh read_ply(std::string_view bytes, std::string_view name);

enum class PlyEncoding { binary, text };

/// Writes PLY with vertices x y z as doubles, which keep every bit, and faces vertex_indices; binary is little endian.
std::string write_ply(const Positions& positions, const Faces& faces, PlyEncoding encoding);

inline std::string write_ply_binary(const Positions& positions, const Faces& faces) {
    return write_ply(positions, faces, PlyEncoding::binary);
}
inline std::string write_ply_text(const Positions& positions, const Faces& faces) {
    return write_ply(positions, faces, PlyEncoding::text);
}

constexpr FormatInfo k_ply = {"ply",
                              "PLY",
                              "binary, every digit",
                              "application/octet-stream",
                              in_this_build(is_ply),
                              in_this_build(read_ply),
                              in_this_build(write_ply_binary),
                              in_this_build(write_ply_text)};

}  // namespace chebnet
