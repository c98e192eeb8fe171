#include "solve/parts/neighbour_system.h"

#include "linear/ordering.h"

namespace chebnet {

NeighbourSystem::NeighbourSystem(const NeighbourPairs& pairs, const FreePart& part)
    : m_pairs(pairs), m_part(part), m_link_of_pair(pairs.size(), -1) {
    Eigen::Matrix2Xi links(2, static_cast<Eigen::Index>(pairs.size()));
    int count = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const int i = part.node_of(pairs[k][0]), j = part.node_of(pairs[k][1]);
        if (i < 0 || j < 0) continue;
        links.col(count) << i, j;
        m_link_of_pair[k] = count++;
    }
    links.conservativeResize(2, count);
    m_factor.analyze(part.size(), links, fill_reducing_order(part.size(), links));
    m_node_blocks.resize(static_cast<std::size_t>(part.size()));
    m_link_blocks.resize(static_cast<std::size_t>(count));
    m_permuted.resize(3 * part.size());
}

void NeighbourSystem::set_zero() {
    for (Eigen::Matrix3d& block : m_node_blocks) block.setZero();
    for (Eigen::Matrix3d& block : m_link_blocks) block.setZero();
}

void NeighbourSystem::add_vertex(int vertex, const Eigen::Matrix3d& B) {
    const int node = m_part.node_of(vertex);
    if (node >= 0) m_node_blocks[node] += B;
}

/// The factor wants the block whose rows are those of the vertex that is eliminated later.
void NeighbourSystem::add_pair(int row_vertex, int column_vertex, const Eigen::Matrix3d& B) {
    const int i = m_part.node_of(row_vertex), j = m_part.node_of(column_vertex);
    if (i < 0 || j < 0) return;
    Eigen::Matrix3d& block = m_link_blocks[m_link_of_pair[m_pairs.find(row_vertex, column_vertex)]];
    if (m_factor.rank()[i] > m_factor.rank()[j])
        block += B;
    else
        block += B.transpose();
}

void NeighbourSystem::solve(const Eigen::Matrix3Xd& from, Eigen::Matrix3Xd& to) {
    for (int i = 0; i < m_part.size(); ++i)
        m_permuted.segment<3>(3 * m_factor.rank()[i]) = from.col(m_part.vertices()[i]).cast<float>();
    m_factor.solve(m_permuted.data());
    for (int i = 0; i < m_part.size(); ++i)
        to.col(m_part.vertices()[i]) = m_permuted.segment<3>(3 * m_factor.rank()[i]).cast<double>();
}

}  // namespace chebnet
