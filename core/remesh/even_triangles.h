#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

struct EvenTriangles {
    Surface surface;
    std::vector<bool> creases;  ///< of each side
};

/// A surface made anew of triangles whose edges are all about `length` long, with the same topology and its vertices on
/// the surface: edges are split, collapsed and flipped, vertices drawn to the middle of their neighbours (Botsch &
/// Kobbelt, A Remeshing Approach to Multiresolution Modeling, 2004). Where the surface is thinner than an edge, edges
/// are as short as its topology asks for. Vertices of the boundary stay on it, and so do those of creases, of each side
/// of the surface whether it is one; none: there are none.
EvenTriangles even_triangles(const Surface& surface, const SurfaceTree& tree, double length,
                             const std::vector<bool>& creases = {});

}  // namespace chebnet
