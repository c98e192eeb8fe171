#pragma once

#include <cmath>
#include <cstring>

namespace chebnet::dense {

/// The dense inner loops of the sparse factorisation, on column-major matrices of double or float. The arithmetic runs
/// in kernels that hold a block of entries in vector registers; the compilers' portable vector types make them SSE2
/// natively and SIMD128 in WebAssembly, with the same arithmetic in the same order on both. Where a processor has AVX
/// what costs most uses registers of twice that width; no entry is reckoned otherwise there.

template <typename Scalar, int count>
struct VectorOf {
    using type __attribute__((vector_size(count * sizeof(Scalar)))) = Scalar;
};
template <typename Scalar>
inline constexpr int k_lanes = 16 / static_cast<int>(sizeof(Scalar));
/// One register.
template <typename Scalar>
using Vector = typename VectorOf<Scalar, k_lanes<Scalar>>::type;
/// The entries of four right-hand sides in one row: one register of floats.
using Four = VectorOf<float, 4>::type;

template <typename Loaded, typename Scalar>
Loaded load(const Scalar* from) {
    Loaded v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
template <typename Scalar, typename Stored>
void store(Scalar* to, const Stored& v) {
    std::memcpy(to, &v, sizeof v);
}

/// Rows are padded to a multiple of this, which no kernel's block is smaller than.
inline constexpr int k_row_multiple = 4;

inline int round_up(int n, int multiple) { return (n + multiple - 1) / multiple * multiple; }

/// Entries of a factor in single precision below this part of their column's pivot are taken as 0: they are far below
/// its rounding, and where they decay, as away from each vertex of a regular grid, their products would be numbers so
/// small that processors take a hundred times as long for each.
inline constexpr float k_negligible_part = 1e-16F;

// Once for all widths of strips: a page loads this code before its first net.
template <typename Scalar>
__attribute__((noinline)) void drop_negligible(Scalar* entries, int count, Scalar pivot) {
    const Scalar limit = k_negligible_part * pivot;
    for (int i = 0; i < count; ++i) entries[i] = std::abs(entries[i]) < limit ? Scalar(0) : entries[i];
}

/// C −= A Bᵀ for one block: C has `vectors` registers of `lanes` rows and `width` columns, A the same rows, B `width`
/// rows, both `depth` columns. With a lower triangular `diagonal` (width × width, leading dimension width) also solves
/// X diagonalᵀ = C.
template <int width, int vectors, int lanes, typename Scalar>
void block_kernel(Scalar* C, int ldc, const Scalar* A, int lda, const Scalar* B, int ldb, int depth,
                  const Scalar* diagonal) {
    using V = typename VectorOf<Scalar, lanes>::type;
    V c[vectors][width];
    for (int j = 0; j < width; ++j)
        for (int v = 0; v < vectors; ++v) std::memcpy(&c[v][j], C + j * ldc + v * lanes, sizeof(V));
    for (int k = 0; k < depth; ++k) {
        V a[vectors];
        for (int v = 0; v < vectors; ++v) std::memcpy(&a[v], A + v * lanes, sizeof(V));
        for (int j = 0; j < width; ++j)
            for (int v = 0; v < vectors; ++v) c[v][j] -= a[v] * B[j];
        A += lda;
        B += ldb;
    }
    if (diagonal != nullptr)
        for (int j = 0; j < width; ++j)
            for (int v = 0; v < vectors; ++v) {
                for (int k = 0; k < j; ++k) c[v][j] -= c[v][k] * diagonal[k * width + j];
                c[v][j] /= diagonal[j * width + j];
            }
    for (int j = 0; j < width; ++j)
        for (int v = 0; v < vectors; ++v) std::memcpy(C + j * ldc + v * lanes, &c[v][j], sizeof(V));
}

/// Runs the kernel over `rows` rows, a multiple of k_row_multiple: two registers at a time, so that loads are shared
/// between enough products to keep the units busy.
template <int width, int lanes, typename Scalar>
void block_column_by(int rows, Scalar* C, int ldc, const Scalar* A, int lda, const Scalar* B, int ldb, int depth,
                     const Scalar* diagonal) {
    constexpr int block = 2 * lanes, narrow = k_lanes<Scalar>;
    int i = 0;
    for (; i + block <= rows; i += block)
        block_kernel<width, 2, lanes>(C + i, ldc, A + i, lda, B, ldb, depth, diagonal);
    if constexpr (lanes > narrow)
        block_column_by<width, narrow>(rows - i, C + i, ldc, A + i, lda, B, ldb, depth, diagonal);
    else if constexpr (block > k_row_multiple)
        if (i < rows) block_kernel<width, 1, lanes>(C + i, ldc, A + i, lda, B, ldb, depth, diagonal);
}

#if defined(__x86_64__)
inline const bool k_has_avx = __builtin_cpu_supports("avx");

template <int width, typename Scalar>
__attribute__((target("avx"), flatten)) void block_column_by_avx(int rows, Scalar* C, int ldc, const Scalar* A, int lda,
                                                                 const Scalar* B, int ldb, int depth,
                                                                 const Scalar* diagonal) {
    block_column_by<width, 2 * k_lanes<Scalar>>(rows, C, ldc, A, lda, B, ldb, depth, diagonal);
}
#endif

template <int width, typename Scalar>
void block_column(int rows, Scalar* C, int ldc, const Scalar* A, int lda, const Scalar* B, int ldb, int depth,
                  const Scalar* diagonal = nullptr) {
#if defined(__x86_64__)
    if (k_has_avx) return block_column_by_avx<width>(rows, C, ldc, A, lda, B, ldb, depth, diagonal);
#endif
    block_column_by<width, k_lanes<Scalar>>(rows, C, ldc, A, lda, B, ldb, depth, diagonal);
}

/// One strip of `width` columns of factor_panel, from column j on.
template <int width, typename Scalar>
bool factor_strip(Scalar* panel, int ld, int rows, int j) {
    // The diagonal block, out of place: blocks of rows below may overlap it.
    Scalar diagonal[width * width];
    for (int c = 0; c < width; ++c)
        for (int r = c; r < width; ++r) {
            Scalar sum = panel[(j + c) * ld + j + r];
            for (int k = 0; k < j; ++k) sum -= panel[k * ld + j + r] * panel[k * ld + j + c];
            for (int k = 0; k < c; ++k) sum -= diagonal[k * width + r] * diagonal[k * width + c];
            if (r == c && !(sum > 0)) return false;
            diagonal[c * width + r] = r == c ? std::sqrt(sum) : sum / diagonal[c * width + c];
        }
    // Whole blocks only: the first may begin a little too high, in rows whose entries in these columns are above the
    // diagonal, and not used, or in the diagonal block, which is written last.
    const int below = round_up(rows - j - width, k_row_multiple), first = rows - below;
    block_column<width>(below, panel + j * ld + first, ld, panel + first, ld, panel + j, ld, j, diagonal);
    for (int c = 0; c < width; ++c)
        for (int r = c; r < width; ++r) panel[(j + c) * ld + j + r] = diagonal[c * width + r];
    if constexpr (sizeof(Scalar) == sizeof(float))
        for (int c = 0; c < width; ++c)
            drop_negligible(panel + (j + c) * ld + j + c + 1, rows - j - c - 1, diagonal[c * width + c]);
    return true;
}

/// Cholesky factorisation of the leading `columns` columns of a panel with `rows` ≥ columns rows (leading dimension
/// ld), in place: L Lᵀ in the triangle, the rest of L below. rows − columns must be a multiple of k_row_multiple.
/// Entries above the diagonal are overwritten. False if the triangle is not positive definite.
template <typename Scalar>
bool factor_panel(Scalar* panel, int ld, int rows, int columns) {
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

/// Lower triangle of C −= A Aᵀ with C n×n and A n×depth; n a multiple of k_row_multiple. Some entries above the
/// diagonal are overwritten.
template <typename Scalar>
void subtract_outer_product(Scalar* C, int ldc, const Scalar* A, int lda, int n, int depth) {
    constexpr int width = k_row_multiple;
    for (int j = 0; j < n; j += width) block_column<width>(n - j, C + j * ldc + j, ldc, A + j, lda, A + j, lda, depth);
}

/// Σ of the lanes, from the first on, so that the sum's order does not depend on the compiler.
template <typename Scalar>
Scalar sum_of_lanes(const Vector<Scalar>& v) {
    Scalar sum = v[0];
    for (int lane = 1; lane < k_lanes<Scalar>; ++lane) sum += v[lane];
    return sum;
}

/// Σ a_i b_i.
template <typename Scalar>
Scalar dot(const Scalar* a, const Scalar* b, int n) {
    using V = Vector<Scalar>;
    constexpr int lanes = k_lanes<Scalar>;
    V sum[4] = {};
    int i = 0;
    for (; i + 4 * lanes <= n; i += 4 * lanes)
        for (int k = 0; k < 4; ++k) sum[k] += load<V>(a + i + k * lanes) * load<V>(b + i + k * lanes);
    Scalar rest = 0;
    for (; i < n; ++i) rest += a[i] * b[i];
    return sum_of_lanes<Scalar>((sum[0] + sum[1]) + (sum[2] + sum[3])) + rest;
}

/// Solves L y = x for `width` columns of a factored panel: the first of the `rows` rows of x from there on become y,
/// the others lose what L has below times y. L begins in the strip's diagonal, whose reciprocals are known; rows −
/// width must be a multiple of k_row_multiple.
template <int width, typename Scalar>
void solve_strip(const Scalar* L, int ld, int rows, const Scalar* reciprocals, Scalar* x) {
    using V = Vector<Scalar>;
    Scalar y[width];
    for (int c = 0; c < width; ++c) {
        Scalar rest = x[c];
        for (int k = 0; k < c; ++k) rest -= L[k * ld + c] * y[k];
        x[c] = y[c] = rest * reciprocals[c];
    }
    for (int i = width; i < rows; i += k_lanes<Scalar>) {
        V left = load<V>(x + i);
        for (int c = 0; c < width; ++c) left -= load<V>(L + c * ld + i) * y[c];
        store(x + i, left);
    }
}

/// The same for Lᵀ x = y, where the rows below are known.
template <int width, typename Scalar>
void solve_transposed_strip(const Scalar* L, int ld, int rows, const Scalar* reciprocals, Scalar* x) {
    using V = Vector<Scalar>;
    V below[width] = {};
    for (int i = width; i < rows; i += k_lanes<Scalar>) {
        const V known = load<V>(x + i);
        for (int c = 0; c < width; ++c) below[c] += load<V>(L + c * ld + i) * known;
    }
    Scalar solved[width];
    for (int c = width - 1; c >= 0; --c) {
        Scalar rest = x[c] - sum_of_lanes<Scalar>(below[c]);
        for (int k = c + 1; k < width; ++k) rest -= L[c * ld + k] * solved[k];
        x[c] = solved[c] = rest * reciprocals[c];
    }
}

/// Solves L y = x for the columns of a factored panel with `rows` rows: in strips of four after one of what is left
/// over, so that whole registers are below each of them. x has `rows` rows too; those below lose what L has there
/// times y.
template <typename Scalar>
void solve_panel(const Scalar* L, int rows, int columns, const Scalar* reciprocals, Scalar* x) {
    const int odd = columns % k_row_multiple;
    if (odd == 1) solve_strip<1>(L, rows, rows, reciprocals, x);
    if (odd == 2) solve_strip<2>(L, rows, rows, reciprocals, x);
    if (odd == 3) solve_strip<3>(L, rows, rows, reciprocals, x);
    for (int j = odd; j < columns; j += k_row_multiple)
        solve_strip<k_row_multiple>(L + static_cast<long>(j) * rows + j, rows, rows - j, reciprocals + j, x + j);
}

/// The same for Lᵀ x = y, where the rows below are known.
template <typename Scalar>
void solve_transposed_panel(const Scalar* L, int rows, int columns, const Scalar* reciprocals, Scalar* x) {
    const int odd = columns % k_row_multiple;
    for (int j = columns - k_row_multiple; j >= odd; j -= k_row_multiple)
        solve_transposed_strip<k_row_multiple>(L + static_cast<long>(j) * rows + j, rows, rows - j, reciprocals + j,
                                               x + j);
    if (odd == 1) solve_transposed_strip<1>(L, rows, rows, reciprocals, x);
    if (odd == 2) solve_transposed_strip<2>(L, rows, rows, reciprocals, x);
    if (odd == 3) solve_transposed_strip<3>(L, rows, rows, reciprocals, x);
}

/// Solves L X = X in place for the leading `n`×n triangle of a panel; X has n rows of type Row, a register with an
/// entry for each right-hand side.
template <typename Scalar, typename Row>
void solve_triangle(const Scalar* L, int ld, int n, Row* x) {
    for (int j = 0; j < n; ++j, L += ld) {
        const Row value = x[j] /= L[j];
        for (int i = j + 1; i < n; ++i) x[i] -= L[i] * value;
    }
}

/// The same for Lᵀ.
template <typename Scalar, typename Row>
void solve_transposed_triangle(const Scalar* L, int ld, int n, Row* x) {
    for (int j = n - 1; j >= 0; --j) {
        const Scalar* column = L + j * ld;
        Row sum = x[j];
        for (int i = j + 1; i < n; ++i) sum -= column[i] * x[i];
        x[j] = sum / column[j];
    }
}

/// Rows `places` of Y −= A X, A count×columns with leading dimension lda, several right-hand sides.
template <typename Scalar, typename Row>
void subtract_product_at(Row* Y, const int* places, const Scalar* A, int lda, int count, int columns, const Row* X) {
    int j = 0;
    for (; j + 4 <= columns; j += 4, A += 4 * lda) {
        const Row x0 = X[j], x1 = X[j + 1], x2 = X[j + 2], x3 = X[j + 3];
        for (int i = 0; i < count; ++i) {
            const Scalar* a = A + i;
            Y[places[i]] -= (a[0] * x0 + a[lda] * x1) + (a[2 * lda] * x2 + a[3 * lda] * x3);
        }
    }
    for (; j < columns; ++j, A += lda)
        for (int i = 0; i < count; ++i) Y[places[i]] -= A[i] * X[j];
}

/// X −= Aᵀ times rows `places` of Y, sizes as above.
template <typename Scalar, typename Row>
void subtract_transposed_product_at(Row* X, const Scalar* A, int lda, int count, int columns, const Row* Y,
                                    const int* places) {
    int j = 0;
    for (; j + 4 <= columns; j += 4, A += 4 * lda) {
        Row sum0{}, sum1{}, sum2{}, sum3{};
        for (int i = 0; i < count; ++i) {
            const Scalar* a = A + i;
            const Row y = Y[places[i]];
            sum0 += a[0] * y;
            sum1 += a[lda] * y;
            sum2 += a[2 * lda] * y;
            sum3 += a[3 * lda] * y;
        }
        X[j] -= sum0;
        X[j + 1] -= sum1;
        X[j + 2] -= sum2;
        X[j + 3] -= sum3;
    }
    for (; j < columns; ++j, A += lda)
        for (int i = 0; i < count; ++i) X[j] -= A[i] * Y[places[i]];
}

}  // namespace chebnet::dense
