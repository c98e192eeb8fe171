#pragma once

#include "net/mesh.h"

namespace chebnet {

/// Throws Error impossible_change where an edge has more than two faces, or two faces lie on each other: rows that
/// close after few faces close after none once every other line is gone.
void check_not_folded(const Faces& faces);

}  // namespace chebnet
