#pragma once

#include <string>
#include <string_view>

#include "base/in_this_build.h"
#include "io/format.h"
#include "net/mesh.h"

namespace chebnet {

/// Reads Wavefront OBJ text. Faces keep their arity and order, vertices their order. Understands `v x y z [w …]`,
/// `f v`, `f v/vt`, `f v//vn`, `f v/vt/vn`, negative (relative) indices, comments, line continuation by a backslash, LF
/// and CRLF; other statements (vt, vn, g, o, s, usemtl, …) are passed over, curves and surfaces (`curv`, `surf`, …) and
/// polylines (`l`) and points (`p`) too. `name` is what messages call the text.
/// Throws Error bad_syntax, index_out_of_range, small_face, non_finite, too_large; each message is `name:line: what`.
Mesh read_obj(std::string_view text, std::string_view name);

/// Writes OBJ text, one `v` line a vertex and one `f` line a face, in order; where there are several pieces, each is a
/// group, "g piece_1" and so on, by their first faces. `digits` significant digits, 1 … 17;
/// 17 returns every coordinate exactly. Throws Error bad_option for another number of digits.
std::string write_obj(const Positions& positions, const Faces& faces, int digits);
/// With 17 digits.
inline std::string write_obj(const Positions& positions, const Faces& faces) { return write_obj(positions, faces, 17); }

constexpr FormatInfo k_obj = {"obj",
                              "OBJ",
                              "for Rhino and Blender",
                              "model/obj",
                              nullptr,
                              in_this_build(read_obj),
                              in_this_build<WriteMesh>(write_obj),
                              in_this_build<WriteMesh>(write_obj)};

}  // namespace chebnet
