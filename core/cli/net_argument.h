#pragma once

#include <CLI/App.hpp>
#include <string>

#include "net/net.h"

namespace chebnet {

/// Declares the positional argument NET.
void add_net_argument(CLI::App& command, std::string& name);

/// The net that NET names: a file if one of that name exists or it ends in .obj, a recipe otherwise. Throws Error; the
/// message begins with the name.
Net load_net(const std::string& name);

}  // namespace chebnet
