#pragma once

#include <Eigen/Core>
#include <vector>

namespace chebnet {

/// An order in which to eliminate the nodes of a graph so that a Cholesky factor stays sparse: node → place.
/// `links`: 2×K, the joined pairs of nodes, distinct.
std::vector<int> fill_reducing_order(int node_count, const Eigen::Matrix2Xi& links);

}  // namespace chebnet
