#pragma once

#include <Eigen/Core>

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

/// The two steps of that: all defects of the surface without its noise, and the inner ones of some spread.
Eigen::VectorXd angle_defects_without_noise(const Surface& surface, double radius);
Eigen::VectorXd spread_inner_defects(const Surface& surface, double radius, const Eigen::VectorXd& defects);

/// The integral of Gaussian curvature over what is curved one way, and over what is curved the other; radians.
struct TotalCurvature {
    double positive = 0, negative = 0;  ///< ≥ 0; ≤ 0
};

/// Defects summed by their sign. Noise of a scan adds as much to the one as to the other, and can be most of both.
TotalCurvature total_curvature(const Eigen::VectorXd& defects);

}  // namespace chebnet
