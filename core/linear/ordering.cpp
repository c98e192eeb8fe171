#include "linear/ordering.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <numeric>

namespace chebnet {

std::vector<int> fill_reducing_order(int node_count, const Eigen::Matrix2Xi& links) {
    // The lower triangle of the matrix, column by column.
    std::vector<int> start(static_cast<std::size_t>(node_count) + 1, 0);
    for (int i = 0; i < node_count; ++i) ++start[i + 1];
    for (int k = 0; k < links.cols(); ++k) ++start[links.col(k).minCoeff() + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> next(start.begin(), start.end() - 1), rows(static_cast<std::size_t>(start.back()));
    for (int i = 0; i < node_count; ++i) rows[next[i]++] = i;
    for (int k = 0; k < links.cols(); ++k) rows[next[links.col(k).minCoeff()]++] = links.col(k).maxCoeff();
    const std::vector<double> ones(rows.size(), 1.0);
    const Eigen::Map<const Eigen::SparseMatrix<double>> graph(node_count, node_count, start.back(), start.data(),
                                                              rows.data(), ones.data());

    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
    std::vector<int> rank(static_cast<std::size_t>(node_count));
    for (int place = 0; place < node_count; ++place) rank[order.indices()[place]] = place;
    return rank;
}

}  // namespace chebnet
