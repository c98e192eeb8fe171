#pragma once

#include <Eigen/Core>
#include <vector>

namespace chebnet {

/// The symbolic factorisation of a sparse symmetric matrix on a graph of nodes: which columns of the Cholesky factor
/// are kept together as a dense panel (a supernode), and which rows each panel has below its own columns.
///
/// "Place" is a node's position in the order of elimination. Supernodes are numbered in a postorder of their tree:
/// children come before their parent, and the columns of a supernode are consecutive places.
struct Supernodes {
    std::vector<int> rank;  ///< node → place
    std::vector<int>
        column_start;  ///< S + 1: supernode s has the columns (places) column_start[s] … column_start[s+1]−1
    std::vector<int> row_start;  ///< S + 1: the part of `rows` that belongs to each supernode
    std::vector<int> rows;       ///< places below the supernode's columns, ascending
    std::vector<int> parent;     ///< S: the supernode that takes over the rest of s; −1 for a root

    int count() const { return static_cast<int>(parent.size()); }
    int columns(int s) const { return column_start[s + 1] - column_start[s]; }
    int rows_below(int s) const { return row_start[s + 1] - row_start[s]; }
};

/// Analyses the graph of `node_count` nodes and `links` (2×K, distinct pairs). `rank`: node → place in a fill-reducing
/// order; the result's rank is an equivalent order (the same fill). `rows_per_node`: how many rows of the matrix a node
/// stands for, by which supernodes too small to be worth a dense panel are found and merged, at the price of some
/// zeros. Throws Error too_large if their rows alone would take more than k_most_factor_bytes.
Supernodes find_supernodes(int node_count, const Eigen::Matrix2Xi& links, const std::vector<int>& rank,
                           int rows_per_node);

}  // namespace chebnet
