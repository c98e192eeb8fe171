#pragma once

#include <string>
#include <string_view>

#include "base/in_this_build.h"
#include "io/format.h"
#include "net/mesh.h"

namespace chebnet {

/// True if `bytes` begin as an OFF file does: behind comments, a line that begins with OFF, COFF, NOFF or the like.
bool is_off(std::string_view bytes);

/// Reads OFF text (Geomview), one vertex or face a line. Faces keep their arity and order, vertices their order.
/// Understands comments, counts on the line of OFF or behind it, and none of the first line; OFF with colours, normals
/// and textures (COFF, NOFF, STOFF and their combinations), which are passed over, as are colours of faces.
/// `name` is what messages call the text. Refuses binary OFF and coordinates in other than three dimensions.
/// Throws Error bad_syntax, index_out_of_range, small_face, non_finite, too_large; each message is `name:line: what`.
Mesh read_off(std::string_view text, std::string_view name);

/// Writes OFF text with 17 digits, which return every coordinate exactly. As most programs do it leaves the count of
/// edges at 0.
std::string write_off(const Positions& positions, const Faces& faces);

constexpr FormatInfo k_off = {"off",
                              "OFF",
                              "plain text",
                              "text/plain",
                              in_this_build(is_off),
                              in_this_build(read_off),
                              in_this_build(write_off),
                              in_this_build(write_off)};

}  // namespace chebnet
