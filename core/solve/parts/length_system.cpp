#include "solve/parts/length_system.h"

#include <cmath>

#include "linear/limits.h"
#include "linear/ordered_dot.h"
#include "linear/ordering.h"
#include "solve/parts/valence_limit.h"

namespace chebnet {

namespace {

// Of the factor in single precision, as LengthSystem::k_shift is of the system.
constexpr double k_factor_shift = 1e-6;
// Two vertices in one place, as of a quad that is folded onto itself, go apart along this: any direction but that of an
// axis, across which such a quad may lie.
const Eigen::Vector3d k_any_direction = Eigen::Vector3d(1, 2, 3).normalized();

void check_size(const Net& net, const Topology& topology) {
    double couplings = 0;
    for (int v = 0; v < net.vertex_count(); ++v) {
        const double valence = topology.valence(v);
        couplings += valence * (valence - 1) / 2;
    }
    // Each coupling is kept here, as a link, and three times as an index while the order is found.
    check_factor_bytes(net.edge_count(), couplings * (40 + 8 + 12));
    check_valences(net, topology);
}

}  // namespace

LengthSystem::LengthSystem(const Net& net, const Topology& topology, std::span<const Distance> more) {
    check_size(net, topology);
    for (int e = 0; e < net.edge_count(); ++e) {
        const double L = net.rest_lengths()[e];
        m_rows.push_back({net.edges()(0, e), net.edges()(1, e), L, L});
    }
    m_is_on.assign(m_rows.size(), true);
    m_rows.insert(m_rows.end(), more.begin(), more.end());
    m_is_on.resize(m_rows.size(), false);
    couple_rows(net.vertex_count());
    Eigen::Matrix2Xi links(2, static_cast<Eigen::Index>(m_couplings.size()));
    for (std::size_t k = 0; k < m_couplings.size(); ++k)
        links.col(static_cast<Eigen::Index>(k)) << m_couplings[k].row_a, m_couplings[k].row_b;
    const int n = row_count();
    m_factor.analyze(n, links, fill_reducing_order(n, links));
    m_diagonal.resize(static_cast<std::size_t>(n));
    m_off_diagonal.resize(m_couplings.size());
    m_jacobian.resize(3, n);
    m_errors.setZero(n);
    m_permuted.setZero(n);
}

void LengthSystem::couple_rows(int vertex_count) {
    std::vector<std::vector<int>> rows_at(static_cast<std::size_t>(vertex_count));
    for (int row = 0; row < row_count(); ++row)
        for (int v : {m_rows[row].vertex_a, m_rows[row].vertex_b}) rows_at[v].push_back(row);
    for (int v = 0; v < vertex_count; ++v)
        for (std::size_t i = 0; i < rows_at[v].size(); ++i)
            for (std::size_t j = i + 1; j < rows_at[v].size(); ++j) {
                const int a = rows_at[v][i], b = rows_at[v][j];
                const bool same_side = (m_rows[a].vertex_a == v) == (m_rows[b].vertex_a == v);
                m_couplings.push_back({a, b, v, same_side ? 1.0 : -1.0});
            }
}

void LengthSystem::switch_on(int row, double distance) {
    m_is_on[row] = true;
    m_rows[row].distance = distance;
}

void LengthSystem::set_free(const std::vector<bool>& is_free, std::span<const Slide> slides) {
    m_weight.resize(is_free.size());
    for (std::size_t v = 0; v < is_free.size(); ++v) m_weight[v] = is_free[v] ? 1 : 0;
    m_kept.clear();
    if (!slides.empty()) set_slides(slides);
}

void LengthSystem::assemble(const Positions& positions) {
    m_is_factor_old = true;
    for (int row = 0; row < row_count(); ++row) {
        const auto& [a, b, distance, unit] = m_rows[row];
        const Eigen::Vector3d d = positions.col(a) - positions.col(b);
        const double length = std::sqrt(ordered_dot(d, d)), weight = m_weight[a] + m_weight[b];
        m_jacobian.col(row) = length > 0 ? Eigen::Vector3d(d / (length * unit)) : k_any_direction / unit;
        if (!m_is_on[row]) m_jacobian.col(row).setZero();
        // What cannot change is a row of its own, with nothing to ask for.
        const bool asks = weight > 0 && m_is_on[row];
        m_diagonal[row][0] = asks ? (1 + k_shift) * weight / (unit * unit) : 1;
        m_errors[row] = asks ? length / unit - distance / unit : 0;
    }
    for (std::size_t k = 0; k < m_couplings.size(); ++k) {
        const auto& [a, b, vertex, sign] = m_couplings[k];
        m_off_diagonal[k][0] = m_weight[vertex] * sign * ordered_dot(m_jacobian.col(a), m_jacobian.col(b));
    }
    if (!m_kept.empty()) take_off_what_is_kept();
}

void LengthSystem::stretch(const Eigen::Matrix3Xd& moves, Eigen::VectorXd& changes) const {
    for (int row = 0; row < row_count(); ++row)
        changes[row] =
            ordered_dot(m_jacobian.col(row), moves.col(m_rows[row].vertex_a) - moves.col(m_rows[row].vertex_b));
}

void LengthSystem::add_pull(const Eigen::VectorXd& y, Eigen::Matrix3Xd& moves) const {
    if (!m_kept.empty()) return add_pull_beside_what_is_kept(y, moves);
    for (int row = 0; row < row_count(); ++row) {
        const int a = m_rows[row].vertex_a, b = m_rows[row].vertex_b;
        const Eigen::Vector3d pull = y[row] * m_jacobian.col(row);
        moves.col(a) += m_weight[a] * pull;
        moves.col(b) -= m_weight[b] * pull;
    }
}

bool LengthSystem::factorize() {
    for (Entry& entry : m_diagonal) entry *= 1 + k_factor_shift;
    m_has_factor = m_factor.factorize(m_diagonal, m_off_diagonal);
    for (Entry& entry : m_diagonal) entry /= 1 + k_factor_shift;
    m_is_factor_old = false;
    return m_has_factor;
}

void LengthSystem::precondition(const Eigen::VectorXd& from, Eigen::VectorXd& to) {
    const std::vector<int>& place = m_factor.rank();
    for (Eigen::Index row = 0; row < from.size(); ++row) m_permuted[place[row]] = static_cast<float>(from[row]);
    m_factor.solve(m_permuted.data());
    for (Eigen::Index row = 0; row < from.size(); ++row) to[row] = m_permuted[place[row]];
}

void LengthSystem::multiply(const Eigen::VectorXd& from, Eigen::VectorXd& to, double shift) const {
    const double of_diagonal = (1 + shift) / (1 + k_shift);
    for (Eigen::Index row = 0; row < from.size(); ++row) to[row] = of_diagonal * m_diagonal[row][0] * from[row];
    for (std::size_t k = 0; k < m_couplings.size(); ++k) {
        const auto& [a, b, vertex, sign] = m_couplings[k];
        to[a] += m_off_diagonal[k][0] * from[b];
        to[b] += m_off_diagonal[k][0] * from[a];
    }
}

}  // namespace chebnet
