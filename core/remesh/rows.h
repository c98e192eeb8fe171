#pragma once

#include "net/mesh.h"

namespace chebnet {

/// The same mesh of quads with one row after another, each from its beginning or, where it is closed or crosses itself,
/// from anywhere, and vertices in the order in which the faces come upon them. What is beside each other on the net is
/// so mostly beside each other in lists of it, and a link to it has half the length. The quads are wound all one way,
/// no more than two at an edge.
Mesh in_rows(const Mesh& quads);

}  // namespace chebnet
