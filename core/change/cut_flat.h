#pragma once

#include "change/change.h"

namespace chebnet {

/// Cut along net lines, so that each piece lies flat as a part of the square grid (see fabricate/flat_pattern.h). Lines
/// are cut from all singular vertices inside at once, each until it meets a border or another cut (the motorcycle graph
/// of Eppstein, Goodrich, Kim and Tamstorf 2008), and where a piece still closes on itself or would lie upon itself;
/// then pieces that lie flat together are joined again, first those with most edges between them. Faces that meet at a
/// vertex alone are parted. How a face lies in a cell of which a border has cut off a part says cell_sides(). The place
/// does not matter. Throws Error impossible_change where an inner face is no quad, where edges inside of the net differ
/// in length, and where nothing is to be cut: by the face, if one stands alone that is no quad.
ChangedMesh cut_flat(const Net& net, const ChangePlace& place);

}  // namespace chebnet
