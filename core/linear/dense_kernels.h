#pragma once

#include <cmath>
#include <cstring>

namespace chebnet::dense {

/// The dense inner loops of the sparse factorisation, on column-major matrices. Everything runs in one kernel that
/// holds a block of k_block_rows × width entries in vector registers; the compilers' portable vector types make it
/// SSE2 natively and SIMD128 in WebAssembly, with the same arithmetic in the same order on both.

typedef double Vector __attribute__((vector_size(16)));
inline constexpr int k_lanes = 2;

inline Vector load(const double* from) {
    Vector v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
inline void store(double* to, Vector v) { std::memcpy(to, &v, sizeof v); }

/// Rows of one block: two vectors, so that loads are shared between enough products to keep the units busy.
inline constexpr int k_block_rows = 2 * k_lanes;

inline int round_up(int n, int multiple) { return (n + multiple - 1) / multiple * multiple; }

/// C −= A Bᵀ for one block: C has k_block_rows rows and `width` columns, A the same rows, B `width` rows, both `depth`
/// columns. With a lower triangular `diagonal` (width × width, leading dimension width) also solves X diagonalᵀ = C.
template <int width>
void block_kernel(double* C, int ldc, const double* A, int lda, const double* B, int ldb, int depth,
                  const double* diagonal = nullptr) {
    Vector c0[width], c1[width];
    for (int j = 0; j < width; ++j) {
        c0[j] = load(C + j * ldc);
        c1[j] = load(C + j * ldc + k_lanes);
    }
    for (int k = 0; k < depth; ++k) {
        const auto a0 = load(A), a1 = load(A + k_lanes);
        for (int j = 0; j < width; ++j) {
            c0[j] -= a0 * B[j];
            c1[j] -= a1 * B[j];
        }
        A += lda;
        B += ldb;
    }
    if (diagonal != nullptr)
        for (int j = 0; j < width; ++j) {
            for (int k = 0; k < j; ++k) {
                c0[j] -= c0[k] * diagonal[k * width + j];
                c1[j] -= c1[k] * diagonal[k * width + j];
            }
            c0[j] /= diagonal[j * width + j];
            c1[j] /= diagonal[j * width + j];
        }
    for (int j = 0; j < width; ++j) {
        store(C + j * ldc, c0[j]);
        store(C + j * ldc + k_lanes, c1[j]);
    }
}

/// One strip of `width` columns of factor_panel, from column j on.
template <int width>
bool factor_strip(double* panel, int ld, int rows, int j) {
    // The diagonal block, out of place: blocks of rows below may overlap it.
    double diagonal[width * width];
    for (int c = 0; c < width; ++c)
        for (int r = c; r < width; ++r) {
            double sum = panel[(j + c) * ld + j + r];
            for (int k = 0; k < j; ++k) sum -= panel[k * ld + j + r] * panel[k * ld + j + c];
            for (int k = 0; k < c; ++k) sum -= diagonal[k * width + r] * diagonal[k * width + c];
            if (r == c && !(sum > 0)) return false;
            diagonal[c * width + r] = r == c ? std::sqrt(sum) : sum / diagonal[c * width + c];
        }
    // Whole blocks only: the first may begin a little too high, in rows whose entries in these columns are above the
    // diagonal, and not used, or in the diagonal block, which is written last.
    const int below = rows - j - width;
    for (int row = rows - round_up(below, k_block_rows); row < rows; row += k_block_rows)
        block_kernel<width>(panel + j * ld + row, ld, panel + row, ld, panel + j, ld, j, diagonal);
    for (int c = 0; c < width; ++c)
        for (int r = c; r < width; ++r) panel[(j + c) * ld + j + r] = diagonal[c * width + r];
    return true;
}

/// Cholesky factorisation of the leading `columns` columns of a panel with `rows` ≥ columns rows (leading dimension
/// ld), in place: L L^T in the triangle, the rest of L below. rows − columns must be a multiple of k_block_rows.
/// Entries above the diagonal are overwritten. False if the triangle is not positive definite.
inline bool factor_panel(double* panel, int ld, int rows, int columns) {
    int j = 0;
    for (; j + 4 <= columns; j += 4)
        if (!factor_strip<4>(panel, ld, rows, j)) return false;
    switch (columns - j) {
        case 1:
            return factor_strip<1>(panel, ld, rows, j);
        case 2:
            return factor_strip<2>(panel, ld, rows, j);
        case 3:
            return factor_strip<3>(panel, ld, rows, j);
        default:
            return true;
    }
}

/// Lower triangle of C −= A Aᵀ with C n×n and A n×depth; n a multiple of k_block_rows. Some entries above the diagonal
/// are overwritten.
inline void subtract_outer_product(double* C, int ldc, const double* A, int lda, int n, int depth) {
    constexpr int width = 4;
    for (int j = 0; j < n; j += width)
        for (int i = j / k_block_rows * k_block_rows; i < n; i += k_block_rows)
            block_kernel<width>(C + j * ldc + i, ldc, A + i, lda, A + j, lda, depth);
}

/// Σ a_i b_i in the lanes of two vectors, so that the sum's order does not depend on the compiler.
inline double dot(const double* a, const double* b, int n) {
    Vector s0{}, s1{};
    int i = 0;
    for (; i + 2 * k_lanes <= n; i += 2 * k_lanes) {
        s0 += load(a + i) * load(b + i);
        s1 += load(a + i + k_lanes) * load(b + i + k_lanes);
    }
    s0 += s1;
    double sum = 0;
    for (int lane = 0; lane < k_lanes; ++lane) sum += s0[lane];
    for (; i < n; ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace chebnet::dense
