#pragma once

#include <CLI/App.hpp>
#include <string>

#include "net/mesh.h"
#include "surface/surface.h"

namespace chebnet {

/// Which net, and whether what is wrong with its file is to be repaired.
struct NetArgument {
    std::string name;
    bool repair = false;
};

/// Declares the positional argument NET and --repair.
void add_net_argument(CLI::App& command, NetArgument& argument);

/// Declares --repair: every defect that net/repair.h knows.
void add_repair_argument(CLI::App& command, bool& repair);

/// The net that NET names: a file if one of that name exists or it ends like one (io/format.h), a recipe
/// otherwise. Repairs are told on standard error. Throws Error; the message begins with the name.
Net load_net(const NetArgument& argument);

/// Says on standard error how many vertices stand at the place of an earlier one, if any do, and returns their number:
/// faces that share no vertices are not joined, however near they lie. Said only, for where a net or a surface is cut
/// open they should coincide.
int tell_coinciding(const Mesh& mesh, const std::string& name);

/// The surface in a file, repaired if asked for. Throws Error; the message begins with the path.
Surface load_surface(const std::string& path, bool repair);

/// The mesh in a file, sound or not, repaired if asked for; repairs are told on standard error. Throws Error; the
/// message begins with the path.
Mesh load_mesh(const std::string& path, bool repair);

}  // namespace chebnet
