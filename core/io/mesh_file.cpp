#include "io/mesh_file.h"

#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "io/file.h"
#include "io/obj.h"
#include "io/off.h"
#include "io/other_format.h"
#include "io/ply.h"
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

[[noreturn]] void fail(ErrorCode code, std::string_view name, const std::string& what) {
    throw Error(code, std::string(name) + ": " + what);
}

}  // namespace

bool has_mesh_extension(std::string_view name) {
    const std::string extension = extension_of(name);
    return extension == "obj" || extension == "ply" || extension == "off" || extension == "stl";
}

FileFormat format_of_name(std::string_view name) {
    const std::string extension = extension_of(name);
    if (extension == "obj" || extension.empty()) return FileFormat::obj;
    if (extension == "ply") return FileFormat::ply;
    if (extension == "off") return FileFormat::off;
    if (extension == "stl") return FileFormat::stl;
    fail(ErrorCode::bad_option, name,
         "nets are written as .obj, .ply, .off or .stl, not as " + quoted("." + extension));
}

Mesh read_mesh(std::string_view bytes, std::string_view name) {
    if (bytes.size() > k_max_file_bytes) fail(ErrorCode::too_large, name, "larger than 1 GiB");
    if (const auto other = other_format(bytes))
        fail(ErrorCode::bad_syntax, name, "this is " + std::string(*other) + "; meshes are read from OBJ, PLY and OFF");
    const std::string extension = extension_of(name);
    if (is_ply(bytes) || extension == "ply") return read_ply(bytes, name);
    if (is_off(bytes) || extension == "off") return read_off(bytes, name);
    if (extension == "stl") fail(ErrorCode::bad_syntax, name, "STL holds loose triangles, no net; it is only written");
    if (extension == "obj" || has_obj_vertex(bytes)) return read_obj(bytes, name);
    fail(ErrorCode::bad_syntax, name, "not a mesh of a format that is read, which are OBJ, PLY and OFF");
}

std::string write_mesh(const Positions& positions, const Faces& faces, FileFormat format) {
    switch (format) {
        case FileFormat::obj:
            break;
        case FileFormat::ply:
            return write_ply(positions, faces, PlyEncoding::binary);
        case FileFormat::ply_text:
            return write_ply(positions, faces, PlyEncoding::text);
        case FileFormat::off:
            return write_off(positions, faces);
        case FileFormat::stl:
            return write_stl(positions, faces);
    }
    return write_obj(positions, faces);
}

}  // namespace chebnet
