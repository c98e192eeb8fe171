#pragma once

#include "change/change.h"

namespace chebnet {

/// Vertices on the border that lie within half an edge of each other become one, the first of them, in their middle:
/// two borders are joined, of one piece or of two, the inverse of a cut. Faces that then turn against the rest of their
/// piece are turned round. The place does not matter. Throws Error impossible_change where no borders are so near, and
/// where they do not fit together.
ChangedMesh joined(const Net& net, const ChangePlace& place);

}  // namespace chebnet
