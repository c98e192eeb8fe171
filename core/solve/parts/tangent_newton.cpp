#include "solve/parts/tangent_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "linear/ordered_dot.h"
#include "solve/parts/free_motions.h"

namespace chebnet {

namespace {

// What M adds for lengths, in the unit of energies: between 0.1 and 20 the iterations differ little.
constexpr double k_length_stiffness = 2;
// Keeps M's factor in single precision definite where a net is large and held at few vertices.
constexpr double k_metric_shift = 1e-6;
// What the factored Hessian adds for lengths, in the unit of energies, and to its diagonal. Single precision has room
// for what is between.
constexpr double k_penalty = 500;
constexpr double k_block_shift = 1e-4;
// Of multipliers, and of those of lines that are nearly straight, of which the factor in single precision knows little.
constexpr LengthProjection::Accuracy k_of_multipliers{.tolerance = 1e-7};
constexpr LengthProjection::Accuracy k_of_whole_tension{
    .tolerance = 1e-10, .iterations = 100, .shift = LengthSystem::k_least_shift};

}  // namespace

TangentNewton::TangentNewton(const Net& net, const Topology& topology, const FreePart& part,
                             std::span<const Slide> slides)
    : m_net(net),
      m_topology(topology),
      m_part(part),
      m_slides(slides.begin(), slides.end()),
      m_pairs(net, topology),
      m_form(m_pairs, net.vertex_count()),
      m_accuracy(k_of_multipliers) {
    for (int v = 0; v < net.vertex_count(); ++v)
        if (part.node_of(v) < 0) m_fixed.push_back(v);
    if (m_slides.empty())
        m_metrics.push_back(std::make_unique<CoordinateMetric>(m_pairs, part));
    else
        m_metrics = metrics_by_coordinate(net, m_pairs, part, m_slides);
}

TangentNewton::~TangentNewton() = default;

void TangentNewton::set_metric(std::span<const std::unique_ptr<Term>> terms) {
    m_has_factor = m_factor_is_used = false;
    m_form.set_zero();
    for (const auto& term : terms) term->add_bound(m_form);
    const double unit = m_net.mean_length();
    for (int e = 0; e < m_net.edge_count(); ++e)
        m_form.add_link(m_net.edges()(0, e), m_net.edges()(1, e), k_length_stiffness / (unit * unit));
    for (const auto& metric : m_metrics) metric->factorize(m_form, k_metric_shift / (unit * unit), 1 / (unit * unit));
}

void TangentNewton::extend(Eigen::Matrix3Xd& moves) {
    for (const auto& metric : m_metrics) metric->extend(m_form, moves);
}

void TangentNewton::give_way(const Eigen::Matrix3Xd& load, Eigen::Matrix3Xd& moves) const {
    moves.setZero(3, m_net.vertex_count());
    for (const auto& metric : m_metrics) metric->solve(load, moves);
}

void TangentNewton::mask(Eigen::Matrix3Xd& vectors) const {
    for (int v : m_fixed) vectors.col(v).setZero();
    for (const auto& [v, along] : m_slides) vectors.col(v) = across(k_all_axes - along, vectors.col(v));
}

void TangentNewton::find_whole_tension(bool on) { m_accuracy = on ? k_of_whole_tension : k_of_multipliers; }

bool TangentNewton::linearise(const Positions& x, const Eigen::Matrix3Xd& gradient, LengthProjection& lengths) {
    Stopwatch watch;
    m_lengths = &lengths;
    if (m_is_free) m_free_motions->begin(x);
    LengthSystem& system = lengths.system();
    if (m_multipliers.size() != system.row_count())
        for (Eigen::VectorXd* vector : {&m_multipliers, &m_changes, &m_pulls}) vector->setZero(system.row_count());
    system.assemble(x);
    if (!system.factorize()) return false;
    m_factorisation_ms = watch.milliseconds();
    m_firm.clear();
    for (int v : m_part.vertices())
        if (system.weight(v) < 1) m_firm.emplace_back(v, system.weight(v));
    m_descent = -gradient;
    mask(m_descent);
    weigh(1, m_descent);
    system.stretch(m_descent, m_changes);
    if (!lengths.solve(m_changes, m_accuracy, m_multipliers)) return false;
    system.add_pull(-m_multipliers, m_descent);
    weigh(-1, m_descent);
    m_normal.setZero(3, m_net.vertex_count());
    m_normal_slope = 0;
    m_gradient_norm = std::sqrt(ordered_dot(m_descent, m_descent));
    m_error_cost = ordered_dot(m_multipliers, system.errors());
    return std::isfinite(m_gradient_norm);
}

bool TangentNewton::shorten(const Eigen::VectorXd& rows) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(rows.size());
    if (!m_lengths->solve(rows, k_of_multipliers, y)) return false;
    m_normal.setZero();
    m_lengths->system().add_pull(-y, m_normal);
    m_normal_slope = ordered_dot(m_multipliers, rows);
    return true;
}

