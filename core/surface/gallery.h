#pragma once

#include <span>
#include <string_view>

#include "surface/surface.h"

namespace chebnet {

/// A surface of our own to make nets on, so that this can be tried without a file.
struct OwnSurface {
    const char* name;      ///< by which programs ask for it
    const char* title;     ///< for people
    const char* sentence;  ///< what it is, and what a net does on it
    Surface (*make)();     ///< of a few thousand triangles, some units wide, z being up
};

/// In the order of menus and help.
std::span<const OwnSurface> own_surfaces();
/// Throws Error bad_option, naming the known ones.
Surface make_own_surface(std::string_view name);

}  // namespace chebnet
