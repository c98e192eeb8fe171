#pragma once

#include "net/net.h"

namespace chebnet {

/// Positions and faces as a file gives them, before a Net has checked them.
struct Mesh {
    Positions positions;
    Faces faces;
};

}  // namespace chebnet