/// d −= W Jᵀ (J W Jᵀ)⁻¹ J d, as far as single precision goes; and without the free motions, which keep lengths.
void TangentNewton::project(Eigen::Matrix3Xd& moves) {
    LengthSystem& system = m_lengths->system();
    system.stretch(moves, m_changes);
    system.precondition(m_changes, m_pulls);
    m_pulls *= -1;
    system.add_pull(m_pulls, moves);
    if (!m_is_free) return;
    m_free_motions->take_out(moves);
    mask(moves);
}

/// f −= Jᵀ (J W Jᵀ)⁻¹ J W f, the transpose of project().
void TangentNewton::project_forces(Eigen::Matrix3Xd& forces) {
    weigh(1, forces);
    project(forces);
    weigh(-1, forces);
}

/// By W, or by its inverse, where it is neither 0 nor 1.
void TangentNewton::weigh(int power, Eigen::Matrix3Xd& vectors) const {
    for (const auto& [v, mobility] : m_firm) vectors.col(v) *= power > 0 ? mobility : 1 / mobility;
}

void TangentNewton::precondition(const Eigen::Matrix3Xd& from, Eigen::Matrix3Xd& to) {
    to.setZero(3, m_net.vertex_count());
    if (m_factor_is_used) {
        m_blocks->solve(from, to);
    } else {
        for (const auto& metric : m_metrics) metric->solve(from, to);
    }
    project(to);
}

/// H, without what pushing edges take off, and the stiff lengths.
bool TangentNewton::factorize(std::span<const std::unique_ptr<Term>> terms) {
    Stopwatch watch;
    try {
        if (!m_blocks) m_blocks = std::make_unique<NeighbourSystem>(m_pairs, m_part);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        return false;
    }
    m_blocks->set_zero();
    for (const auto& term : terms) term->add_blocks(*m_blocks);
    const LengthSystem& system = m_lengths->system();
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    for (int row = 0; row < system.row_count(); ++row) {
        const auto& [a, b, distance, unit] = system.row(row);
        const Eigen::Vector3d gradient = system.jacobian().col(row);
        const Eigen::Matrix3d outer = gradient * gradient.transpose();
        const double pull = std::max(0.0, m_multipliers[row]) / distance;
        if (system.is_on(row)) m_blocks->add_link(a, b, k_penalty * outer + pull * (identity / unit - unit * outer));
    }
    const double unit = m_net.mean_length();
    for (int v : m_part.vertices()) m_blocks->add_vertex(v, k_block_shift / (unit * unit) * identity);
    if (!m_slides.empty()) m_blocks->hold(m_slides);
    m_has_factor = m_factor_is_used = m_blocks->factorize();
    m_factorisation_ms += watch.milliseconds();
    return m_has_factor;
}

