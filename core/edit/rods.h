#pragma once

namespace chebnet {

/// What the lines of a net near a surface would be if nothing else bent them.
enum class Rods {
    straight,  ///< Lines that end at a border then leave a surface as little as its curvature asks for. About a
               ///< singular vertex straight rods want the cone of four or more right angles too few or too many: a tip.
    as_laid    ///< Halfway between straight and as bent as they are on the surface at first.
};

/// By which a net is held near a surface (ClosenessTerm), beside bending that weighs 1. What is laid on it bends little
/// to stay there, and may lie off it the more softly.
constexpr double closeness_for(Rods rods) { return rods == Rods::straight ? 2 : 1; }

}  // namespace chebnet
