#include "linear/cholesky.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "linear/dense_kernels.h"

namespace chebnet {

template <int size>
int Cholesky<size>::update_size(int s) const {
    return dense::round_up(size * m_supernodes.rows_below(s), dense::k_block_rows);
}

template <int size>
int Cholesky<size>::panel_rows(int s) const {
    return size * m_supernodes.columns(s) + update_size(s);
}

template <int size>
void Cholesky<size>::analyze(int node_count, const Eigen::Matrix2Xi& links, const std::vector<int>& rank) {
    m_supernodes = find_supernodes(node_count, links, rank, size);
    place_panels();
    place_blocks(node_count, links);
    place_updates();
}

template <int size>
void Cholesky<size>::place_panels() {
    m_panel_start.assign(1, 0);
    int longest = 0;
    for (int s = 0; s < m_supernodes.count(); ++s) {
        m_panel_start.push_back(m_panel_start.back() +
                                static_cast<long>(size) * m_supernodes.columns(s) * panel_rows(s));
        longest = std::max(longest, panel_rows(s));
    }
    m_panels.resize(static_cast<std::size_t>(m_panel_start.back()));
    m_gathered.resize(3 * static_cast<std::size_t>(longest));
}

/// Where the row at `place` stands in the panel of supernode s, counted in nodes.
static int local_row(const Supernodes& supernodes, int s, int place) {
    if (place < supernodes.column_start[s + 1]) return place - supernodes.column_start[s];
    const int* rows = supernodes.rows.data() + supernodes.row_start[s];
    const int below = static_cast<int>(std::lower_bound(rows, rows + supernodes.rows_below(s), place) - rows);
    return supernodes.columns(s) + below;
}

template <int size>
void Cholesky<size>::place_blocks(int node_count, const Eigen::Matrix2Xi& links) {
    std::vector<int> supernode_of(static_cast<std::size_t>(node_count));
    for (int s = 0; s < m_supernodes.count(); ++s)
        std::fill(supernode_of.begin() + m_supernodes.column_start[s],
                  supernode_of.begin() + m_supernodes.column_start[s + 1], s);

    struct Entry {
        int supernode;
        Scatter scatter;
    };
    std::vector<Entry> entries;
    entries.reserve(static_cast<std::size_t>(node_count + links.cols()));
    const auto place = [&](int source, int low, int high) {
        const int s = supernode_of[low];
        const int column = low - m_supernodes.column_start[s];
        entries.push_back({s, {source, size * column * panel_rows(s) + size * local_row(m_supernodes, s, high)}});
    };
    for (int node = 0; node < node_count; ++node) place(node, rank()[node], rank()[node]);
    for (int k = 0; k < links.cols(); ++k) {
        const auto [low, high] = std::minmax(rank()[links(0, k)], rank()[links(1, k)]);
        place(node_count + k, low, high);
    }

    m_scatter_start.assign(static_cast<std::size_t>(m_supernodes.count()) + 1, 0);
    for (const Entry& entry : entries) ++m_scatter_start[entry.supernode + 1];
    std::partial_sum(m_scatter_start.begin(), m_scatter_start.end(), m_scatter_start.begin());
    std::vector<int> next(m_scatter_start.begin(), m_scatter_start.end() - 1);
    m_scatter.resize(entries.size());
    for (const Entry& entry : entries) m_scatter[next[entry.supernode]++] = entry.scatter;
}

template <int size>
void Cholesky<size>::place_updates() {
    const int count = m_supernodes.count();
    m_child_start.assign(static_cast<std::size_t>(count) + 1, 0);
    for (int s = 0; s < count; ++s)
        if (m_supernodes.parent[s] >= 0) ++m_child_start[m_supernodes.parent[s] + 1];
    std::partial_sum(m_child_start.begin(), m_child_start.end(), m_child_start.begin());
    m_children.resize(static_cast<std::size_t>(m_child_start.back()));
    std::vector<int> next(m_child_start.begin(), m_child_start.end() - 1);
    m_local_row.resize(m_supernodes.rows.size());
    m_run_end.resize(m_supernodes.rows.size());
    for (int s = 0; s < count; ++s) {
        const int parent = m_supernodes.parent[s];
        if (parent < 0) continue;
        m_children[next[parent]++] = s;
        const int first = m_supernodes.row_start[s], last = m_supernodes.row_start[s + 1];
        for (int i = last - 1; i >= first; --i) {
            m_local_row[i] = local_row(m_supernodes, parent, m_supernodes.rows[i]);
            const bool runs_on = i + 1 < last && m_local_row[i + 1] == m_local_row[i] + 1;
            m_run_end[i] = runs_on ? m_run_end[i + 1] : i + 1;
        }
    }

    // The deepest the stack of updates gets, a parent's update standing on its children's for a moment.
    std::size_t depth = 0, deepest = 0;
    const auto area = [&](int s) { return static_cast<std::size_t>(update_size(s)) * update_size(s); };
    for (int s = 0; s < count; ++s) {
        deepest = std::max(deepest, depth + area(s));
        for (int c = m_child_start[s]; c < m_child_start[s + 1]; ++c) depth -= area(m_children[c]);
        depth += area(s);
    }
    m_stack.resize(deepest);
}

template <int size>
bool Cholesky<size>::factorize(const std::vector<Block>& node_blocks, const std::vector<Block>& link_blocks) {
    double* stack = m_stack.data();  // the end of the updates waiting
    for (int s = 0; s < m_supernodes.count(); ++s) {
        double* panel = m_panels.data() + m_panel_start[s];
        const int columns = size * m_supernodes.columns(s), rows = panel_rows(s), below = rows - columns;
        std::fill(panel, m_panels.data() + m_panel_start[s + 1], 0.0);
        for (int i = m_scatter_start[s]; i < m_scatter_start[s + 1]; ++i) {
            const auto [source, offset] = m_scatter[i];
            const int nodes = static_cast<int>(node_blocks.size());
            const Block& block = source < nodes ? node_blocks[source] : link_blocks[source - nodes];
            for (int c = 0; c < size; ++c)
                for (int r = 0; r < size; ++r) panel[offset + c * rows + r] = block(r, c);
        }

        double* update = stack;
        const std::size_t area = static_cast<std::size_t>(below) * below;
        std::fill(update, update + area, 0.0);
        double* taken = stack;  // where the children's updates begin
        for (int c = m_child_start[s + 1] - 1; c >= m_child_start[s]; --c) {
            const int child = m_children[c];
            taken -= static_cast<std::size_t>(update_size(child)) * update_size(child);
            add_update(child, taken, panel, rows, update, below, columns);
        }
        if (!dense::factor_panel(panel, rows, rows, columns)) return false;
        dense::subtract_outer_product(update, below, panel + columns, rows, below, columns);
        std::copy(update, update + area, taken);  // downwards, so that overlap does no harm
        stack = taken + area;
    }
    return true;
}

/// Adds the update of a child to the panel and the update of its parent: its lower triangle, column by column, in runs
/// of rows that stand together in the parent too.
template <int size>
void Cholesky<size>::add_update(int child, const double* from, double* panel, int panel_rows, double* update,
                                int update_rows, int own_columns) {
    const int first = m_supernodes.row_start[child], last = m_supernodes.row_start[child + 1];
    const int ld = update_size(child);
    for (int j = first; j < last; ++j)
        for (int c = 0; c < size; ++c) {
            const int column = size * m_local_row[j] + c;
            // So that rows of the parent's front count from here, whether the column is its own or of its update.
            double* to = column < own_columns
                             ? panel + static_cast<long>(column) * panel_rows
                             : update + static_cast<long>(column - own_columns) * update_rows - own_columns;
            const double* source = from + static_cast<long>(size * (j - first) + c) * ld;
            for (int i = j; i < last; i = m_run_end[i]) {
                double* target = to + size * m_local_row[i];
                const double* part = source + size * (i - first);
                const int length = size * (m_run_end[i] - i);
                for (int k = 0; k < length; ++k) target[k] += part[k];
            }
        }
}

template <int size>
template <int right_hand_sides>
void Cholesky<size>::solve(double* x) {
    constexpr int R = right_hand_sides;
    // Forward: L y = x. Each panel's rows are gathered, one right-hand side after the other.
    for (int s = 0; s < m_supernodes.count(); ++s) {
        const double* L = m_panels.data() + m_panel_start[s];
        const int columns = size * m_supernodes.columns(s), rows = panel_rows(s);
        double* own = x + static_cast<long>(size) * R * m_supernodes.column_start[s];
        for (int r = 0; r < R; ++r) {
            double* y = m_gathered.data() + r * rows;
            for (int j = 0; j < columns; ++j) y[j] = own[j * R + r];
            std::fill(y + columns, y + rows, 0.0);
            for (int j = 0; j < columns; ++j) {
                const double* column = L + static_cast<long>(j) * rows;
                const double value = y[j] /= column[j];
                for (int i = j + 1; i < rows; ++i) y[i] -= column[i] * value;
            }
            for (int j = 0; j < columns; ++j) own[j * R + r] = y[j];
        }
        scatter_add<R>(s, x);
    }
    // Backward: Lᵀ x = y.
    for (int s = m_supernodes.count() - 1; s >= 0; --s) {
        const double* L = m_panels.data() + m_panel_start[s];
        const int columns = size * m_supernodes.columns(s), rows = panel_rows(s);
        double* own = x + static_cast<long>(size) * R * m_supernodes.column_start[s];
        gather<R>(s, x);
        for (int r = 0; r < R; ++r) {
            double* y = m_gathered.data() + r * rows;
            for (int j = 0; j < columns; ++j) y[j] = own[j * R + r];
            for (int j = columns - 1; j >= 0; --j) {
                const double* column = L + static_cast<long>(j) * rows;
                y[j] = (y[j] - dense::dot(column + j + 1, y + j + 1, rows - j - 1)) / column[j];
            }
            for (int j = 0; j < columns; ++j) own[j * R + r] = y[j];
        }
    }
}

/// Adds the gathered rows below panel s to the right-hand sides.
template <int size>
template <int R>
void Cholesky<size>::scatter_add(int s, double* x) const {
    const int columns = size * m_supernodes.columns(s), rows = panel_rows(s);
    const int* places = m_supernodes.rows.data() + m_supernodes.row_start[s];
    for (int i = 0; i < m_supernodes.rows_below(s); ++i)
        for (int k = 0; k < size; ++k)
            for (int r = 0; r < R; ++r)
                x[(static_cast<long>(size) * places[i] + k) * R + r] += m_gathered[r * rows + columns + size * i + k];
}

/// Gathers the rows below panel s, padding included.
template <int size>
template <int R>
void Cholesky<size>::gather(int s, const double* x) {
    const int columns = size * m_supernodes.columns(s), rows = panel_rows(s);
    const int* places = m_supernodes.rows.data() + m_supernodes.row_start[s];
    const int below = size * m_supernodes.rows_below(s);
    for (int r = 0; r < R; ++r)
        std::fill_n(m_gathered.data() + r * rows + columns + below, rows - columns - below, 0.0);
    for (int i = 0; i < m_supernodes.rows_below(s); ++i)
        for (int k = 0; k < size; ++k)
            for (int r = 0; r < R; ++r)
                m_gathered[r * rows + columns + size * i + k] = x[(static_cast<long>(size) * places[i] + k) * R + r];
}

template class Cholesky<1>;
template class Cholesky<3>;
template void Cholesky<1>::solve<3>(double*);
template void Cholesky<3>::solve<1>(double*);
template void Cholesky<1>::solve<1>(double*);

}  // namespace chebnet
