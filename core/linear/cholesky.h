#pragma once

#include <Eigen/Core>
#include <vector>

#include "linear/dense_kernels.h"
#include "linear/supernodes.h"

namespace chebnet {

/// Multifrontal supernodal Cholesky factorisation L Lᵀ of a symmetric positive definite matrix of size×size blocks on a
/// graph (Duff & Reid 1983; Liu 1992). analyze() once; factorize() as often as values change, without allocation.
/// `Scalar` is what the factor is computed and kept in: double, or float for half the time where the caller corrects
/// the solution by the residual.
template <int size, typename Scalar>
class Cholesky {
public:
    using Block = Eigen::Matrix<double, size, size>;

    /// `links`: 2×K, the joined pairs of nodes. `rank`: node → place in a fill-reducing order. Throws Error too_large
    /// if factorize() would need more than k_most_factor_bytes, before it asks for them.
    void analyze(int node_count, const Eigen::Matrix2Xi& links, const std::vector<int>& rank);

    /// `node_blocks`: the diagonal block of each node; `link_blocks`: the off-diagonal block of each link, its
    /// rows those of the end eliminated later.
    /// False if the matrix is not positive definite or not finite.
    bool factorize(const std::vector<Block>& node_blocks, const std::vector<Block>& link_blocks);

    /// Solves in place. `x`: size·node_count, in the order of elimination. Only after factorize() returned true.
    void solve(Scalar* x);
    /// The same for several right-hand sides at once. `Row`: a register that holds their entries in one row.
    template <typename Row>
    void solve_together(Row* x) const;

    /// node → place in the order of elimination.
    const std::vector<int>& rank() const { return m_supernodes.rank; }
    /// Entries kept for the factor, zeros of merged supernodes included.
    long entries() const { return static_cast<long>(m_panels.size()); }

private:
    /// Where a block of the matrix goes: into which panel entry.
    struct Scatter {
        int source;  // node, or node_count + link
        int offset;  // of the block's first entry in the panel
    };

    void check_size(int node_count) const;
    void place_panels();
    void list_children();
    std::vector<int> sort_blocks(int node_count, const Eigen::Matrix2Xi& links);
    void place_entries(int node_count, const Eigen::Matrix2Xi& links);
    double deepest_stack() const;
    int panel_rows(int s) const;   // own columns and rows below, in rows of the matrix, padded
    int update_size(int s) const;  // rows below, likewise
    const Scalar* panel(int s) const { return m_panels.data() + m_panel_start[s]; }
    void take_front(int s, const Scalar* x);
    void add_update(int child, const Scalar* from, Scalar* panel, int panel_rows, Scalar* update, int update_rows,
                    int own_columns);

    Supernodes m_supernodes;
    std::vector<long> m_panel_start;   // S + 1, into m_panels
    std::vector<Scalar> m_panels;      // column-major, panel_rows(s) × size·columns(s)
    std::vector<int> m_scatter_start;  // S + 1, into m_scatter
    std::vector<Scatter> m_scatter;
    std::vector<int> m_local_row;  // as Supernodes::rows: the row's place in the parent's front, in nodes
    std::vector<int> m_run_end;    // likewise: the end of the run of rows that stand together there
    std::vector<int> m_child_start, m_children;
    std::vector<Scalar> m_stack;        // updates waiting for their parents
    std::vector<Scalar> m_reciprocals;  // of the factor's diagonal
    std::vector<Scalar> m_front;        // the rows of a right-hand side that one panel has
};

extern template class Cholesky<1, float>;
extern template class Cholesky<3, double>;
extern template class Cholesky<3, float>;

}  // namespace chebnet
