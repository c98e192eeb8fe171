#pragma once

#include <span>
#include <string>
#include <string_view>

#include "net/mesh.h"

namespace chebnet {

using WriteMesh = std::string(const Positions& positions, const Faces& faces);

/// One line of the table of formats: for choosing reader and writer, for error messages, for the help of the command
/// line, and for the page's file picker and export menu. A line is defined in the header of its format, e.g. io/off.h.
/// Every format is read and written.
struct FormatInfo {
    const char* name;        ///< by which programs ask for it; behind a dot, the extension of its files
    const char* title;       ///< for people
    const char* sentence;    ///< what it is for, or how it writes a net: a few words beside its title
    const char* media_type;  ///< as browsers call it

    // Null in a build that has the table's texts only.
    bool (*begins)(std::string_view bytes);  ///< whether a file begins as only this format does; null: unknown
    Mesh (*read)(std::string_view bytes, std::string_view name);
    WriteMesh* write;       ///< binary if it can be
    WriteMesh* write_text;  ///< null: it is always binary
};

/// In the order of menus and help.
std::span<const FormatInfo> format_table();
/// Throws Error bad_option, naming the known formats.
const FormatInfo& find_format(std::string_view name);

/// For sentences, with `conjunction` before the last: the titles of all, "OBJ, PLY, OFF and STL".
std::string titles_read(std::string_view conjunction);
/// Likewise the titles of those that are written as binary unless text is asked for, "PLY".
std::string titles_binary_or_text(std::string_view conjunction);
/// Likewise the extensions of all, ".obj, .ply, .off or .stl".
std::string extensions_written(std::string_view conjunction);

}  // namespace chebnet
