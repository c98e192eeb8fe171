#include "solve/parts/coordinate_metric.h"

#include <algorithm>
#include <utility>

namespace chebnet {

namespace {

Eigen::Matrix2Xi links_of(const NeighbourPairs& pairs, const FreePart& part) {
    Eigen::Matrix2Xi links(2, static_cast<Eigen::Index>(pairs.size()));
    Eigen::Index count = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const int i = part.node_of(pairs[k][0]), j = part.node_of(pairs[k][1]);
        if (i >= 0 && j >= 0) links.col(count++) << i, j;
    }
    links.conservativeResize(2, count);
    return links;
}

}  // namespace

CoordinateMetric::CoordinateMetric(const NeighbourPairs& pairs, const FreePart& part, Axes coordinates,
                                   std::unique_ptr<const FreePart> own_part)
    : m_pairs(pairs),
      m_coordinates(coordinates),
      m_own_part(std::move(own_part)),
      m_part(m_own_part ? *m_own_part : part),
      m_system(m_part.size(), links_of(pairs, m_part)) {
    m_single.setZero(4, m_part.size());
}

void CoordinateMetric::factorize(const NeighbourForm& form, double shift, double hold) {
    m_system.set_zero();
    int link = 0;
    for (std::size_t k = 0; k < m_pairs.size(); ++k) {
        const auto& [a, b] = m_pairs[k];
        const int i = m_part.node_of(a), j = m_part.node_of(b);
        const LaplacianSystem::Block weight(form.weight(k));
        if (i >= 0 && j >= 0)
            m_system.add_at_link(link++, weight);
        else if (i >= 0 || j >= 0)
            m_system.add_at_node(std::max(i, j), weight);
    }
    for (int i = 0; i < m_part.size(); ++i)
        m_system.add_at_node(i, LaplacianSystem::Block(form.vertex_weight(m_part.vertices()[i]) + shift));
    for (int node : m_part.floating_nodes()) m_system.add_at_node(node, LaplacianSystem::Block(hold));
    m_system.factorize();
}

void CoordinateMetric::extend(const NeighbourForm& form, Eigen::Matrix3Xd& moves) {
    m_single.setZero();
    for (std::size_t k = 0; k < m_pairs.size(); ++k) {
        const auto& [a, b] = m_pairs[k];
        const int i = m_part.node_of(a), j = m_part.node_of(b);
        const auto pull = [&](int node, int held) {
            m_single.col(node).head<3>() += (form.weight(k) * moves.col(held)).cast<float>();
        };
        if (i >= 0 && j < 0) pull(i, b);
        if (j >= 0 && i < 0) pull(j, a);
    }
    solve_to(moves);
}

void CoordinateMetric::solve(const Eigen::Matrix3Xd& from, Eigen::Matrix3Xd& to) {
    for (int i = 0; i < m_part.size(); ++i) m_single.col(i).head<3>() = from.col(m_part.vertices()[i]).cast<float>();
    solve_to(to);
}

void CoordinateMetric::solve_to(Eigen::Matrix3Xd& solution) {
    m_system.solve_in_place(m_single);
    for (int i = 0; i < m_part.size(); ++i) {
        const Eigen::Vector3d at_node = m_single.col(i).head<3>().cast<double>();
        copy_along(m_coordinates, at_node.data(), solution.col(m_part.vertices()[i]).data());
    }
}

}  // namespace chebnet
