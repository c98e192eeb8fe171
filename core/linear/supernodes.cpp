#include "linear/supernodes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace chebnet {

namespace {

/// Lists of ints, one after the other.
struct Lists {
    std::vector<int> start, entries;
    const int* begin(int i) const { return entries.data() + start[i]; }
    const int* end(int i) const { return entries.data() + start[i + 1]; }
};

/// For each place its neighbours at later places (or earlier ones), by counting sort.
Lists neighbours_by_place(int n, const Eigen::Matrix2Xi& links, const std::vector<int>& rank, bool later) {
    Lists lists;
    lists.start.assign(static_cast<std::size_t>(n) + 1, 0);
    lists.entries.resize(static_cast<std::size_t>(links.cols()));
    const auto ends = [&](Eigen::Index k) {
        const auto [low, high] = std::minmax(rank[links(0, k)], rank[links(1, k)]);
        return later ? std::pair(low, high) : std::pair(high, low);
    };
    for (Eigen::Index k = 0; k < links.cols(); ++k) ++lists.start[ends(k).first + 1];
    std::partial_sum(lists.start.begin(), lists.start.end(), lists.start.begin());
    std::vector<int> next(lists.start.begin(), lists.start.end() - 1);
    for (Eigen::Index k = 0; k < links.cols(); ++k) {
        const auto [at, other] = ends(k);
        lists.entries[next[at]++] = other;
    }
    return lists;
}

/// Parent of each column in the elimination tree (Liu 1986), −1 for roots.
std::vector<int> elimination_tree(int n, const Lists& earlier) {
    std::vector<int> parent(static_cast<std::size_t>(n), -1), ancestor(static_cast<std::size_t>(n), -1);
    for (int i = 0; i < n; ++i)
        for (const int* k = earlier.begin(i); k != earlier.end(i); ++k)
            for (int j = *k; j != -1 && j != i;) {
                const int above = std::exchange(ancestor[j], i);
                if (above == -1) parent[j] = i;
                j = above;
            }
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

/// For each column of the factor the places of its entries below the diagonal, ascending.
std::vector<std::vector<int>> column_structures(int n, const Lists& later, const std::vector<int>& parent) {
    std::vector<std::vector<int>> structure(static_cast<std::size_t>(n));
    std::vector<int> mark(static_cast<std::size_t>(n), -1);
    std::vector<int> first_child(static_cast<std::size_t>(n), -1), next_sibling(static_cast<std::size_t>(n), -1);
    for (int j = 0; j < n; ++j) {
        std::vector<int>& rows = structure[j];
        const auto take = [&](int i) {
            if (i <= j || mark[i] == j) return;
            mark[i] = j;
            rows.push_back(i);
        };
        for (const int* i = later.begin(j); i != later.end(j); ++i) take(*i);
        for (int child = first_child[j]; child >= 0; child = next_sibling[child])
            for (int i : structure[child]) take(i);
        std::sort(rows.begin(), rows.end());
        if (parent[j] >= 0) next_sibling[j] = std::exchange(first_child[parent[j]], j);
    }
    return structure;
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
    if (scalar_columns <= 12) return zero_part < 0.8;
    if (scalar_columns <= 32) return zero_part < 0.3;
    if (scalar_columns <= 64) return zero_part < 0.12;
    return zero_part < 0.05;
}

/// Runs of columns with the same rows.
std::vector<Panel> fundamental_panels(const std::vector<std::vector<int>>& structure, const std::vector<int>& parent) {
    const int n = static_cast<int>(parent.size());
    std::vector<Panel> panels;
    std::vector<int> panel_of_column(parent.size());
    for (int j = 0; j < n; ++j) {
        const bool continues = j > 0 && parent[j - 1] == j && structure[j - 1].size() == structure[j].size() + 1;
        if (!continues) panels.push_back({j, 0, 0, 0});
        panels.back().own_columns = ++panels.back().columns;
        panels.back().rows = static_cast<int>(structure[j].size());
        panel_of_column[j] = static_cast<int>(panels.size()) - 1;
    }
    for (Panel& panel : panels) {
        const int above = parent[panel.first_column + panel.own_columns - 1];
        panel.parent = above >= 0 ? panel_of_column[above] : -1;
    }
    return panels;
}

/// Merges children into parents, cheapest first, while worth_merging() says so.
void merge_small_panels(std::vector<Panel>& panels, int rows_per_node) {
    std::vector<std::vector<int>> children(panels.size());
    for (std::size_t p = 0; p < panels.size(); ++p) {
        Panel& parent = panels[p];
        std::vector<int> candidates = children[p];
        std::sort(candidates.begin(), candidates.end(), [&](int a, int b) {
            const auto new_zeros = [&](const Panel& c) {
                return static_cast<double>(c.columns) * (parent.columns + parent.rows - c.rows);
            };
            return std::pair(new_zeros(panels[a]), a) < std::pair(new_zeros(panels[b]), b);
        });
        for (int c : candidates) {
            Panel& child = panels[c];
            const double zeros = parent.zeros + child.zeros +
                                 static_cast<double>(child.columns) * (parent.columns + parent.rows - child.rows);
            const int columns = parent.columns + child.columns;
            if (!worth_merging(columns * rows_per_node, zeros / panel_entries(columns, parent.rows))) continue;
            child.merged_into = static_cast<int>(p);
            parent.columns = columns;
            parent.zeros = zeros;
        }
        if (parent.parent >= 0) children[parent.parent].push_back(static_cast<int>(p));
    }
}

/// The panel that `p` has ended up in.
int final_panel(const std::vector<Panel>& panels, int p) {
    while (panels[p].merged_into >= 0) p = panels[p].merged_into;
    return p;
}

}  // namespace

Supernodes find_supernodes(int node_count, const Eigen::Matrix2Xi& links, const std::vector<int>& rank,
                           int rows_per_node) {
    std::vector<int> places = rank;
    const auto relabel = [&](const std::vector<int>& new_place) {
        for (int& place : places) place = new_place[place];
    };
    relabel(postorder(elimination_tree(node_count, neighbours_by_place(node_count, links, places, false))));
    const std::vector<int> parent = elimination_tree(node_count, neighbours_by_place(node_count, links, places, false));
    const auto structure = column_structures(node_count, neighbours_by_place(node_count, links, places, true), parent);

    std::vector<Panel> panels = fundamental_panels(structure, parent);
    merge_small_panels(panels, rows_per_node);

    // Number the remaining panels in a postorder of their tree, and their columns with them.
    std::vector<int> kept, kept_index(panels.size(), -1);
    for (std::size_t p = 0; p < panels.size(); ++p)
        if (panels[p].merged_into < 0) {
            kept_index[p] = static_cast<int>(kept.size());
            kept.push_back(static_cast<int>(p));
        }
    std::vector<int> kept_parent;
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
    relabel(new_place);
    result.rank = std::move(places);

    result.rows.resize(static_cast<std::size_t>(result.row_start.back()));
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const Panel& panel = panels[kept[k]];
        const std::vector<int>& below = structure[panel.first_column + panel.own_columns - 1];
        int* rows = result.rows.data() + result.row_start[number[k]];
        std::transform(below.begin(), below.end(), rows, [&](int place) { return new_place[place]; });
        std::sort(rows, rows + below.size());
    }
    return result;
}

}  // namespace chebnet
