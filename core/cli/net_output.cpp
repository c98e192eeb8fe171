#include "net_output.h"

#include "base/error.h"
#include "io/file.h"
#include "io/mesh_file.h"

namespace chebnet {
namespace {

FileFormat format_of(const NetOutput& output) {
    const FileFormat format = format_of_name(output.path);
    if (!output.text) return format;
    if (format == FileFormat::stl)
        throw Error(ErrorCode::bad_option, output.path + ": STL is written as binary only, not as --text");
    return format == FileFormat::ply ? FileFormat::ply_text : format;
}

}  // namespace

CLI::Option* add_net_output(CLI::App& command, const std::string& name, NetOutput& output) {
    command.add_flag("--text", output.text, "Write PLY as text rather than binary");
    command.callback([&output] { format_of(output); });
    return command.add_option(name, output.path, "File to write: .obj, .ply, .off or .stl");
}

void write_net(const NetOutput& output, const Positions& positions, const Faces& faces) {
    if (!output.path.empty()) write_file(output.path, write_mesh(positions, faces, format_of(output)));
}

}  // namespace chebnet
