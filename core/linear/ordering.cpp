#include "linear/ordering.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace chebnet {

std::vector<int> fill_reducing_order(int node_count, const Eigen::Matrix2Xi& links) {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(node_count + links.cols()));
    for (int i = 0; i < node_count; ++i) entries.emplace_back(i, i, 1.0);
    for (int k = 0; k < links.cols(); ++k) entries.emplace_back(links.col(k).maxCoeff(), links.col(k).minCoeff(), 1.0);
    Eigen::SparseMatrix<double> graph(node_count, node_count);
    graph.setFromTriplets(entries.begin(), entries.end());

    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
    std::vector<int> rank(static_cast<std::size_t>(node_count));
    for (int place = 0; place < node_count; ++place) rank[order.indices()[place]] = place;
    return rank;
}

}  // namespace chebnet
