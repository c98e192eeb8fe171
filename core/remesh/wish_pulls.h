#pragma once

#include <vector>

#include "net/mesh.h"
#include "remesh/singular_wishes.h"
#include "solve/pull.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// What draws the vertices of a mesh of quads for wishes: of the singular vertices wished for, those that stand for
/// them, each towards its point; others near a forbidden region to where they are; and all of these clear of such
/// regions. `tree`: of the surface that was wished for; `cell`: the length of cells.
std::vector<Pull> wish_pulls(const Mesh& mesh, const SingularWishes& wishes, const SurfaceTree& tree, double cell);

}  // namespace chebnet
