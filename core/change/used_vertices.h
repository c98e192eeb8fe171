#pragma once

#include "change/change.h"

namespace chebnet {

/// These faces over the vertices of the net, which stay where they are; those that no face uses go.
ChangedMesh with_vertices_of(const Faces& faces, const Net& net);

}  // namespace chebnet
