#include "solve/laplacian_part.h"

#include <algorithm>

namespace chebnet {

LaplacianPart::LaplacianPart(const Net& net, const std::vector<bool>& is_free)
    : m_net(net), m_part(net, is_free), m_system(m_part.size(), m_part.links()), m_residual(3, m_part.size()) {
    const LaplacianSystem::Block one(1.0);
    m_system.set_zero();
    for (const FreePart::Edge& edge : m_part.edges())
        if (edge.link >= 0)
            m_system.add_at_link(edge.link, one);
        else
            m_system.add_at_node(std::max(edge.node_a, edge.node_b), one);
    for (int node : m_part.floating_nodes()) m_system.add_at_node(node, one);
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
    const double gradient_norm = 2 * m_residual.norm();
    m_system.solve_in_place(m_residual);
    for (int i = 0; i < m_part.size(); ++i) positions.col(m_part.vertices()[i]) += m_residual.col(i);
    return gradient_norm;
}

}  // namespace chebnet
