#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "command.h"
#include "io/format.h"

namespace {

using namespace chebnet;

/// CLI11 names what it did not expect from the last to the first, and a misspelt subcommand among it.
std::string unexpected(const CLI::App& program) {
    const std::vector<std::string> all = program.remaining(true);
    if (program.get_subcommands().empty() && !all.empty() && !all[0].starts_with('-')) {
        std::string known;
        for (const CLI::App* command : program.get_subcommands({}))
            known.append(known.empty() ? "" : ", ").append(command->get_name());
        return "there is no subcommand " + chebnet::quoted(all[0]) + "; known are " + known;
    }
    std::string list;
    for (const std::string& argument : all) list.append(" ").append(argument);
    return "not expected:" + list + " (see chebnet --help)";
}

int run(int argc, char** argv) {
    CLI::App program("Editor for discrete Chebyshev nets: nets of edges that keep their length.", "chebnet");
    program.set_version_flag("--version", "chebnet " CHEBNET_VERSION);
    program.require_subcommand(0, 1);  // that one is there is checked below, so that a misspelt one is named
    program.footer("A NET is a file (" + titles_read("or") +
                   "), or a recipe such as dome or vault:vertices=4000 (see chebnet make --list).\n"
                   "Exit codes: 0 done, every edge with its length, also where it ends exact, max_iterations or\n"
                   "stalled: not at rest, or with corners sharper than the limit, which is told; 1 not reached, 2 bad "
                   "usage or input.");
    const Command commands[] = {add_info(program),   add_make(program),  add_convert(program),
                                add_solve(program),  add_drag(program),  add_equalize(program),
                                add_change(program), add_drape(program), add_remesh(program)};
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help_or_version) {
        return program.exit(help_or_version);
    } catch (const CLI::ExtrasError&) {
        throw Error(ErrorCode::bad_option, unexpected(program));
    }
    for (const Command& command : commands)
        if (command.arguments->parsed()) return command.run();
    throw CLI::RequiredError("A subcommand (see chebnet --help)");
}

/// Names and values from the command line may hold line breaks; an error is one line whatever they hold.
std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return std::iscntrl(c); }, ' ');
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "chebnet: " << one_line(error.what()) << '\n';
        return k_bad_input;
    }
}
