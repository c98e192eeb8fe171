#include "linear/graph_system.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <utility>

namespace chebnet {

template <int size>
GraphSystem<size>::GraphSystem(int node_count, const Eigen::Matrix2Xi& links, std::vector<int> elimination_rank)
    : m_rank(std::move(elimination_rank)), m_links(links), m_permuted(size * node_count, 3 / size) {
    if (m_rank.empty()) {
        m_rank.resize(static_cast<std::size_t>(node_count));
        order_nodes(links);
    }
    build_pattern(links);
    m_factor.analyzePattern(m_upper);
}

template <int size>
void GraphSystem<size>::order_nodes(const Eigen::Matrix2Xi& links) {
    const int n = node_count();
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(links.cols()) + m_rank.size());
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 1.0);
    for (int k = 0; k < links.cols(); ++k)
        entries.emplace_back(std::max(links(0, k), links(1, k)), std::min(links(0, k), links(1, k)), 1.0);
    Eigen::SparseMatrix<double> graph(n, n);
    graph.setFromTriplets(entries.begin(), entries.end());

    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
    Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), order);
    for (int place = 0; place < n; ++place) m_rank[order.indices()[place]] = place;
}

template <int size>
void GraphSystem<size>::build_pattern(const Eigen::Matrix2Xi& links) {
    const int n = node_count();
    // For each column of blocks the links above the diagonal, sorted by row.
    std::vector<std::vector<std::pair<int, int>>> column(static_cast<std::size_t>(n));  // (row rank, link)
    for (int k = 0; k < links.cols(); ++k) {
        const auto [row, col] = std::minmax(m_rank[links(0, k)], m_rank[links(1, k)]);
        column[col].emplace_back(row, k);
    }

    m_upper.resize(size * n, size * n);
    m_upper.reserve(size * size * (links.cols() + n));
    m_diagonal_start.resize(static_cast<std::size_t>(n));
    m_link_position.resize(static_cast<std::size_t>(links.cols()));
    for (int j = 0; j < n; ++j) {
        std::sort(column[j].begin(), column[j].end());
        m_diagonal_start[j] = size * static_cast<int>(column[j].size());
        for (std::size_t t = 0; t < column[j].size(); ++t)
            m_link_position[column[j][t].second] = {j, size * static_cast<int>(t)};
        for (int c = 0; c < size; ++c) {
            m_upper.startVec(size * j + c);
            for (const auto& [row, link] : column[j])
                for (int r = 0; r < size; ++r) m_upper.insertBack(size * row + r, size * j + c) = 0;
            for (int r = 0; r <= c; ++r) m_upper.insertBack(size * j + r, size * j + c) = 0;
        }
    }
    m_upper.finalize();
}

template <int size>
void GraphSystem<size>::set_zero() {
    m_upper.coeffs().setZero();
}

template <int size>
void GraphSystem<size>::add_to_diagonal(int rank, const Block& B) {
    for (int c = 0; c < size; ++c) {
        double* entry = m_upper.valuePtr() + m_upper.outerIndexPtr()[size * rank + c] + m_diagonal_start[rank];
        for (int r = 0; r <= c; ++r) entry[r] += B(r, c);
    }
}

template <int size>
void GraphSystem<size>::add_at_node(int node, const Block& B) {
    add_to_diagonal(m_rank[node], B);
}

template <int size>
void GraphSystem<size>::add_at_link(int link, const Block& B) {
    add_to_diagonal(m_rank[m_links(0, link)], B);
    add_to_diagonal(m_rank[m_links(1, link)], B);
    // B is symmetric, so the block is the same whichever of the two nodes comes first.
    const auto [column, place] = m_link_position[link];
    for (int c = 0; c < size; ++c) {
        double* entry = m_upper.valuePtr() + m_upper.outerIndexPtr()[size * column + c] + place;
        for (int r = 0; r < size; ++r) entry[r] -= B(r, c);
    }
}

template <int size>
bool GraphSystem<size>::factorize() {
    if (!m_upper.coeffs().allFinite()) return false;
    m_factor.factorize(m_upper);
    if (m_factor.info() != Eigen::Success) return false;
    m_factor_entries = m_factor.matrixL().nestedExpression().nonZeros();
    const auto pivots = m_factor.vectorD();
    return pivots.size() == 0 || pivots.minCoeff() > 0;
}

template <int size>
Eigen::Matrix3Xd GraphSystem<size>::solve(const Eigen::Matrix3Xd& rhs) {
    // A column of 3 rows, or a row of 3 columns, in place of each other.
    const auto permuted = [&](int node) {
        return m_permuted.template middleRows<size>(size * m_rank[node]).reshaped(3, 1);
    };
    for (int i = 0; i < node_count(); ++i) permuted(i) = rhs.col(i);
    m_permuted = m_factor.solve(m_permuted);
    Eigen::Matrix3Xd x(3, node_count());
    for (int i = 0; i < node_count(); ++i) x.col(i) = permuted(i);
    return x;
}

template class GraphSystem<1>;
template class GraphSystem<3>;

}  // namespace chebnet
