#pragma once

#include "change/change.h"

namespace chebnet {

/// A row of quads outside of those of the place's edges that lie on the border. Net lines that end there go straight on
/// by an edge; round a corner the row turns with a quad more, and into a corner with one less. New vertices come at the
/// end, new faces likewise. Throws Error impossible_change where none of the edges lies on the border, where the border
/// meets itself, or where it turns inwards twice in a row or more sharply than a quad does.
ChangedMesh with_row(const Net& net, const ChangePlace& place);

}  // namespace chebnet
