#include "io/mesh_file.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "io/file.h"
#include "io/obj.h"
#include "io/other_format.h"
#include "io/stl.h"

namespace chebnet {

namespace {

/// The extension of a file, in lower case and without its dot; empty if there is none.
std::string extension_of(std::string_view name) {
    name.remove_prefix(name.find_last_of("/\\") + 1);  // npos + 1 is 0
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos || dot == 0) return "";
    std::string extension(name.substr(dot + 1));
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return extension;
}

/// True if a line of `bytes` is a vertex as OBJ has it.
bool has_obj_vertex(std::string_view bytes) {
    for (Lines lines(bytes); !lines.at_end();) {
        std::string_view line = lines.take();
        if (take_word(line) == "v") return true;
    }
    return false;
}

/// The format of the table whose files have that extension, or null.
const FormatInfo* format_with(std::string_view extension) {
    for (const FormatInfo& format : format_table())
        if (extension == format.name) return &format;
    return nullptr;
}

/// Null if its bytes do not tell. A binary STL file may begin with anything, but is as long as it says: that comes
/// first.
const FormatInfo* format_of_bytes(std::string_view bytes) {
    const auto is_told = [&](const FormatInfo& format) { return format.begins != nullptr && format.begins(bytes); };
    if (is_told(k_stl)) return &find_format(k_stl.name);
    for (const FormatInfo& format : format_table())
        if (is_told(format)) return &format;
    return nullptr;
}

/// Of a file whose bytes do not tell; null if its name does not either.
const FormatInfo* format_of_file(std::string_view bytes, std::string_view name) {
    if (const FormatInfo* format = format_with(extension_of(name))) return format;
    return has_obj_vertex(bytes) ? &find_format(k_obj.name) : nullptr;
}

[[noreturn]] void fail(ErrorCode code, std::string_view name, const std::string& what) {
    throw Error(code, std::string(name) + ": " + what);
}

}  // namespace

bool has_mesh_extension(std::string_view name) { return format_with(extension_of(name)) != nullptr; }

const FormatInfo& format_of_name(std::string_view name) {
    const std::string extension = extension_of(name);
    if (const FormatInfo* format = format_with(extension.empty() ? k_obj.name : extension)) return *format;
    fail(ErrorCode::bad_option, name,
         "nets are written as " + extensions_written("or") + ", not as " + quoted("." + extension));
}

Mesh read_mesh(std::string_view bytes, std::string_view name) {
    if (bytes.size() > k_max_file_bytes) fail(ErrorCode::too_large, name, "larger than 1 GiB");
    const FormatInfo* format = format_of_bytes(bytes);
    const auto other = format == nullptr ? other_format(bytes) : std::nullopt;
    if (other)
        fail(ErrorCode::bad_syntax, name,
             "this is " + std::string(*other) + "; meshes are read from " + titles_read("and"));
    if (format == nullptr) format = format_of_file(bytes, name);
    if (format == nullptr)
        fail(ErrorCode::bad_syntax, name, "not a mesh of a format that is read, which are " + titles_read("and"));
    return format->read(bytes, name);
}

}  // namespace chebnet
