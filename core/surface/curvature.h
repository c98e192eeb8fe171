#pragma once

#include <Eigen/Core>
#include <string>

#include "surface/surface.h"

namespace chebnet {

/// V, the angle defect of each vertex: 2π less the angles of the triangles around it, the integral of Gaussian
/// curvature there; on the boundary π less them, the integral of geodesic curvature. Their sum is 2π times the Euler
/// characteristic (Gauss–Bonnet).
Eigen::VectorXd angle_defects(const Surface& surface);

/// The same of inner vertices only; 0 on the boundary.
Eigen::VectorXd inner_defects(const Surface& surface);

/// The inner defects of the surface without its noise, as heat spreads them over about `radius` (> 0). The surface is
/// smoothed over two edges, or half the radius if that is less, by an implicit step with the cotangent Laplacian
/// (Pinkall & Polthier 1993), whose negative weights are set to 0; the defects by three. So the sum remains, but for a
/// few percent at a border; what changes its sign within the radius cancels.
Eigen::VectorXd smoothed_angle_defects(const Surface& surface, double radius);

/// The integral of Gaussian curvature over what is curved one way, and over what is curved the other; radians.
struct TotalCurvature {
    double positive = 0, negative = 0;  ///< ≥ 0; ≤ 0
};

/// Defects summed by their sign. Noise of a scan adds as much to the one as to the other, and can be most of both.
TotalCurvature total_curvature(const Eigen::VectorXd& defects);

/// What may be expected of one net on a surface, before anything is tried.
enum class Prospect {
    one_piece,  ///< it will cover the surface
    tight,      ///< it may, but with corners below k_prospect_angle
    a_seam,     ///< it may, but goes round a handle, or a hole in what is curved, and meets itself
    too_curved  ///< it will not
};

/// The name of the enumerator.
const char* to_string(Prospect prospect);

/// A corner sharper than this, 30°, is beyond what wire mesh and draped cloth are made to bear.
inline constexpr double k_prospect_angle = 0.52359877559829887;

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
    Prospect prospect;
    std::string sentence;  ///< the prospect, for a person
};

/// Over a rectangle of a net the integral of Gaussian curvature is the alternating sum of its four corner angles
/// (Hazzidakis 1879), which lies between −2π and 2π, and between ∓2 (π − 2a) if the angles keep within a and π − a. So
/// one net without singular vertices covers what has less of either sign, by the smoothed curvature.
SurfaceReport describe(const Surface& surface);

}  // namespace chebnet
