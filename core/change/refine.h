#pragma once

#include "change/change.h"

namespace chebnet {

/// Every triangle becomes four, between the middles of its edges; every other face is parted between its middle and
/// those, a quad into two by two (Catmull and Clark 1978, the faces alone). Vertices: those of the net, the middles of
/// its edges, the middles of its faces but triangles. The old ones stay where they are; the middles of edges lie on
/// smooth curves along the net lines (Dyn, Levin and Gregory 1987), which end where a net line does or is folded; those
/// of faces on patches between these curves (Coons 1967). Of triangles alone they lie on the edges, so that all edges
/// are exact at once. Edges are to be half as long. The place does not matter. Throws Error too_large beyond 2,000,000
/// vertices, and impossible_change where a border has cut the net, and where a face of five corners or more is to have
/// edges of one length: its middle is too far from theirs.
ChangedMesh refined(const Net& net, const ChangePlace& place);

}  // namespace chebnet
