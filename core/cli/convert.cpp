#include <memory>

#include "command.h"
#include "io/format.h"
#include "net_argument.h"
#include "net_output.h"

namespace chebnet {
namespace {

struct ConvertArguments {
    std::string input;
    bool repair = false;
    NetOutput output;
};

int run_convert(const ConvertArguments& arguments) {
    const Mesh mesh = load_mesh(arguments.input, arguments.repair);
    write_net(arguments.output, mesh.positions, mesh.faces);
    return k_success;
}

}  // namespace

Command add_convert(CLI::App& program) {
    CLI::App& command = *program.add_subcommand("convert", "Write a mesh, sound or not, in another format");
    const auto arguments = std::make_shared<ConvertArguments>();
    command.add_option("IN", arguments->input, "File to read: " + titles_read("or"))->required()->type_name("");
    add_net_output(command, "OUT", arguments->output)->required()->type_name("");
    add_repair_argument(command, arguments->repair);
    return {&command, [arguments] { return run_convert(*arguments); }};
}

}  // namespace chebnet
