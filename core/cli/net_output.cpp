#include "net_output.h"

#include <filesystem>
#include <set>

#include "base/error.h"
#include "io/file.h"
#include "io/mesh_file.h"

namespace chebnet {
namespace {

WriteMesh* writer_of(const NetOutput& output) {
    const FormatInfo& format = format_of_name(output.path);
    if (!output.text) return format.write;
    if (format.write_text == nullptr)
        throw Error(ErrorCode::bad_option,
                    output.path + ": " + format.title + " is written as binary only, not as --text");
    return format.write_text;
}

}  // namespace

CLI::Option* add_net_output(CLI::App& command, const std::string& name, NetOutput& output) {
    command.add_flag("--text", output.text, "Write " + titles_binary_or_text("and") + " as text rather than binary");
    command.callback([&output] { writer_of(output); });
    return command.add_option(name, output.path, "File to write: " + extensions_written("or"));
}

void check_apart(const std::vector<std::string>& files) {
    std::set<std::filesystem::path> written;
    for (const std::string& file : files)
        if (!file.empty() && !written.insert(std::filesystem::path(file).lexically_normal()).second)
            throw Error(ErrorCode::bad_option, file + ": is to be written twice, for different things");
}

void write_net(const NetOutput& output, const Positions& positions, const Faces& faces) {
    if (!output.path.empty()) write_file(output.path, writer_of(output)(positions, faces));
}

}  // namespace chebnet
