#include "linear/cholesky.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

#include "linear/limits.h"

namespace chebnet {

template <int size, typename Scalar>
int Cholesky<size, Scalar>::update_size(int s) const {
    return dense::round_up(size * m_supernodes.rows_below(s), dense::k_row_multiple);
}

template <int size, typename Scalar>
int Cholesky<size, Scalar>::panel_rows(int s) const {
    return size * m_supernodes.columns(s) + update_size(s);
}

template <int size, typename Scalar>
void Cholesky<size, Scalar>::analyze(int node_count, const Eigen::Matrix2Xi& links, const std::vector<int>& rank) {
    m_supernodes = find_supernodes(node_count, links, rank, size);
    list_children();
    check_size(node_count);
    place_panels();
    place_entries(node_count, links);
    m_stack.resize(static_cast<std::size_t>(deepest_stack()));
}

template <int size, typename Scalar>
void Cholesky<size, Scalar>::check_size(int node_count) const {
    double entries = deepest_stack();
    for (int s = 0; s < m_supernodes.count(); ++s)
        entries += static_cast<double>(size) * m_supernodes.columns(s) * panel_rows(s);
    check_factor_bytes(size * node_count, entries * sizeof(Scalar));
}

template <int size, typename Scalar>
void Cholesky<size, Scalar>::place_panels() {
    m_panel_start.assign(1, 0);
    int longest = 0;
    for (int s = 0; s < m_supernodes.count(); ++s) {
        m_panel_start.push_back(m_panel_start.back() +
                                static_cast<long>(size) * m_supernodes.columns(s) * panel_rows(s));
        longest = std::max(longest, panel_rows(s));
    }
    m_panels.resize(static_cast<std::size_t>(m_panel_start.back()));
    m_front.resize(static_cast<std::size_t>(longest));
    m_reciprocals.resize(size * rank().size());
}

template <int size, typename Scalar>
void Cholesky<size, Scalar>::list_children() {
    const int count = m_supernodes.count();
    m_child_start.assign(static_cast<std::size_t>(count) + 1, 0);
    for (int s = 0; s < count; ++s)
        if (m_supernodes.parent[s] >= 0) ++m_child_start[m_supernodes.parent[s] + 1];
    std::partial_sum(m_child_start.begin(), m_child_start.end(), m_child_start.begin());
    m_children.resize(static_cast<std::size_t>(m_child_start.back()));
    std::vector<int> next(m_child_start.begin(), m_child_start.end() - 1);
    for (int s = 0; s < count; ++s)
        if (m_supernodes.parent[s] >= 0) m_children[next[m_supernodes.parent[s]]++] = s;
}

/// Sorts the blocks of the matrix by the supernodes they go to, with the places of their rows in lieu of offsets.
/// Returns the places of their columns.
template <int size, typename Scalar>
std::vector<int> Cholesky<size, Scalar>::sort_blocks(int node_count, const Eigen::Matrix2Xi& links) {
    std::vector<int> supernode_of(static_cast<std::size_t>(node_count));
    for (int s = 0; s < m_supernodes.count(); ++s)
        std::fill(supernode_of.begin() + m_supernodes.column_start[s],
                  supernode_of.begin() + m_supernodes.column_start[s + 1], s);
    const auto ends = [&](int source) {
        if (source < node_count) return std::pair(rank()[source], rank()[source]);
        const int a = rank()[links(0, source - node_count)], b = rank()[links(1, source - node_count)];
        return std::pair(std::min(a, b), std::max(a, b));
    };
    const int blocks = node_count + static_cast<int>(links.cols());
    m_scatter_start.assign(static_cast<std::size_t>(m_supernodes.count()) + 1, 0);
    for (int source = 0; source < blocks; ++source) ++m_scatter_start[supernode_of[ends(source).first] + 1];
    std::partial_sum(m_scatter_start.begin(), m_scatter_start.end(), m_scatter_start.begin());
    std::vector<int> next(m_scatter_start.begin(), m_scatter_start.end() - 1);
    m_scatter.resize(static_cast<std::size_t>(blocks));
    std::vector<int> columns(m_scatter.size());
    for (int source = 0; source < blocks; ++source) {
        const auto [low, high] = ends(source);
        const int i = next[supernode_of[low]]++;
        m_scatter[i] = {source, high};
        columns[i] = low;
    }
    return columns;
}

/// Finds, panel by panel, where the blocks of the matrix go and where the updates of the children are added.
template <int size, typename Scalar>
void Cholesky<size, Scalar>::place_entries(int node_count, const Eigen::Matrix2Xi& links) {
    const std::vector<int> block_columns = sort_blocks(node_count, links);
    m_local_row.resize(m_supernodes.rows.size());
    m_run_end.resize(m_supernodes.rows.size());
    std::vector<int> local_row(static_cast<std::size_t>(node_count));  // of the places that the present panel has
    for (int s = 0; s < m_supernodes.count(); ++s) {
        const int first_column = m_supernodes.column_start[s], columns = m_supernodes.columns(s);
        const int* rows_below = m_supernodes.rows.data() + m_supernodes.row_start[s];
        for (int j = 0; j < columns; ++j) local_row[first_column + j] = j;
        for (int i = 0; i < m_supernodes.rows_below(s); ++i) local_row[rows_below[i]] = columns + i;

        const int column_length = size * panel_rows(s);
        for (int i = m_scatter_start[s]; i < m_scatter_start[s + 1]; ++i) {
            int& offset = m_scatter[i].offset;
            offset = column_length * (block_columns[i] - first_column) + size * local_row[offset];
        }
        for (int c = m_child_start[s]; c < m_child_start[s + 1]; ++c) {
            const int first = m_supernodes.row_start[m_children[c]], last = m_supernodes.row_start[m_children[c] + 1];
            for (int i = last - 1; i >= first; --i) {
                m_local_row[i] = local_row[m_supernodes.rows[i]];
                const bool runs_on = i + 1 < last && m_local_row[i + 1] == m_local_row[i] + 1;
                m_run_end[i] = runs_on ? m_run_end[i + 1] : i + 1;
            }
        }
    }
}

/// How deep the stack of updates gets, a parent's update standing on its children's for a moment.
template <int size, typename Scalar>
double Cholesky<size, Scalar>::deepest_stack() const {
    double depth = 0, deepest = 0;  // whole numbers that may be larger than any integer here
    const auto area = [&](int s) { return static_cast<double>(update_size(s)) * update_size(s); };
    for (int s = 0; s < m_supernodes.count(); ++s) {
        deepest = std::max(deepest, depth + area(s));
        for (int c = m_child_start[s]; c < m_child_start[s + 1]; ++c) depth -= area(m_children[c]);
        depth += area(s);
    }
    return deepest;
}

template <int size, typename Scalar>
bool Cholesky<size, Scalar>::factorize(const std::vector<Block>& node_blocks, const std::vector<Block>& link_blocks) {
    Scalar* stack = m_stack.data();  // the end of the updates waiting
    for (int s = 0; s < m_supernodes.count(); ++s) {
        Scalar* panel = m_panels.data() + m_panel_start[s];
        const int columns = size * m_supernodes.columns(s), rows = panel_rows(s), below = rows - columns;
        std::fill(panel, m_panels.data() + m_panel_start[s + 1], Scalar(0));
        for (int i = m_scatter_start[s]; i < m_scatter_start[s + 1]; ++i) {
            const auto [source, offset] = m_scatter[i];
            const int nodes = static_cast<int>(node_blocks.size());
            const Block& block = source < nodes ? node_blocks[source] : link_blocks[source - nodes];
            for (int c = 0; c < size; ++c)
                for (int r = 0; r < size; ++r) panel[offset + c * rows + r] = static_cast<Scalar>(block(r, c));
        }

        Scalar* update = stack;
        const std::size_t area = static_cast<std::size_t>(below) * below;
        std::fill(update, update + area, Scalar(0));
        Scalar* taken = stack;  // where the children's updates begin
        for (int c = m_child_start[s + 1] - 1; c >= m_child_start[s]; --c) {
            const int child = m_children[c];
            taken -= static_cast<std::size_t>(update_size(child)) * update_size(child);
            add_update(child, taken, panel, rows, update, below, columns);
        }
        if (!dense::factor_panel(panel, rows, rows, columns)) return false;
        for (int j = 0; j < columns; ++j)
            m_reciprocals[size * m_supernodes.column_start[s] + j] = 1 / panel[static_cast<long>(j) * rows + j];
        dense::subtract_outer_product(update, below, panel + columns, rows, below, columns);
        std::copy(update, update + area, taken);  // downwards, so that overlap does no harm
        stack = taken + area;
    }
    return true;
}

/// Adds the update of a child to the panel and the update of its parent: its lower triangle, column by column, in runs
/// of rows that stand together in the parent too.
template <int size, typename Scalar>
void Cholesky<size, Scalar>::add_update(int child, const Scalar* from, Scalar* panel, int panel_rows, Scalar* update,
                                        int update_rows, int own_columns) {
    const int first = m_supernodes.row_start[child], last = m_supernodes.row_start[child + 1];
    const int ld = update_size(child);
    for (int j = first; j < last; ++j)
        for (int c = 0; c < size; ++c) {
            const int column = size * m_local_row[j] + c;
            // So that rows of the parent's front count from here, whether the column is its own or of its update.
            Scalar* to = column < own_columns
                             ? panel + static_cast<long>(column) * panel_rows
                             : update + static_cast<long>(column - own_columns) * update_rows - own_columns;
            const Scalar* source = from + static_cast<long>(size * (j - first) + c) * ld;
            for (int i = j; i < last; i = m_run_end[i]) {
                Scalar* target = to + size * m_local_row[i];
                const Scalar* part = source + size * (i - first);
                const int length = size * (m_run_end[i] - i);
                for (int k = 0; k < length; ++k) target[k] += part[k];
            }
        }
}

/// The rows that a panel has, its own and those below, are together in m_front while it is at work.
template <int size, typename Scalar>
void Cholesky<size, Scalar>::solve(Scalar* x) {
    Scalar* front = m_front.data();
    for (int s = 0; s < m_supernodes.count(); ++s) {
        const int first = size * m_supernodes.column_start[s], columns = size * m_supernodes.columns(s);
        take_front(s, x);
        dense::solve_panel(panel(s), panel_rows(s), columns, m_reciprocals.data() + first, front);
        std::copy_n(front, columns, x + first);
        const int* places = m_supernodes.rows.data() + m_supernodes.row_start[s];
        for (int i = 0; i < m_supernodes.rows_below(s); ++i)
            std::copy_n(front + columns + size * i, size, x + static_cast<long>(size) * places[i]);
    }
    for (int s = m_supernodes.count() - 1; s >= 0; --s) {
        const int first = size * m_supernodes.column_start[s], columns = size * m_supernodes.columns(s);
        take_front(s, x);
        dense::solve_transposed_panel(panel(s), panel_rows(s), columns, m_reciprocals.data() + first, front);
        std::copy_n(front, columns, x + first);
    }
}

template <int size, typename Scalar>
void Cholesky<size, Scalar>::take_front(int s, const Scalar* x) {
    const int* places = m_supernodes.rows.data() + m_supernodes.row_start[s];
    const int first = size * m_supernodes.column_start[s];
    Scalar* to = std::copy_n(x + first, size * m_supernodes.columns(s), m_front.data());
    for (int i = 0; i < m_supernodes.rows_below(s); ++i)
        to = std::copy_n(x + static_cast<long>(size) * places[i], size, to);
    std::fill(to, m_front.data() + panel_rows(s), Scalar(0));
}

template <int size, typename Scalar>
template <typename Row>
void Cholesky<size, Scalar>::solve_together(Row* x) const {
    static_assert(size == 1);
    for (int s = 0; s < m_supernodes.count(); ++s) {
        const Scalar* L = panel(s);
        const int columns = m_supernodes.columns(s), rows = panel_rows(s);
        const int* places = m_supernodes.rows.data() + m_supernodes.row_start[s];
        Row* own = x + m_supernodes.column_start[s];
        dense::solve_triangle(L, rows, columns, own);
        dense::subtract_product_at(x, places, L + columns, rows, m_supernodes.rows_below(s), columns, own);
    }
    for (int s = m_supernodes.count() - 1; s >= 0; --s) {
        const Scalar* L = panel(s);
        const int columns = m_supernodes.columns(s), rows = panel_rows(s);
        const int* places = m_supernodes.rows.data() + m_supernodes.row_start[s];
        Row* own = x + m_supernodes.column_start[s];
        dense::subtract_transposed_product_at(own, L + columns, rows, m_supernodes.rows_below(s), columns, x, places);
        dense::solve_transposed_triangle(L, rows, columns, own);
    }
}

template class Cholesky<1, float>;
template class Cholesky<3, double>;
template class Cholesky<3, float>;
template void Cholesky<1, float>::solve_together(dense::Four*) const;

}  // namespace chebnet
