#pragma once

#include <algorithm>

namespace chebnet {

/// What the lines of a net near a surface would be if nothing else bent them.
enum class Rods {
    straight,  ///< about a vertex of valence 3 they may raise a tip, a cone of three right angles
    as_laid    ///< halfway between straight and as bent as they are on the surface at first
};

/// By which a net of so many cells is held near a surface (ClosenessTerm), beside bending that weighs 1. What is laid
/// on it bends little to stay there, and may lie off it the more softly. What lengths do not fit by is taken up by
/// waves, longer ones the softer that is: those of a finer net are as long, and so many more of its edges, so that they
/// are no folds.
constexpr double closeness_for(Rods rods, int cells) {
    constexpr double k_coarse_cells = 4000, k_coarse = 0.5, k_least = 0.1;
    if (rods == Rods::straight) return 2;
    const double fineness = std::max(1.0, cells / k_coarse_cells);
    return std::max(k_least, k_coarse / (fineness * fineness));
}

}  // namespace chebnet
