#include "linear/supernodes.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "linear/limits.h"

namespace chebnet {

namespace {

/// The graph seen from an order of elimination. Places are positions in the order.
class OrderedGraph {
public:
    OrderedGraph(int node_count, const Eigen::Matrix2Xi& links)
        : m_start(static_cast<std::size_t>(node_count) + 1, 0),
          m_neighbours(2 * static_cast<std::size_t>(links.cols())) {
        for (Eigen::Index k = 0; k < links.size(); ++k) ++m_start[links.data()[k] + 1];
        std::partial_sum(m_start.begin(), m_start.end(), m_start.begin());
        std::vector<int> next(m_start.begin(), m_start.end() - 1);
        for (Eigen::Index k = 0; k < links.cols(); ++k) {
            m_neighbours[next[links(0, k)]++] = links(1, k);
            m_neighbours[next[links(1, k)]++] = links(0, k);
        }
    }

    int size() const { return static_cast<int>(m_start.size()) - 1; }
    const std::vector<int>& rank() const { return m_rank; }
    /// `rank`: node → place.
    void set_order(std::vector<int> rank) {
        m_rank = std::move(rank);
        m_node.resize(m_rank.size());
        for (int node = 0; node < size(); ++node) m_node[m_rank[node]] = node;
    }
    /// Calls visit(place) for each neighbour of the node at a place.
    template <typename Visit>
    void for_each_neighbour(int place, Visit visit) const {
        const int node = m_node[place];
        for (int i = m_start[node]; i < m_start[node + 1]; ++i) visit(m_rank[m_neighbours[i]]);
    }

private:
    std::vector<int> m_start, m_neighbours;  // by nodes
    std::vector<int> m_rank, m_node;
};

/// Parent of each column in the elimination tree (Liu 1986), −1 for roots.
std::vector<int> elimination_tree(const OrderedGraph& graph) {
    std::vector<int> parent(static_cast<std::size_t>(graph.size()), -1), ancestor(parent);
    for (int i = 0; i < graph.size(); ++i)
        graph.for_each_neighbour(i, [&](int neighbour) {
            for (int j = neighbour; j != -1 && j < i;) {
                const int above = std::exchange(ancestor[j], i);
                if (above == -1) parent[j] = i;
                j = above;
            }
        });
    return parent;
}

/// item → place in a postorder of a forest in which parents have larger numbers than their children.
std::vector<int> postorder(const std::vector<int>& parent) {
    const int n = static_cast<int>(parent.size());
    std::vector<int> size(parent.size(), 1), place(parent.size());
    for (int j = 0; j < n; ++j)
        if (parent[j] >= 0) size[parent[j]] += size[j];
    // Going down from the roots, each child takes the last free places of its parent's block.
    std::vector<int> free_end(parent.size());
    int roots_end = n;
    for (int j = n - 1; j >= 0; --j) {
        int& end = parent[j] >= 0 ? free_end[parent[j]] : roots_end;
        place[j] = end - 1;
        free_end[j] = end - 1;
        end -= size[j];
    }
    return place;
}

/// For each column of the factor the number of its entries below the diagonal, from where the ways up the tree from the
/// earlier neighbours of each row begin and meet (Gilbert, Ng, Peyton 1994). The columns must be in postorder.
std::vector<int> column_counts(const OrderedGraph& graph, const std::vector<int>& parent) {
    const int n = graph.size();
    std::vector<int> count(parent.size(), 0), first_descendant(parent.size()), merged_with(parent.size());
    std::vector<int> latest_first(parent.size(), -1), latest_leaf(parent.size(), -1);
    std::iota(first_descendant.begin(), first_descendant.end(), 0);
    std::iota(merged_with.begin(), merged_with.end(), 0);
    for (int j = 0; j < n; ++j)
        if (parent[j] >= 0) first_descendant[parent[j]] = std::min(first_descendant[parent[j]], first_descendant[j]);
    const auto top_of = [&](int j) {
        while (merged_with[j] != j) j = merged_with[j] = merged_with[merged_with[j]];
        return j;
    };
    for (int j = 0; j < n; ++j) {
        if (first_descendant[j] == j) ++count[j];
        if (parent[j] >= 0) --count[parent[j]];
        graph.for_each_neighbour(j, [&](int row) {
            if (row <= j || first_descendant[j] <= latest_first[row]) return;
            latest_first[row] = first_descendant[j];
            ++count[j];
            const int before = std::exchange(latest_leaf[row], j);
            if (before >= 0) --count[top_of(before)];
        });
        if (parent[j] >= 0) merged_with[j] = parent[j];
    }
    for (int j = 0; j < n; ++j)
        if (parent[j] >= 0) count[parent[j]] += count[j];
    for (int& entries : count) --entries;  // the diagonal
    return count;
}

/// A supernode while supernodes are being merged.
struct Panel {
    int first_column;  // of the last of the merged supernodes, whose rows are those of all
    int own_columns;
    int columns;  // with those merged into it
    int rows;
    double zeros = 0;  // entries that merging has filled with zeros
    int parent = -1;
    int merged_into = -1;
};

double panel_entries(double columns, double rows) { return columns * (columns + 1) / 2 + columns * rows; }

/// Whether a panel so narrow may hold so many zeros: small dense operations cost more than their arithmetic.
bool worth_merging(int scalar_columns, double zero_part) {
    if (scalar_columns <= 6) return zero_part < 0.8;
    if (scalar_columns <= 12) return zero_part < 0.5;
    if (scalar_columns <= 32) return zero_part < 0.3;
    if (scalar_columns <= 64) return zero_part < 0.12;
    return zero_part < 0.05;
}

/// Runs of columns with the same rows.
std::vector<Panel> fundamental_panels(const std::vector<int>& counts, const std::vector<int>& parent) {
    const int n = static_cast<int>(parent.size());
    std::vector<Panel> panels;
    std::vector<int> panel_of_column(parent.size());
    for (int j = 0; j < n; ++j) {
        const bool continues = j > 0 && parent[j - 1] == j && counts[j - 1] == counts[j] + 1;
        if (!continues) panels.push_back({j, 0, 0, 0});
        panels.back().own_columns = ++panels.back().columns;
        panels.back().rows = counts[j];
        panel_of_column[j] = static_cast<int>(panels.size()) - 1;
    }
    for (Panel& panel : panels) {
        const int above = parent[panel.first_column + panel.own_columns - 1];
        panel.parent = above >= 0 ? panel_of_column[above] : -1;
    }
    return panels;
}

/// The places below each fundamental panel's columns, one panel after the other: the neighbours of its columns and what
/// its children leave to it, in no order. The panels must be as fundamental_panels() returned them.
std::vector<int> panel_rows(const OrderedGraph& graph, const std::vector<Panel>& panels, std::vector<int>& start) {
    double total = 0;
    for (const Panel& panel : panels) total += panel.rows;
    check_factor_bytes(graph.size(), total * sizeof(int));
    start.assign(panels.size() + 1, 0);
    for (std::size_t p = 0; p < panels.size(); ++p) start[p + 1] = start[p] + panels[p].rows;
    std::vector<int> rows(static_cast<std::size_t>(start.back()));
    std::vector<int> taken_by(static_cast<std::size_t>(graph.size()), -1);
    std::vector<int> first_child(panels.size(), -1), next_sibling(panels.size(), -1);
    for (int p = 0; p < static_cast<int>(panels.size()); ++p) {
        const int columns_end = panels[p].first_column + panels[p].own_columns;
        int end = start[p];
        const auto take = [&](int place) {
            if (place < columns_end || taken_by[place] == p) return;
            taken_by[place] = p;
            rows[end++] = place;
        };
        for (int j = panels[p].first_column; j < columns_end; ++j) graph.for_each_neighbour(j, take);
        for (int child = first_child[p]; child >= 0; child = next_sibling[child])
            for (int i = start[child]; i < start[child + 1]; ++i) take(rows[i]);
        if (panels[p].parent >= 0) next_sibling[p] = std::exchange(first_child[panels[p].parent], p);
    }
    return rows;
}

/// Merges children into parents, cheapest first, while worth_merging() says so.
void merge_small_panels(std::vector<Panel>& panels, int rows_per_node) {
    std::vector<int> children_start(panels.size() + 1, 0);
    for (const Panel& panel : panels)
        if (panel.parent >= 0) ++children_start[panel.parent + 1];
    std::partial_sum(children_start.begin(), children_start.end(), children_start.begin());
    std::vector<int> children(static_cast<std::size_t>(children_start.back()));
    std::vector<int> children_end(children_start.begin(), children_start.end() - 1);
    for (int p = 0; p < static_cast<int>(panels.size()); ++p) {
        Panel& parent = panels[p];
        const auto new_zeros = [&](const Panel& child) {
            return static_cast<double>(child.columns) * (parent.columns + parent.rows - child.rows);
        };
        const auto first = children.begin() + children_start[p], last = children.begin() + children_end[p];
        std::sort(first, last, [&](int a, int b) {
            return std::pair(new_zeros(panels[a]), a) < std::pair(new_zeros(panels[b]), b);
        });
        for (auto c = first; c != last; ++c) {
            Panel& child = panels[*c];
            const double zeros = parent.zeros + child.zeros + new_zeros(child);
            const int columns = parent.columns + child.columns;
            if (!worth_merging(columns * rows_per_node, zeros / panel_entries(columns, parent.rows))) continue;
            child.merged_into = p;
            parent.columns = columns;
            parent.zeros = zeros;
        }
        if (parent.parent >= 0) children[children_end[parent.parent]++] = p;
    }
}

/// The panel that `p` has ended up in.
int final_panel(const std::vector<Panel>& panels, int p) {
    while (panels[p].merged_into >= 0) p = panels[p].merged_into;
    return p;
}

/// Puts the columns of a tree at new places, which keep it the same tree.
void reorder(OrderedGraph& graph, std::vector<int>& parent, const std::vector<int>& new_place) {
    std::vector<int> rank = graph.rank(), new_parent(parent.size());
    for (int& place : rank) place = new_place[place];
    for (std::size_t j = 0; j < parent.size(); ++j)
        new_parent[new_place[j]] = parent[j] < 0 ? -1 : new_place[parent[j]];
    graph.set_order(std::move(rank));
    parent = std::move(new_parent);
}

}  // namespace

Supernodes find_supernodes(int node_count, const Eigen::Matrix2Xi& links, const std::vector<int>& rank,
                           int rows_per_node) {
    OrderedGraph graph(node_count, links);
    graph.set_order(rank);
    std::vector<int> parent = elimination_tree(graph);
    reorder(graph, parent, postorder(parent));

    std::vector<Panel> panels = fundamental_panels(column_counts(graph, parent), parent);
    std::vector<int> rows_start;
    const std::vector<int> rows = panel_rows(graph, panels, rows_start);
    merge_small_panels(panels, rows_per_node);

    // Number the remaining panels in a postorder of their tree, and their columns with them.
    std::vector<int> kept, kept_index(panels.size(), -1);
    for (std::size_t p = 0; p < panels.size(); ++p)
        if (panels[p].merged_into < 0) {
            kept_index[p] = static_cast<int>(kept.size());
            kept.push_back(static_cast<int>(p));
        }
    std::vector<int> kept_parent;
    kept_parent.reserve(kept.size());
    for (int p : kept)
        kept_parent.push_back(panels[p].parent < 0 ? -1 : kept_index[final_panel(panels, panels[p].parent)]);
    const std::vector<int> number = postorder(kept_parent);

    Supernodes result;
    result.parent.resize(kept.size());
    result.column_start.assign(kept.size() + 1, 0);
    result.row_start.assign(kept.size() + 1, 0);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        result.parent[number[k]] = kept_parent[k] < 0 ? -1 : number[kept_parent[k]];
        result.column_start[number[k] + 1] = panels[kept[k]].columns;
        result.row_start[number[k] + 1] = panels[kept[k]].rows;
    }
    std::partial_sum(result.column_start.begin(), result.column_start.end(), result.column_start.begin());
    std::partial_sum(result.row_start.begin(), result.row_start.end(), result.row_start.begin());

    // Columns keep their relative order within a panel, and descendants stay before ancestors.
    std::vector<int> next(result.column_start.begin(), result.column_start.end() - 1);
    std::vector<int> new_place(static_cast<std::size_t>(node_count));
    for (std::size_t p = 0; p < panels.size(); ++p) {
        const int s = number[kept_index[final_panel(panels, static_cast<int>(p))]];
        for (int k = 0; k < panels[p].own_columns; ++k) new_place[panels[p].first_column + k] = next[s]++;
    }
    result.rank = graph.rank();
    for (int& place : result.rank) place = new_place[place];

    result.rows.resize(static_cast<std::size_t>(result.row_start.back()));
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const int* below = rows.data() + rows_start[kept[k]];
        int* placed = result.rows.data() + result.row_start[number[k]];
        const int count = panels[kept[k]].rows;
        std::transform(below, below + count, placed, [&](int place) { return new_place[place]; });
        std::sort(placed, placed + count);
    }
    return result;
}

}  // namespace chebnet
