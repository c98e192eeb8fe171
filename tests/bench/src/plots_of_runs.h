#pragma once

#include <string>
#include <vector>

#include "checks.h"
#include "figures.h"
#include "plot.h"

namespace chebnet::bench {

/// What a figure plots (Figure::plots), by name: an edit in each row, a plot in each column; trends over the variants
/// and functions of one edge once for all edits. Throws Error bad_option for a name that is not known.
struct Plots {
    std::vector<Panel> panels;
    int columns;
};
Plots plots_of_runs(const Figure& figure, const std::vector<Group>& groups);

}  // namespace chebnet::bench
