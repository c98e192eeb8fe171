#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

namespace chebnet {

/// The rotation R (never a reflection) that maximises tr(Rᵀ A), i.e. the one nearest to A in the Frobenius norm.
/// A few steps from `guess` if that is near, as it is from one iteration of a solver to the next: Newton's method on
/// the rotations, in the spirit of Müller et al., "A Robust Method to Extract the Rotational Part of Deformations",
/// 2016. Else by the largest eigenvector of Horn's quaternion matrix ("Closed-form solution of absolute orientation
/// using unit quaternions", 1987), which always succeeds. Where several rotations are best, one of them.
Eigen::Quaterniond nearest_rotation(const Eigen::Matrix3d& A, const Eigen::Quaterniond& guess);

/// The same for many matrices, two at a time. `rotations`: the guesses, replaced by the nearest rotations; they are
/// written to `matrices` too. All of one length.
void nearest_rotations(const std::vector<Eigen::Matrix3d>& A, std::vector<Eigen::Quaterniond>& rotations,
                       std::vector<Eigen::Matrix3d>& matrices);

}  // namespace chebnet
