#pragma once

#include "surface/surface.h"

namespace chebnet {

/// Refuses a surface most of which is scraps, and more than 50 of them: pieces of less than four cells, or of less than
/// 25 that touch others without being joined to them, as in a file whose triangles have vertices of their own each.
/// `cell`: its area. Throws Error too_large, with the number of pieces and the way out.
void check_scraps(const Surface& surface, double cell);

}  // namespace chebnet
