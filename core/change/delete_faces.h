#pragma once

#include "change/change.h"

namespace chebnet {

/// Faces go, and vertices that are left without any. All throw Error impossible_change where no face would go, or none
/// would stay.

/// Those with a corner at one of the place's vertices.
ChangedMesh without_faces_at(const Net& net, const ChangePlace& place);

/// Those with one of the place's edges.
ChangedMesh without_rows(const Net& net, const ChangePlace& place);

/// Of the parts of the net that meet at the place's edges, if it were cut there, all but the one with most faces go; or
/// that one. Pieces of the net without such an edge stay. Throws impossible_change if there is but one such part.
ChangedMesh larger_side(const Net& net, const ChangePlace& place);
ChangedMesh smaller_side(const Net& net, const ChangePlace& place);

/// Of the pieces of the net, which no edge joins, only those with one of the place's vertices stay; or those go.
ChangedMesh pieces_at(const Net& net, const ChangePlace& place);
ChangedMesh without_pieces_at(const Net& net, const ChangePlace& place);

}  // namespace chebnet
