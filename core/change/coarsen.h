#pragma once

#include "change/change.h"

namespace chebnet {

/// The inverse of refining: two by two quads around a vertex become one, wherever four such are; faces beside them, at
/// the border of a net with an odd number of rows, go. Of the ways to begin, the one that keeps most. The vertices that
/// stay keep their places; edges are to be twice as long. The place does not matter. Throws Error impossible_change
/// where a border has cut the net, a face is no quad, where rows cannot be taken in pairs, as between singular vertices
/// an odd number of rows apart, and where nothing would be left.
ChangedMesh coarsened(const Net& net, const ChangePlace& place);

}  // namespace chebnet
