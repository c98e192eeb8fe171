#pragma once

namespace chebnet {

/// What the lines of a net near a surface would be if nothing else bent them.
enum class Rods {
    straight,  ///< about a vertex of valence 3 they raise a tip, a cone of three right angles
    as_laid    ///< halfway between straight and as bent as they are on the surface at first
};

/// By which a net is held near a surface (ClosenessTerm), beside bending that weighs 1. What is laid on it bends little
/// to stay there, and may lie off it the more softly.
constexpr double closeness_for(Rods rods) { return rods == Rods::straight ? 2 : 1; }

}  // namespace chebnet
