#pragma once

#include "change/change.h"

namespace chebnet {

/// A row of quads between the faces on both sides of the place's edges, which run through the net from border to border
/// or all round: each of their vertices becomes two, half an edge apart from where it was. Throws Error
/// impossible_change where an edge lies on the border, where the line ends inside of the net, and where lines cross.
ChangedMesh with_inner_row(const Net& net, const ChangePlace& place);

/// Without the net line of the place's edges, which is as above: the rows on its two sides become one. Throws Error
/// impossible_change likewise, and where the faces beside the line are no quads, the line passes a singular vertex, or
/// nothing would be left between its neighbours.
ChangedMesh without_line(const Net& net, const ChangePlace& place);

}  // namespace chebnet
