#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>

#include "drape/drape.h"
#include "drape/surface_report.h"
#include "report.h"
#include "surface/guide.h"
#include "surface/surface.h"

namespace chebnet {

/// Which surface a net is made on: of a file, or one of our own.
struct SurfaceArgument {
    std::string file, own;
    bool repair = false;
};

/// Declares the positional argument SURFACE, --surface and --repair.
void add_surface_argument(CLI::App& command, SurfaceArgument& argument);

/// Throws Error, also if both or none are given; what concerns a file begins with its path.
Surface load_surface(const SurfaceArgument& argument);

/// A surface beside a net: one of our own if it is called so, else that of a file. Throws Error.
std::shared_ptr<const Guide> load_guide(const std::string& name, bool repair = false);

std::string name_of(const SurfaceArgument& argument);

Json surface_report(const SurfaceReport& surface);

/// The net, and how it lies on its surface.
Json net_on_surface_report(const Net& net, const DrapeReport& measured);

}  // namespace chebnet
