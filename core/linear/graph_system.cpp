#include "linear/graph_system.h"

#include <algorithm>

#include "linear/ordering.h"

namespace chebnet {

namespace {

void pack(const Eigen::Vector3d& numbers, Eigen::Vector3d& row) { row = numbers; }
void pack(const Eigen::Vector3d& numbers, dense::Four& row) {
    const Eigen::Vector3f single = numbers.cast<float>();
    row = dense::Four{single[0], single[1], single[2], 0};
}
const Eigen::Vector3d& unpacked(const Eigen::Vector3d& row) { return row; }
Eigen::Vector3d unpacked(const dense::Four& row) { return {row[0], row[1], row[2]}; }
double* numbers(std::vector<Eigen::Vector3d>& rows) { return rows.data()->data(); }
dense::Four* numbers(std::vector<dense::Four>& rows) { return rows.data(); }

}  // namespace

template <int size>
GraphSystem<size>::GraphSystem(int node_count, const Eigen::Matrix2Xi& links, std::vector<int> elimination_rank)
    : m_node_blocks(static_cast<std::size_t>(node_count)),
      m_link_blocks(static_cast<std::size_t>(links.cols())),
      m_links(links),
      m_permuted(static_cast<std::size_t>(node_count)) {
    if (elimination_rank.empty()) elimination_rank = fill_reducing_order(node_count, links);
    m_factor.analyze(node_count, links, elimination_rank);
    set_zero();
}

template <int size>
void GraphSystem<size>::set_zero() {
    for (Block& block : m_node_blocks) block.setZero();
    for (Block& block : m_link_blocks) block.setZero();
}

template <int size>
void GraphSystem<size>::add_at_node(int node, const Block& B) {
    m_node_blocks[node] += B;
}

template <int size>
void GraphSystem<size>::add_at_link(int link, const Block& B) {
    m_node_blocks[m_links(0, link)] += B;
    m_node_blocks[m_links(1, link)] += B;
    m_link_blocks[link] -= B;
}

template <int size>
bool GraphSystem<size>::factorize() {
    return m_factor.factorize(m_node_blocks, m_link_blocks);
}

template <int size>
void GraphSystem<size>::solve_in_place(Eigen::Matrix3Xd& x) {
    const std::vector<int>& place = elimination_rank();
    for (int i = 0; i < node_count(); ++i) pack(x.col(i), m_permuted[place[i]]);
    m_factor.solve(numbers(m_permuted));
    for (int i = 0; i < node_count(); ++i) x.col(i) = unpacked(m_permuted[place[i]]);
}

template <int size>
void GraphSystem<size>::solve_in_place(Eigen::Matrix4Xf& x) requires(size == 1) {
    const std::vector<int>& place = elimination_rank();
    for (int i = 0; i < node_count(); ++i) m_permuted[place[i]] = dense::load<dense::Four>(x.col(i).data());
    m_factor.solve(m_permuted.data());
    for (int i = 0; i < node_count(); ++i) dense::store(x.col(i).data(), m_permuted[place[i]]);
}

template class GraphSystem<1>;
template class GraphSystem<3>;

}  // namespace chebnet
