#include "linear/block_system.h"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <utility>

namespace chebnet {

BlockSystem::BlockSystem(int node_count, const Eigen::Matrix2Xi& links, std::vector<int> elimination_rank)
    : m_rank(std::move(elimination_rank)), m_links(links), m_permuted(3 * node_count) {
    if (m_rank.empty()) {
        m_rank.resize(static_cast<std::size_t>(node_count));
        order_nodes(links);
    }
    build_pattern(links);
    m_factor.analyzePattern(m_upper);
}

void BlockSystem::order_nodes(const Eigen::Matrix2Xi& links) {
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

void BlockSystem::build_pattern(const Eigen::Matrix2Xi& links) {
    const int n = node_count();
    // For each column of blocks the links above the diagonal, sorted by row.
    std::vector<std::vector<std::pair<int, int>>> column(static_cast<std::size_t>(n));  // (row rank, link)
    for (int k = 0; k < links.cols(); ++k) {
        const auto [row, col] = std::minmax(m_rank[links(0, k)], m_rank[links(1, k)]);
        column[col].emplace_back(row, k);
    }

    m_upper.resize(3 * n, 3 * n);
    m_upper.reserve(9 * links.cols() + 6 * n);
    m_diagonal_start.resize(static_cast<std::size_t>(n));
    m_link_position.resize(static_cast<std::size_t>(links.cols()));
    for (int j = 0; j < n; ++j) {
        std::sort(column[j].begin(), column[j].end());
        m_diagonal_start[j] = 3 * static_cast<int>(column[j].size());
        for (std::size_t t = 0; t < column[j].size(); ++t)
            m_link_position[column[j][t].second] = {j, 3 * static_cast<int>(t)};
        for (int c = 0; c < 3; ++c) {
            m_upper.startVec(3 * j + c);
            for (const auto& [row, link] : column[j])
                for (int r = 0; r < 3; ++r) m_upper.insertBack(3 * row + r, 3 * j + c) = 0;
            for (int r = 0; r <= c; ++r) m_upper.insertBack(3 * j + r, 3 * j + c) = 0;
        }
    }
    m_upper.finalize();
}

void BlockSystem::set_zero() { m_upper.coeffs().setZero(); }

void BlockSystem::add_to_diagonal(int rank, const Eigen::Matrix3d& B) {
    for (int c = 0; c < 3; ++c) {
        double* entry = m_upper.valuePtr() + m_upper.outerIndexPtr()[3 * rank + c] + m_diagonal_start[rank];
        for (int r = 0; r <= c; ++r) entry[r] += B(r, c);
    }
}

void BlockSystem::add_at_node(int node, const Eigen::Matrix3d& B) { add_to_diagonal(m_rank[node], B); }

void BlockSystem::add_at_link(int link, const Eigen::Matrix3d& B) {
    add_to_diagonal(m_rank[m_links(0, link)], B);
    add_to_diagonal(m_rank[m_links(1, link)], B);
    // B is symmetric, so the block is the same whichever of the two nodes comes first.
    const auto [column, place] = m_link_position[link];
    for (int c = 0; c < 3; ++c) {
        double* entry = m_upper.valuePtr() + m_upper.outerIndexPtr()[3 * column + c] + place;
        for (int r = 0; r < 3; ++r) entry[r] -= B(r, c);
    }
}

bool BlockSystem::factorize() {
    if (!m_upper.coeffs().allFinite()) return false;
    m_factor.factorize(m_upper);
    if (m_factor.info() != Eigen::Success) return false;
    m_factor_entries = m_factor.matrixL().nestedExpression().nonZeros();
    const auto pivots = m_factor.vectorD();
    return pivots.size() == 0 || pivots.minCoeff() > 0;
}

Eigen::Matrix3Xd BlockSystem::solve(const Eigen::Matrix3Xd& rhs) {
    for (int i = 0; i < node_count(); ++i) m_permuted.segment<3>(3 * m_rank[i]) = rhs.col(i);
    m_permuted = m_factor.solve(m_permuted);
    Eigen::Matrix3Xd x(3, node_count());
    for (int i = 0; i < node_count(); ++i) x.col(i) = m_permuted.segment<3>(3 * m_rank[i]);
    return x;
}

}  // namespace chebnet
