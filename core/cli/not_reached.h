#pragma once

#include "edit/editor.h"

namespace chebnet {

/// Says on standard error why a solve that ended so has left edges off their length, and what may help: one line.
/// `has_grown_edges`: edges that grow have been tried.
void tell_not_reached(const Editor& editor, const SolveReport& end, bool has_grown_edges);

}  // namespace chebnet
