#pragma once

#include <Eigen/Core>
#include <vector>

#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// A surface made anew of triangles whose edges are all about `length` long, with the same topology and its vertices on
/// the surface: edges are split, collapsed and flipped, vertices drawn to the middle of their neighbours (Botsch &
/// Kobbelt, A Remeshing Approach to Multiresolution Modeling, 2004). Where the surface is thinner than an edge, edges
/// are as short as its topology asks for. Vertices of the boundary stay on it.
Surface even_triangles(const Surface& surface, const SurfaceTree& tree, double length);

}  // namespace chebnet
