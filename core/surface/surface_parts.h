#pragma once

#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// Some triangles of a surface, as one of their own.
struct SurfacePart {
    Surface surface;
    std::vector<int> vertices;  ///< of each vertex its number in the whole; where triangles touch at a vertex only the
                                ///< part has more of them, behind these
};

/// Parts of a surface, `part` being for each triangle the number of its part, from 0 to `count` − 1, or −1: it is in
/// none. Triangles keep their order, and vertices are in that of the triangles. Throws Error no_faces for a part
/// without triangles.
std::vector<SurfacePart> parts_of(const Surface& surface, const std::vector<int>& part, int count);

/// Each piece as a surface of its own, in the order of Surface::components().
std::vector<Surface> pieces_of(const Surface& surface);

}  // namespace chebnet
