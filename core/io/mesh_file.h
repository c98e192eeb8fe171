#pragma once

#include <string>
#include <string_view>

#include "net/mesh.h"

namespace chebnet {

/// How a mesh is written.
enum class FileFormat {
    obj,
    ply,       ///< binary, little endian
    ply_text,  ///< the same, readable
    off,
    stl,  ///< binary, triangles
};

/// True if `name` ends in an extension of a mesh file: .obj, .ply, .off or .stl, in either case.
bool has_mesh_extension(std::string_view name);

/// The format in which a file of that name is written, by its extension; without one, OBJ. PLY is binary. Throws Error
/// bad_option for an unknown extension.
FileFormat format_of_name(std::string_view name);

/// Reads a file whatever its format, see read_obj, read_ply and read_off. What the bytes begin with decides between
/// them before the extension of `name` does, by which messages call the file. STL, which has no vertices shared between
/// faces, is refused, and so is, by what it is, a file that is plainly something else (see other_format). Throws Error
/// bad_syntax, index_out_of_range, small_face, non_finite, too_large.
Mesh read_mesh(std::string_view bytes, std::string_view name);

/// The bytes of a file, see write_obj, write_ply, write_off and write_stl. All formats but STL keep faces, order and
/// every bit of a coordinate. Throws Error too_large (STL only).
std::string write_mesh(const Positions& positions, const Faces& faces, FileFormat format);

}  // namespace chebnet
