#include "solve/parts/nearest_rotation.h"

#include <Eigen/Jacobi>
#include <cmath>
#include <limits>

#include "linear/dense_kernels.h"

namespace chebnet {

namespace {

// Near the solution the error is cubed by each step, so that these are plenty, and after a step below the tolerance
// (radians) hardly more than rounding is left.
constexpr int k_max_steps = 8;
constexpr double k_last_step = 1e-3;
// Jacobi's method converges quadratically too.
constexpr int k_most_sweeps = 8;

/// Values of two cells, which are computed at once.
using Pair = dense::Vector<double>;
constexpr int k_cells = dense::k_lanes<double>;

struct PairOfQuaternions {
    Pair w, x, y, z;
};

struct PairOfMatrices {
    Pair at[3][3];  // [row][column]
};

PairOfMatrices matrices(const PairOfQuaternions& q) {
    const Pair xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
    const Pair wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
    return {{{1 - 2 * (yy + zz), 2 * (xy - wz), 2 * (xz + wy)},
             {2 * (xy + wz), 1 - 2 * (xx + zz), 2 * (yz - wx)},
             {2 * (xz - wy), 2 * (yz + wx), 1 - 2 * (xx + yy)}}};
}

/// RᵀA
PairOfMatrices transposed_product(const PairOfMatrices& R, const PairOfMatrices& A) {
    PairOfMatrices B{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            B.at[i][j] = R.at[0][i] * A.at[0][j] + R.at[1][i] * A.at[1][j] + R.at[2][i] * A.at[2][j];
    return B;
}

Pair square_root(const Pair& squares) { return Pair{std::sqrt(squares[0]), std::sqrt(squares[1])}; }

/// q (1, ω/2), normalised.
void turn(PairOfQuaternions& q, const Pair& x, const Pair& y, const Pair& z) {
    const PairOfQuaternions p = q;
    q.w = p.w - (p.x * x + p.y * y + p.z * z) / 2;
    q.x = p.x + (p.w * x + p.y * z - p.z * y) / 2;
    q.y = p.y + (p.w * y + p.z * x - p.x * z) / 2;
    q.z = p.z + (p.w * z + p.x * y - p.y * x) / 2;
    const Pair inverse = 1 / square_root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    q.w *= inverse, q.x *= inverse, q.y *= inverse, q.z *= inverse;
}

enum class Step { last, one_of_several, impossible };

/// One step of Newton's method for both cells. For R exp([ω]) and B = RᵀA the objective is
/// tr B + g·ω − ½ ωᵀ K ω + …, K = (tr B) I − sym B; the step is K⁻¹ g where K is positive definite.
void newton_step(const PairOfMatrices& A, PairOfQuaternions& q, Step (&outcome)[k_cells]) {
    const auto [B] = transposed_product(matrices(q), A);
    const Pair gx = B[2][1] - B[1][2], gy = B[0][2] - B[2][0], gz = B[1][0] - B[0][1];
    const Pair a = B[1][1] + B[2][2], b = B[0][0] + B[2][2], c = B[0][0] + B[1][1];
    const Pair d = -(B[0][1] + B[1][0]) / 2, e = -(B[0][2] + B[2][0]) / 2, f = -(B[1][2] + B[2][1]) / 2;
    // The adjugate of K = [a d e; d b f; e f c].
    const Pair axx = b * c - f * f, axy = e * f - d * c, axz = d * f - b * e;
    const Pair ayy = a * c - e * e, ayz = d * e - a * f, azz = a * b - d * d;
    const Pair determinant = a * axx + d * axy + e * axz;
    const Pair x = (axx * gx + axy * gy + axz * gz) / determinant;
    const Pair y = (axy * gx + ayy * gy + ayz * gz) / determinant;
    const Pair z = (axz * gx + ayz * gy + azz * gz) / determinant;
    const Pair squared_angle = x * x + y * y + z * z;
    for (int cell = 0; cell < k_cells; ++cell)
        if (!(a[cell] > 0 && azz[cell] > 0 && determinant[cell] > 0))
            outcome[cell] = Step::impossible;
        else
            outcome[cell] = squared_angle[cell] < k_last_step * k_last_step ? Step::last : Step::one_of_several;
    turn(q, x, y, z);
}

/// Of a symmetric matrix, by Jacobi's method: it is turned in the plane of two axes at a time until it is diagonal.
Eigen::Vector4d largest_eigenvector(Eigen::Matrix4d N) {
    const double negligible = std::numeric_limits<double>::epsilon() * N.norm();
    Eigen::Matrix4d axes = Eigen::Matrix4d::Identity();
    for (int sweep = 0; sweep < k_most_sweeps; ++sweep)
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) {
                if (std::abs(N(i, j)) <= negligible) continue;
                Eigen::JacobiRotation<double> turn;
                turn.makeJacobi(N, i, j);
                N.applyOnTheLeft(i, j, turn.adjoint());
                N.applyOnTheRight(i, j, turn);
                axes.applyOnTheRight(i, j, turn);
            }
    int largest = 0;
    N.diagonal().maxCoeff(&largest);
    return axes.col(largest).normalized();
}

/// tr(R(q)ᵀ A) = qᵀ N q for a unit quaternion q = (w, x, y, z).
Eigen::Quaterniond by_largest_eigenvector(const Eigen::Matrix3d& A) {
    Eigen::Matrix4d N;
    N(0, 0) = A.trace();
    N.bottomLeftCorner<3, 1>() << A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1);
    N.topRightCorner<1, 3>() = N.bottomLeftCorner<3, 1>().transpose();
    N.bottomRightCorner<3, 3>() = A + A.transpose() - A.trace() * Eigen::Matrix3d::Identity();
    const Eigen::Vector4d q = largest_eigenvector(N);
    return {q[0], q[1], q[2], q[3]};
}

/// Turns two cells from their guesses to the nearest rotations.
void find_nearest(const Eigen::Matrix3d* const (&A)[k_cells], Eigen::Quaterniond* const (&cells)[k_cells]) {
    PairOfMatrices pair{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) pair.at[i][j] = Pair{(*A[0])(i, j), (*A[1])(i, j)};
    PairOfQuaternions q{{cells[0]->w(), cells[1]->w()},
                        {cells[0]->x(), cells[1]->x()},
                        {cells[0]->y(), cells[1]->y()},
                        {cells[0]->z(), cells[1]->z()}};
    bool found[k_cells] = {};
    for (int step = 0; step < k_max_steps && !(found[0] && found[1]); ++step) {
        Step outcome[k_cells];
        newton_step(pair, q, outcome);
        if (outcome[0] == Step::impossible || outcome[1] == Step::impossible) break;
        for (int cell = 0; cell < k_cells; ++cell) found[cell] = outcome[cell] == Step::last;
    }
    for (int cell = 0; cell < k_cells; ++cell)
        *cells[cell] = found[cell] ? Eigen::Quaterniond(q.w[cell], q.x[cell], q.y[cell], q.z[cell])
                                   : by_largest_eigenvector(*A[cell]);
}

}  // namespace

Eigen::Quaterniond nearest_rotation(const Eigen::Matrix3d& A, const Eigen::Quaterniond& guess) {
    Eigen::Quaterniond q = guess, twin = guess;
    find_nearest({&A, &A}, {&q, &twin});
    return q;
}

void nearest_rotations(const std::vector<Eigen::Matrix3d>& A, std::vector<Eigen::Quaterniond>& rotations,
                       std::vector<Eigen::Matrix3d>& matrices) {
    std::size_t v = 0;
    for (; v + k_cells <= A.size(); v += k_cells) find_nearest({&A[v], &A[v + 1]}, {&rotations[v], &rotations[v + 1]});
    if (v < A.size()) rotations[v] = nearest_rotation(A[v], rotations[v]);
    for (v = 0; v < A.size(); ++v) matrices[v] = rotations[v].toRotationMatrix();
}

}  // namespace chebnet
