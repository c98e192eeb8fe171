#include "solve/parts/laplacian_part.h"

#include <algorithm>

namespace chebnet {

namespace {

// Lighter pulls do not keep a piece of the net in place as far as single precision can tell. Then all of the piece
// resists its moves as much, which spoils no symmetry, and takes several calls of fit().
constexpr double k_least_piece_weight = 1e-2;

}  // namespace

LaplacianPart::LaplacianPart(const Net& net, const std::vector<bool>& is_free)
    : m_net(net),
      m_part(net, is_free),
      m_piece_weight(static_cast<std::size_t>(m_part.size())),
      m_system(m_part.size(), m_part.links()),
      m_residual(3, m_part.size()) {
    factorize();
}

void LaplacianPart::set_pulls(std::span<const Pull> pulls) {
    const auto scaled = [&](const Pull& pull) { return m_scale * std::min(pull.weight, k_most_pull); };
    const bool same =
        std::equal(m_pulls.begin(), m_pulls.end(), pulls.begin(), pulls.end(),
                   [&](auto& now, auto& next) { return now.vertex == next.vertex && now.weight == scaled(next); });
    m_pulls.assign(pulls.begin(), pulls.end());
    for (Pull& pull : m_pulls) pull.weight = scaled(pull);
    if (!same) factorize();
}

void LaplacianPart::scale_pulls(double scale) {
    if (scale == m_scale) return;
    for (Pull& pull : m_pulls) pull.weight *= scale / m_scale;
    m_scale = scale;
    if (!m_pulls.empty()) factorize();
}

void LaplacianPart::factorize() {
    const LaplacianSystem::Block one(1.0);
    m_system.set_zero();
    for (const FreePart::Edge& edge : m_part.edges())
        if (edge.link >= 0)
            m_system.add_at_link(edge.link, one);
        else
            m_system.add_at_node(std::max(edge.node_a, edge.node_b), one);
    std::fill(m_piece_weight.begin(), m_piece_weight.end(), 0);
    for (const Pull& pull : m_pulls) {
        const int node = m_part.node_of(pull.vertex);
        m_system.add_at_node(node, LaplacianSystem::Block(pull.weight));
        m_piece_weight[m_part.piece_of(node)] += pull.weight;
    }
    m_is_light.assign(m_piece_weight.size(), false);
    for (int root : m_part.floating_nodes()) {
        if (m_piece_weight[root] == 0) m_system.add_at_node(root, one);
        m_is_light[root] = m_piece_weight[root] > 0 && m_piece_weight[root] < k_least_piece_weight;
    }
    for (int node = 0; node < m_part.size(); ++node)
        if (m_is_light[m_part.piece_of(node)]) m_system.add_at_node(node, LaplacianSystem::Block(k_least_piece_weight));
    m_system.factorize();  // cannot fail: every piece of the graph is held somewhere
}

double LaplacianPart::fit(const Eigen::Matrix3Xd& vectors, Positions& positions) {
    m_residual.setZero();
    for (const FreePart::Edge& edge : m_part.edges()) {
        const int a = m_net.edges()(0, edge.index), b = m_net.edges()(1, edge.index);
        const Eigen::Vector3d missing = vectors.col(edge.index) - (positions.col(a) - positions.col(b));
        if (edge.node_a >= 0) m_residual.col(edge.node_a) += missing;
        if (edge.node_b >= 0) m_residual.col(edge.node_b) -= missing;
    }
    for (const Pull& pull : m_pulls)
        m_residual.col(m_part.node_of(pull.vertex)) += pull.weight * (pull.target - positions.col(pull.vertex));
    const double gradient_norm = 2 * m_residual.norm();
    m_system.solve_in_place(m_residual);
    for (int i = 0; i < m_part.size(); ++i) positions.col(m_part.vertices()[i]) += m_residual.col(i);
    return gradient_norm;
}

}  // namespace chebnet
