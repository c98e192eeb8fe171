#include "solve/parts/length_projection.h"

#include <cmath>
#include <utility>

#include "base/stopwatch.h"
#include "linear/dense_kernels.h"
#include "linear/limits.h"
#include "linear/ordering.h"

namespace chebnet {

namespace {

// A projection is worth no more precision than what it leaves of the error: it is a Newton step.
constexpr double k_tolerance = 3e-2;
// More iterations than this cost more than a new factor.
constexpr int k_most_iterations = 12;
// Keeps the system definite where constraints depend on each other, e.g. beside handles that are close together.
constexpr double k_shift = 1e-9;
// The same for its factor in single precision.
constexpr double k_factor_shift = 1e-6;
// The edges at a vertex are all coupled with each other: a dense block, whose factor takes as many operations.
constexpr double k_most_block_operations = 3e9;

/// In an order that does not depend on the compiler, as Eigen's do.
double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return dense::dot(a.data(), b.data(), static_cast<int>(a.size()));
}
double dot3(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

void check_size(const Net& net, const Topology& topology) {
    double couplings = 0, operations = 0;
    for (int v = 0; v < net.vertex_count(); ++v) {
        const double valence = topology.valence(v);
        couplings += valence * (valence - 1) / 2;
        operations += valence * valence * valence / 3;
    }
    // Each coupling is kept here, as a link, and three times as an index while the order is found.
    check_factor_bytes(net.edge_count(), couplings * (40 + 8 + 12));
    if (operations > k_most_block_operations) throw Error(ErrorCode::too_large, "too many edges meet at one vertex");
}

}  // namespace

LengthProjection::LengthProjection(const Net& net, const Topology& topology) : m_net(net) {
    check_size(net, topology);
    couple_edges(topology);
    Eigen::Matrix2Xi links(2, static_cast<Eigen::Index>(m_couplings.size()));
    for (std::size_t k = 0; k < m_couplings.size(); ++k)
        links.col(static_cast<Eigen::Index>(k)) << m_couplings[k].edge_a, m_couplings[k].edge_b;
    const int n = net.edge_count();
    m_factor.analyze(n, links, fill_reducing_order(n, links));
    m_diagonal.resize(static_cast<std::size_t>(n));
    m_off_diagonal.resize(m_couplings.size());
    m_jacobian.resize(3, n);
    for (Eigen::VectorXd* vector : {&m_rhs, &m_multipliers, &m_residual, &m_preconditioned, &m_search, &m_image})
        vector->setZero(n);
    m_permuted.setZero(n);
}

void LengthProjection::couple_edges(const Topology& topology) {
    for (int v = 0; v < m_net.vertex_count(); ++v) {
        const std::span<const int> edges = topology.incident_edges(v);
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (std::size_t j = i + 1; j < edges.size(); ++j) {
                const bool same_side = (m_net.edges()(0, edges[i]) == v) == (m_net.edges()(0, edges[j]) == v);
                m_couplings.push_back({edges[i], edges[j], v, same_side ? 1.0 : -1.0});
            }
    }
}

void LengthProjection::set_free(const std::vector<bool>& is_free) {
    m_weight.resize(is_free.size());
    for (std::size_t v = 0; v < is_free.size(); ++v) m_weight[v] = is_free[v] ? 1 : 0;
}

double LengthProjection::squared_error() const { return dot(m_rhs, m_rhs); }

bool LengthProjection::project(Positions& positions) {
    assemble(positions);
    m_factorisation_ms = 0;
    if (!solve()) return false;
    for (int e = 0; e < m_net.edge_count(); ++e) {
        const int a = m_net.edges()(0, e), b = m_net.edges()(1, e);
        const Eigen::Vector3d move = m_multipliers[e] * m_jacobian.col(e);
        positions.col(a) -= m_weight[a] * move;
        positions.col(b) += m_weight[b] * move;
    }
    return true;
}

void LengthProjection::assemble(const Positions& positions) {
    for (int e = 0; e < m_net.edge_count(); ++e) {
        const int a = m_net.edges()(0, e), b = m_net.edges()(1, e);
        const Eigen::Vector3d d = positions.col(a) - positions.col(b);
        const double length = std::sqrt(dot3(d, d)), L = m_net.rest_lengths()[e], weight = m_weight[a] + m_weight[b];
        m_jacobian.col(e) = d / (length * L);
        // An edge between two handles cannot change: a row of its own, with nothing to ask for.
        m_diagonal[e][0] = weight > 0 ? (1 + k_shift) * weight / (L * L) : 1;
        m_rhs[e] = weight > 0 ? length / L - 1 : 0;
    }
    for (std::size_t k = 0; k < m_couplings.size(); ++k) {
        const auto& [a, b, vertex, sign] = m_couplings[k];
        m_off_diagonal[k][0] = m_weight[vertex] * sign * dot3(m_jacobian.col(a), m_jacobian.col(b));
    }
}

bool LengthProjection::solve() {
    if (m_has_factor && solve_by_conjugate_gradients()) return true;
    if (!factorize()) return false;
    solve_by_conjugate_gradients();
    return m_multipliers.allFinite();
}

bool LengthProjection::factorize() {
    Stopwatch watch;
    for (Entry& entry : m_diagonal) entry *= 1 + k_factor_shift;
    m_has_factor = m_factor.factorize(m_diagonal, m_off_diagonal);
    for (Entry& entry : m_diagonal) entry /= 1 + k_factor_shift;
    m_factorisation_ms = watch.milliseconds();
    return m_has_factor;
}

/// False if the tolerance is not reached; then the multipliers are as good as the iterations made them.
bool LengthProjection::solve_by_conjugate_gradients() {
    m_multipliers.setZero();
    m_residual = m_rhs;
    const double enough = k_tolerance * k_tolerance * squared_error();
    double product = 0;
    for (int k = 0; k < k_most_iterations; ++k) {
        precondition(m_residual, m_preconditioned);
        const double previous = std::exchange(product, dot(m_residual, m_preconditioned));
        if (k == 0)
            m_search = m_preconditioned;
        else
            m_search = m_preconditioned + product / previous * m_search;
        multiply(m_search, m_image);
        const double step = product / dot(m_search, m_image);
        m_multipliers += step * m_search;
        m_residual -= step * m_image;
        if (dot(m_residual, m_residual) <= enough) return m_multipliers.allFinite();
    }
    return false;
}

void LengthProjection::precondition(const Eigen::VectorXd& from, Eigen::VectorXd& to) {
    const std::vector<int>& place = m_factor.rank();
    for (Eigen::Index e = 0; e < from.size(); ++e) m_permuted[place[e]] = static_cast<float>(from[e]);
    m_factor.solve(m_permuted.data());
    for (Eigen::Index e = 0; e < from.size(); ++e) to[e] = m_permuted[place[e]];
}

void LengthProjection::multiply(const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
    for (Eigen::Index e = 0; e < from.size(); ++e) to[e] = m_diagonal[e][0] * from[e];
    for (std::size_t k = 0; k < m_couplings.size(); ++k) {
        const auto& [a, b, vertex, sign] = m_couplings[k];
        to[a] += m_off_diagonal[k][0] * from[b];
        to[b] += m_off_diagonal[k][0] * from[a];
    }
}

}  // namespace chebnet