/// Σ λ ∇²c d.
void TangentNewton::add_tension(const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const {
    const LengthSystem& system = m_lengths->system();
    for (int row = 0; row < system.row_count(); ++row) {
        if (m_multipliers[row] == 0) continue;
        const auto& [a, b, distance, unit] = system.row(row);
        const Eigen::Vector3d gradient = system.jacobian().col(row), move = d.col(a) - d.col(b);
        const Eigen::Vector3d across = move / unit - unit * gradient.dot(move) * gradient;
        const Eigen::Vector3d force = m_multipliers[row] / distance * across;
        product.col(a) += force;
        product.col(b) -= force;
    }
}

double TangentNewton::find_move(std::span<const std::unique_ptr<Term>> terms, Curvature kind, int most_iterations,
                                double tolerance, double radius, Eigen::Matrix3Xd& move) {
    move = m_normal;
    m_residual = m_descent;
    if (m_normal_slope != 0) find_residual(terms, kind, move);
    precondition(m_residual, m_preconditioned);
    m_enough = tolerance * tolerance * ordered_dot(m_residual, m_preconditioned);
    return descend(terms, kind, most_iterations, radius, move);
}

double TangentNewton::improve_move(std::span<const std::unique_ptr<Term>> terms, Curvature kind, int most_iterations,
                                   double radius, Eigen::Matrix3Xd& move) {
    restrict(move);
    find_residual(terms, kind, move);
    precondition(m_residual, m_preconditioned);
    return descend(terms, kind, most_iterations, radius, move);
}

void TangentNewton::go(double part, Positions& to) {
    m_image.setZero(3, m_net.vertex_count());
    m_way.add_pull(part, m_pairs, m_form, m_image);
    m_preconditioned.setZero(3, m_net.vertex_count());
    for (const auto& metric : m_metrics) metric->solve(m_image, m_preconditioned);
    m_way.go_straight(part, to);
    to += m_preconditioned;
}

/// Of ∇E + Jᵀλ + H d, what the rows leave; with the sign of a descent.
void TangentNewton::find_residual(std::span<const std::unique_ptr<Term>> terms, Curvature kind,
                                  const Eigen::Matrix3Xd& move) {
    apply_hessian(terms, kind, move);
    m_residual = m_descent - m_image;
    project_forces(m_residual);
}

/// Conjugate gradients from a move whose residual is known, also preconditioned.
double TangentNewton::descend(std::span<const std::unique_ptr<Term>> terms, Curvature kind, int most_iterations,
                              double radius, Eigen::Matrix3Xd& move) {
    m_ended_at_radius = m_met_negative_curvature = false;
    m_search = m_preconditioned;
    double product = ordered_dot(m_residual, m_preconditioned);
    m_inner_iterations = 0;
    while (m_inner_iterations < most_iterations && product > m_enough && !m_ended_at_radius) {
        ++m_inner_iterations;
        apply_hessian(terms, kind, m_search);
        const double curvature = ordered_dot(m_search, m_image);
        m_met_negative_curvature = !(curvature > 0);
        const double whole = curvature > 0 ? product / curvature : std::numeric_limits<double>::infinity();
        const double step = part_to_radius(move, m_search, whole, radius);
        m_ended_at_radius = step < whole;
        move += step * m_search;
        if (m_ended_at_radius || m_inner_iterations == most_iterations) break;
        m_residual -= step * m_image;
        project_forces(m_residual);
        precondition(m_residual, m_preconditioned);
        const double previous = std::exchange(product, ordered_dot(m_residual, m_preconditioned));
        m_search = m_preconditioned + product / previous * m_search;
    }
    return m_normal_slope - ordered_dot(m_descent, move);
}

double TangentNewton::restrict(Eigen::Matrix3Xd& move) {
    project(move);
    move += m_normal;
    return m_normal_slope - ordered_dot(m_descent, move);
}

bool TangentNewton::find_negative_curvature(std::span<const std::unique_ptr<Term>> terms, int most_steps,
                                            Eigen::Matrix3Xd& d) {
    Eigen::Matrix3Xd step;
    for (int k = 0;; ++k) {
        apply_hessian(terms, Curvature::exact, d);
        if (ordered_dot(d, m_image) < 0) return true;
        if (k == most_steps) return false;
        give_way(m_image, step);
        d -= step;
    }
}

/// To m_image.
void TangentNewton::apply_hessian(std::span<const std::unique_ptr<Term>> terms, Curvature kind,
                                  const Eigen::Matrix3Xd& d) {
    m_image.setZero(3, m_net.vertex_count());
    for (const auto& term : terms) term->add_curvature(kind, d, m_image);
    add_tension(d, m_image);
    mask(m_image);
}

/// The largest t ≤ most for which no column of from + t · along is longer than the radius.
double TangentNewton::part_to_radius(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& along, double most,
                                     double radius) const {
    double t = most;
    for (int v : m_part.vertices()) {
        const double a = along.col(v).squaredNorm(), b = from.col(v).dot(along.col(v));
        const double c = radius * radius - from.col(v).squaredNorm();
        if (a > 0) t = std::min(t, std::max(0.0, (std::sqrt(std::max(0.0, b * b + a * c)) - b) / a));
    }
    return t;
}

}  // namespace chebnet
