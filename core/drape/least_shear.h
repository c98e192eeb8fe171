#pragma once

#include "drape/bent_arms.h"

namespace chebnet {

/// A net whose arms are bent so that its cells are sheared less than with geodesic ones. All of a net follows from its
/// arms: with ω the angle between its families and K the curvature of the surface, ω_uv = −K sin ω, so that near right
/// angles ω = f(u) + g(v) − ∫∫K, where f and g say how far the arms of each family have turned. Those that would leave
/// a given net the least shear solve a linear system, in which strong bends count, too. Some nets of about a thousand
/// cells lead to the end, each better than the one before by the sum of fourth powers of shear, or else of squares;
/// what a net does not cover counts as sheared to the limit.
///
/// The net is one with geodesic arms, and says so, where that is as good: one with bent arms is sheared less on the
/// average, at its worst cell by half a degree more at most, and covers as much, but for half a percent.
/// Takes about as long as two nets and twenty of a thousand cells. Throws Error as drape() does.
Drape least_shear_drape(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options);

}  // namespace chebnet
