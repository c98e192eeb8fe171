#include "linear/graph_system.h"

#include <algorithm>

#include "linear/ordering.h"

namespace chebnet {

namespace {

using Column = Eigen::Ref<Eigen::Vector3d>;
using SingleColumn = Eigen::Ref<Eigen::Vector4f>;

void pack(const Column& column, Eigen::Vector3d& row) { row = column; }
void pack(const Column& column, dense::Four& row) {
    const Eigen::Vector3f single = column.cast<float>();
    row = dense::Four{single[0], single[1], single[2], 0};
}
void pack(const SingleColumn& column, dense::Four& row) { row = dense::load<dense::Four>(column.data()); }
void pack(const Column& column, Eigen::Vector3f& row) { row = column.cast<float>(); }
void unpack(const Eigen::Vector3d& row, Column column) { column = row; }
void unpack(const Eigen::Vector3f& row, Column column) { column = row.cast<double>(); }
void unpack(const dense::Four& row, Column column) { column << row[0], row[1], row[2]; }
void unpack(const dense::Four& row, SingleColumn column) { dense::store(column.data(), row); }

}  // namespace

template <int size, typename Scalar>
GraphSystem<size, Scalar>::GraphSystem(int node_count, const Eigen::Matrix2Xi& links, std::vector<int> elimination_rank)
    : m_links(links) {
    if (elimination_rank.empty()) elimination_rank = fill_reducing_order(node_count, links);
    m_factor.analyze(node_count, links, elimination_rank);  // first of all: it refuses what is too large
    m_node_blocks.resize(static_cast<std::size_t>(node_count));
    m_link_blocks.resize(static_cast<std::size_t>(links.cols()));
    m_permuted.resize(static_cast<std::size_t>(node_count));
    set_zero();
}

template <int size, typename Scalar>
void GraphSystem<size, Scalar>::set_zero() {
    for (Block& block : m_node_blocks) block.setZero();
    for (Block& block : m_link_blocks) block.setZero();
}

template <int size, typename Scalar>
void GraphSystem<size, Scalar>::add_at_node(int node, const Block& B) {
    m_node_blocks[node] += B;
}

template <int size, typename Scalar>
void GraphSystem<size, Scalar>::add_at_link(int link, const Block& B) {
    m_node_blocks[m_links(0, link)] += B;
    m_node_blocks[m_links(1, link)] += B;
    m_link_blocks[link] -= B;
}

template <int size, typename Scalar>
bool GraphSystem<size, Scalar>::factorize() {
    return m_factor.factorize(m_node_blocks, m_link_blocks);
}

template <int size, typename Scalar>
template <typename Vectors>
void GraphSystem<size, Scalar>::solve_in_place(Vectors& x) {
    const std::vector<int>& place = elimination_rank();
    for (int i = 0; i < node_count(); ++i) pack(x.col(i), m_permuted[place[i]]);
    if constexpr (size == 1)
        m_factor.solve_together(m_permuted.data());
    else
        m_factor.solve(m_permuted.data()->data());
    for (int i = 0; i < node_count(); ++i) unpack(m_permuted[place[i]], x.col(i));
}

template class GraphSystem<1, float>;
template class GraphSystem<3, double>;
template class GraphSystem<3, float>;
template void GraphSystem<1, float>::solve_in_place(Eigen::Matrix3Xd&);
template void GraphSystem<1, float>::solve_in_place(Eigen::Matrix4Xf&);
template void GraphSystem<3, double>::solve_in_place(Eigen::Matrix3Xd&);
template void GraphSystem<3, float>::solve_in_place(Eigen::Matrix3Xd&);

}  // namespace chebnet
