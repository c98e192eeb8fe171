#pragma once

#include <memory>

#include "edit/editor.h"
#include "edit/rods.h"
#include "surface/guide.h"

namespace chebnet {

/// An editor in which a net without handles comes to rest near a surface, by method `equilibrium`, no corner sharper
/// than the limit (radians, from 0, none, to π/3; else Error bad_option). `tip_weight`: of TipTerm, beside bending.
Editor resting_near(Net net, std::shared_ptr<const Guide> guide, double shear_limit, Rods rods = Rods::straight,
                    double tip_weight = 0);

}  // namespace chebnet
