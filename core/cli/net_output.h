#pragma once

#include <CLI/App.hpp>
#include <string>

#include "net/net.h"

namespace chebnet {

/// Where a net is written, and how.
struct NetOutput {
    std::string path;  ///< its extension says the format; empty: nothing is written
    bool text = false;
};

/// Declares the argument `name`, such as "-o,--output", and --text. Extensions that cannot be written are refused as
/// soon as the command line is read, before any work is done for nothing.
CLI::Option* add_net_output(CLI::App& command, const std::string& name, NetOutput& output);

/// Throws Error file_access, too_large.
void write_net(const NetOutput& output, const Positions& positions, const Faces& faces);

}  // namespace chebnet
