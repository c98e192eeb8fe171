#pragma once

#include <memory>
#include <string>

#include "base/angle.h"
#include "surface/curvature.h"
#include "surface/guide.h"
#include "surface/surface.h"

namespace chebnet {

/// What may be expected of one net on a surface, without singular vertices, from a good place to begin.
enum class Prospect {
    one_piece,  ///< it covers the surface, and nothing of it locks
    tight,      ///< it may, with a slit or with corners below k_prospect_angle
    a_seam,     ///< it does, but goes round a handle, or a hole in what is curved, and meets itself
    too_curved  ///< it leaves gaps
};

/// The name of the enumerator.
const char* to_string(Prospect prospect);

/// A corner sharper than this, 30°, is beyond what wire mesh and draped cloth are made to bear.
inline constexpr double k_prospect_angle = k_usual_shear_limit;

/// A surface in numbers.
struct SurfaceReport {
    int vertices, triangles;
    int triangles_without_area;
    int components, boundary_loops;
    int genus;  ///< of all components together
    double area;
    TotalCurvature curvature;           ///< as the triangles have it
    TotalCurvature smoothed_curvature;  ///< of the shape without its noise
    double hardest_curvature;           ///< the larger of the latter's two, in the component where that is largest
    double tried_coverage;              ///< part of the largest component that a net of a few hundred cells covers with
                                        ///< no corner below k_prospect_angle: the best of some, or the first good one
    Prospect prospect;
    std::string sentence;  ///< the prospect, for a person
};

/// Over a rectangle of a net the integral of Gaussian curvature is the alternating sum of its four corner angles
/// (Hazzidakis 1879), which lies between −2π and 2π. So a disc with less curvature of either sign takes one net. One
/// with more may as well, where both signs cancel within the rectangles, and so may a tube, whose rectangles are
/// shorter than the way around it. So nets are tried, on the surface without its roughness: from the middle first, then
/// elsewhere until one covers 98 %; and none is promised where the shape is finer than they are. Takes as long as
/// laying nets of 400 cells, sixteen at most.
SurfaceReport describe(const std::shared_ptr<const Guide>& guide);
SurfaceReport describe(const Surface& surface);

}  // namespace chebnet
