#include "solve/parts/rigid_motion.h"

#include "solve/parts/nearest_rotation.h"

namespace chebnet {

namespace {

// What is nearer to one line than this leaves a turn about it free.
constexpr double k_determined = 1e-6;

}  // namespace

RigidMotion fit_rigid_motion(const Positions& from, const Positions& to, const Eigen::VectorXd& weight) {
    RigidMotion motion{{0, 0, 0}, {0, 0, 0}, Eigen::Quaterniond::Identity(), false};
    for (Eigen::Index v = 0; v < to.cols(); ++v) {
        motion.from_centre += weight[v] * from.col(v);
        motion.to_centre += weight[v] * to.col(v);
    }
    motion.from_centre /= weight.sum();
    motion.to_centre /= weight.sum();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (Eigen::Index v = 0; v < to.cols(); ++v)
        covariance += weight[v] * (to.col(v) - motion.to_centre) * (from.col(v) - motion.from_centre).transpose();
    motion.rotation = nearest_rotation(covariance, Eigen::Quaterniond::Identity());
    // The product of the two largest singular values against the square of the largest.
    Eigen::Matrix3d minors;
    for (int k = 0; k < 3; ++k) minors.col(k) = covariance.col((k + 1) % 3).cross(covariance.col((k + 2) % 3));
    motion.is_determined = minors.norm() > k_determined * covariance.squaredNorm();
    return motion;
}

}  // namespace chebnet
