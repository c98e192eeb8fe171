#include "solve/parts/tangent_newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/stopwatch.h"

namespace chebnet {

namespace {

// What M adds for lengths, in the unit of energies: between 0.1 and 20 the iterations differ little.
constexpr double k_length_stiffness = 2;
// Keeps M's factor in single precision definite where a net is large and held at few vertices.
constexpr double k_shift = 1e-6;
constexpr double k_multiplier_tolerance = 1e-5;

}  // namespace

TangentNewton::TangentNewton(const Net& net, const Topology& topology, const FreePart& part)
    : m_net(net), m_part(part), m_form(net, topology) {
    for (int v = 0; v < net.vertex_count(); ++v)
        if (part.node_of(v) < 0) m_fixed.push_back(v);
    Eigen::Matrix2Xi links(2, static_cast<Eigen::Index>(m_form.pairs().size()));
    Eigen::Index count = 0;
    for (const auto& [a, b] : m_form.pairs())
        if (part.node_of(a) >= 0 && part.node_of(b) >= 0) links.col(count++) << part.node_of(a), part.node_of(b);
    links.conservativeResize(2, count);
    m_system = std::make_unique<LaplacianSystem>(part.size(), links);
    m_single.setZero(4, part.size());
}

void TangentNewton::set_metric(std::span<const std::unique_ptr<Term>> terms) {
    m_form.set_zero();
    for (const auto& term : terms) term->add_bound(m_form);
    const double unit = m_net.mean_length();
    for (int e = 0; e < m_net.edge_count(); ++e)
        m_form.add_link(m_net.edges()(0, e), m_net.edges()(1, e), k_length_stiffness / (unit * unit));

    m_system->set_zero();
    int link = 0;
    for (std::size_t k = 0; k < m_form.pairs().size(); ++k) {
        const auto& [a, b] = m_form.pairs()[k];
        const int i = m_part.node_of(a), j = m_part.node_of(b);
        const LaplacianSystem::Block weight(m_form.weight(k));
        if (i >= 0 && j >= 0)
            m_system->add_at_link(link++, weight);
        else if (i >= 0 || j >= 0)
            m_system->add_at_node(std::max(i, j), weight);
    }
    for (int i = 0; i < m_part.size(); ++i)
        m_system->add_at_node(
            i, LaplacianSystem::Block(m_form.vertex_weight(m_part.vertices()[i]) + k_shift / (unit * unit)));
    for (int node : m_part.floating_nodes()) m_system->add_at_node(node, LaplacianSystem::Block(1 / (unit * unit)));
    m_system->factorize();
}

void TangentNewton::extend(Eigen::Matrix3Xd& moves) {
    m_single.setZero();
    for (std::size_t k = 0; k < m_form.pairs().size(); ++k) {
        const auto& [a, b] = m_form.pairs()[k];
        const int i = m_part.node_of(a), j = m_part.node_of(b);
        const auto pull = [&](int node, int fixed) {
            m_single.col(node).head<3>() += (m_form.weight(k) * moves.col(fixed)).cast<float>();
        };
        if (i >= 0 && j < 0) pull(i, b);
        if (j >= 0 && i < 0) pull(j, a);
    }
    m_system->solve_in_place(m_single);
    for (int i = 0; i < m_part.size(); ++i) moves.col(m_part.vertices()[i]) = m_single.col(i).head<3>().cast<double>();
}

void TangentNewton::mask(Eigen::Matrix3Xd& vectors) const {
    for (int v : m_fixed) vectors.col(v).setZero();
}

bool TangentNewton::linearise(const Positions& x, const Eigen::Matrix3Xd& gradient, LengthProjection& lengths) {
    Stopwatch watch;
    m_lengths = &lengths;
    LengthSystem& system = lengths.system();
    if (m_multipliers.size() != system.row_count())
        for (Eigen::VectorXd* vector : {&m_multipliers, &m_changes, &m_pulls}) vector->setZero(system.row_count());
    system.assemble(x);
    if (!system.factorize()) return false;
    m_factorisation_ms = watch.milliseconds();
    m_descent = -gradient;
    mask(m_descent);
    system.stretch(m_descent, m_changes);
    if (!lengths.solve(m_changes, k_multiplier_tolerance, m_multipliers)) return false;
    system.add_pull(-m_multipliers, m_descent);
    m_gradient_norm = m_descent.norm();
    return std::isfinite(m_gradient_norm);
}

/// v −= W Jᵀ (J W Jᵀ)⁻¹ J v, as far as single precision goes.
void TangentNewton::project(Eigen::Matrix3Xd& vectors) {
    LengthSystem& system = m_lengths->system();
    system.stretch(vectors, m_changes);
    system.precondition(m_changes, m_pulls);
    m_pulls *= -1;
    system.add_pull(m_pulls, vectors);
}

void TangentNewton::precondition(const Eigen::Matrix3Xd& from, Eigen::Matrix3Xd& to) {
    for (int i = 0; i < m_part.size(); ++i) m_single.col(i).head<3>() = from.col(m_part.vertices()[i]).cast<float>();
    m_system->solve_in_place(m_single);
    to.setZero(3, m_net.vertex_count());
    for (int i = 0; i < m_part.size(); ++i) to.col(m_part.vertices()[i]) = m_single.col(i).head<3>().cast<double>();
    project(to);
}

/// Σ λ ∇²c d, or of those only that pull.
void TangentNewton::add_tension(const Eigen::Matrix3Xd& d, bool pushes, Eigen::Matrix3Xd& product) const {
    const LengthSystem& system = m_lengths->system();
    for (int row = 0; row < system.row_count(); ++row) {
        if (m_multipliers[row] == 0 || (!pushes && m_multipliers[row] < 0)) continue;
        const auto& [a, b, distance, unit] = system.row(row);
        const Eigen::Vector3d gradient = system.jacobian().col(row), move = d.col(a) - d.col(b);
        const Eigen::Vector3d across = move / unit - unit * gradient.dot(move) * gradient;
        const Eigen::Vector3d force = m_multipliers[row] / distance * across;
        product.col(a) += force;
        product.col(b) -= force;
    }
}

double TangentNewton::find_direction(std::span<const std::unique_ptr<Term>> terms, int most_iterations,
                                     double tolerance, bool pushes, Eigen::Matrix3Xd& direction) {
    direction.setZero(3, m_net.vertex_count());
    m_met_negative_curvature = false;
    m_inner_iterations = 0;
    m_residual = m_descent;
    precondition(m_residual, m_preconditioned);
    m_search = m_preconditioned;
    double product = m_residual.cwiseProduct(m_preconditioned).sum();
    const double enough = tolerance * tolerance * product;
    for (int k = 0; k < most_iterations && product > enough; ++k) {
        m_image.setZero(3, m_net.vertex_count());
        for (const auto& term : terms) term->add_curvature(m_search, m_image);
        add_tension(m_search, pushes, m_image);
        mask(m_image);
        const double curvature = m_search.cwiseProduct(m_image).sum();
        if (!(curvature > 1e-10 * product)) {
            m_met_negative_curvature = true;
            if (k == 0) direction = m_search;
            break;
        }
        ++m_inner_iterations;
        direction += product / curvature * m_search;
        m_residual -= product / curvature * m_image;
        project(m_residual);
        precondition(m_residual, m_preconditioned);
        const double previous = std::exchange(product, m_residual.cwiseProduct(m_preconditioned).sum());
        m_search = m_preconditioned + product / previous * m_search;
    }
    return -m_descent.cwiseProduct(direction).sum();
}

}  // namespace chebnet
