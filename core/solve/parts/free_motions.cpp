#include "solve/parts/free_motions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "linear/ordered_dot.h"
#include "solve/parts/tangent_newton.h"

namespace chebnet {

namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// Motions that move what is held by less than the square root of this part of the net's size are free.
constexpr double k_unresisted = 1e-12;

}  // namespace

FreeMotions::FreeMotions(std::span<const int> fixed, std::span<const Slide> slides, std::span<const Pull> pulls,
                         const Options& options)
    : m_held(fixed.begin(), fixed.end()) {
    for (const Pull& pull : pulls) m_held.push_back(pull.vertex);
    for (const Slide& slide : slides) m_kept |= k_all_axes - slide.along;
    if (options.gravity > 0) m_kept |= 1 << up_axis(options);
}

/// A motion is a shift a and a turn b about the net's middle: vertex v moves by a + b × y, where y is its place from
/// there in parts of the net's size, and so by (e; y × e)·(a; b) along an axis e.
void FreeMotions::begin(const Positions& x) {
    m_motions.clear();
    const Eigen::Vector3d middle = x.rowwise().mean();
    const double size = (x.colwise() - middle).colwise().norm().maxCoeff();
    Matrix6d resistance = Matrix6d::Zero();
    const auto resist = [&](const Eigen::Vector3d& shift, const Eigen::Vector3d& turn) {
        Vector6d row;
        row << shift, turn;
        resistance += row * row.transpose();
    };
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i), none = Eigen::Vector3d::Zero();
        for (int v : m_held) resist(axis, (x.col(v) - middle).cross(axis) / size);
        if (has_axis(m_kept, i)) resist(axis, none);
        // Only a turn about what is kept itself goes on keeping it.
        if ((m_kept & ~(1 << i)) != k_no_axes) resist(none, axis);
    }
    const Eigen::SelfAdjointEigenSolver<Matrix6d> modes(resistance);
    for (int k = 0; k < 6 && modes.eigenvalues()[k] < k_unresisted; ++k) {
        const Eigen::Vector3d shift = modes.eigenvectors().col(k).head<3>(),
                              turn = modes.eigenvectors().col(k).tail<3>();
        Eigen::Matrix3Xd motion(3, x.cols());
        for (int v = 0; v < x.cols(); ++v) motion.col(v) = shift + turn.cross(x.col(v) - middle) / size;
        take_out(motion);
        m_motions.push_back(motion / std::sqrt(ordered_dot(motion, motion)));
    }
}

void FreeMotions::take_out(Eigen::Matrix3Xd& vectors) const {
    for (const Eigen::Matrix3Xd& motion : m_motions) vectors -= ordered_dot(motion, vectors) * motion;
}

void TangentNewton::find_free_motions(bool is_guided, std::span<const Pull> pulls, const Options& options) {
    m_free_motions = is_guided ? nullptr : std::make_shared<FreeMotions>(m_fixed, m_slides, pulls, options);
}

}  // namespace chebnet
