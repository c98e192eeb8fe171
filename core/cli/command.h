#pragma once

#include <CLI/App.hpp>
#include <functional>

namespace chebnet {

/// What the program tells its caller. Every error, of usage or of input, is k_bad_input with one line on stderr.
inline constexpr int k_success = 0, k_not_converged = 1, k_bad_input = 2;

/// One subcommand: what it accepts, and what it does once the command line has been read. `run` returns the exit code
/// and throws Error.
struct Command {
    CLI::App* arguments;
    std::function<int()> run;
};

Command add_info(CLI::App& program);
Command add_make(CLI::App& program);
Command add_convert(CLI::App& program);
Command add_solve(CLI::App& program);
Command add_drag(CLI::App& program);
Command add_equalize(CLI::App& program);
Command add_change(CLI::App& program);
Command add_drape(CLI::App& program);
Command add_remesh(CLI::App& program);

}  // namespace chebnet
