#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

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

/// Throws Error bad_option where two of these files, empty where none is written, are the same: one would replace the
/// other.
void check_apart(const std::vector<std::string>& files);

/// Throws Error file_access, too_large.
void write_net(const NetOutput& output, const Positions& positions, const Faces& faces);

}  // namespace chebnet
