#pragma once

#include <string_view>

#include "io/format.h"

namespace chebnet {

/// True if `name` ends in the extension of a format of the table, in either case.
bool has_mesh_extension(std::string_view name);

/// The format in which a file of that name is written, by its extension; without one, OBJ. Throws Error bad_option for
/// an unknown extension.
const FormatInfo& format_of_name(std::string_view name);

/// Reads a file whatever its format (io/format.h). What the bytes begin with decides between them before the extension
/// of `name` does, by which messages call the file; a file that neither decides is OBJ if it has a vertex of OBJ. One
/// of a format that is not read is refused, and so is, by what it is, a file that is plainly something else (see
/// other_format). Throws Error bad_syntax, index_out_of_range, small_face, non_finite, too_large.
Mesh read_mesh(std::string_view bytes, std::string_view name);

}  // namespace chebnet
