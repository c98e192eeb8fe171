#include "solve/nearest_rotation.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace chebnet {

namespace {

// Near the solution the error is cubed by each step, so that these are plenty, and after a step below the tolerance
// (radians) only rounding is left.
constexpr int k_max_steps = 8;
constexpr double k_last_step = 1e-6;

bool is_positive_definite(const Eigen::Matrix3d& K) {
    return K(0, 0) > 0 && K(0, 0) * K(1, 1) > K(0, 1) * K(0, 1) && K.determinant() > 0;
}

/// tr(R(q)ᵀ A) = qᵀ N q for a unit quaternion q = (w, x, y, z).
Eigen::Quaterniond by_largest_eigenvector(const Eigen::Matrix3d& A) {
    Eigen::Matrix4d N;
    N(0, 0) = A.trace();
    N.bottomLeftCorner<3, 1>() << A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1);
    N.topRightCorner<1, 3>() = N.bottomLeftCorner<3, 1>().transpose();
    N.bottomRightCorner<3, 3>() = A + A.transpose() - A.trace() * Eigen::Matrix3d::Identity();
    const Eigen::Vector4d q = Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(N).eigenvectors().col(3);
    return {q[0], q[1], q[2], q[3]};
}

}  // namespace

Eigen::Quaterniond nearest_rotation(const Eigen::Matrix3d& A, const Eigen::Quaterniond& guess) {
    // For R exp([ω]) and B = RᵀA the objective is tr B + g·ω − ½ ωᵀ K ω + …, K = (tr B) I − sym B.
    Eigen::Quaterniond q = guess;
    for (int step = 0; step < k_max_steps; ++step) {
        const Eigen::Matrix3d B = q.toRotationMatrix().transpose() * A;
        const Eigen::Vector3d g(B(2, 1) - B(1, 2), B(0, 2) - B(2, 0), B(1, 0) - B(0, 1));
        const Eigen::Matrix3d K = B.trace() * Eigen::Matrix3d::Identity() - (B + B.transpose()) / 2;
        if (!is_positive_definite(K)) break;
        const Eigen::Vector3d omega = K.inverse() * g;
        q *= Eigen::Quaterniond(1, omega[0] / 2, omega[1] / 2, omega[2] / 2);
        q.normalize();
        if (omega.squaredNorm() < k_last_step * k_last_step) return q;
    }
    return by_largest_eigenvector(A);
}

}  // namespace chebnet
