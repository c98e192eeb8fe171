#include "solve/parts/length_projection.h"

#include <utility>

#include "base/stopwatch.h"
#include "linear/ordered_dot.h"

namespace chebnet {

namespace {

// A projection is worth no more precision than what it leaves of the error: it is a Newton step.
constexpr LengthProjection::Accuracy k_of_projection{.tolerance = 3e-2};
// A solve takes so many iterations with a factor of the system itself. A factor takes as long as four iterations, or
// five: once as many more have been taken for its age, a new one has paid.
constexpr int k_iterations_of_new_factor = 2, k_iterations_lost_by_old_factor = 6;

}  // namespace

LengthProjection::LengthProjection(const Net& net, const Topology& topology, std::span<const Distance> more)
    : m_system(net, topology, more) {
    for (Eigen::VectorXd* vector : {&m_rhs, &m_multipliers, &m_residual, &m_preconditioned, &m_search, &m_image})
        vector->setZero(m_system.row_count());
}

double LengthProjection::squared_error() const { return ordered_dot(m_rhs, m_rhs); }

bool LengthProjection::project(Positions& positions) {
    m_system.assemble(positions);
    return project_assembled(positions);
}

bool LengthProjection::project_assembled(Positions& positions) {
    m_rhs = m_system.errors();
    m_factorisation_ms = 0;
    if (!solve_from(nullptr, k_of_projection)) return false;
    m_multipliers *= -1;
    m_system.add_pull(m_multipliers, positions);
    return true;
}

bool LengthProjection::solve(const Eigen::VectorXd& rhs, const Accuracy& accuracy, Eigen::VectorXd& y) {
    m_rhs = rhs;
    if (!solve_from(&y, accuracy)) return false;
    y = m_multipliers;
    return true;
}

/// Without a guess: from zero.
bool LengthProjection::solve_from(const Eigen::VectorXd* guess, const Accuracy& accuracy) {
    const bool is_too_old = m_system.is_factor_old() && m_iterations_lost >= k_iterations_lost_by_old_factor;
    if (m_system.has_factor() && !is_too_old && solve_by_conjugate_gradients(guess, accuracy)) return true;
    if (!factorize()) return false;
    solve_by_conjugate_gradients(guess, accuracy);
    return m_multipliers.allFinite();
}

bool LengthProjection::factorize() {
    Stopwatch watch;
    const bool factored = m_system.factorize();
    m_iterations_lost = 0;
    m_factorisation_ms = watch.milliseconds();
    return factored;
}

/// False if the tolerance is not reached; then the multipliers are as good as the iterations made them.
bool LengthProjection::solve_by_conjugate_gradients(const Eigen::VectorXd* guess, const Accuracy& accuracy) {
    m_residual = m_rhs;
    if (guess != nullptr) {
        m_multipliers = *guess;
        m_system.multiply(m_multipliers, m_image, accuracy.shift);
        m_residual -= m_image;
    } else {
        m_multipliers.setZero();
    }
    const double enough = accuracy.tolerance * accuracy.tolerance * squared_error();
    if (ordered_dot(m_residual, m_residual) <= enough) return true;  // also where nothing is asked for
    double product = 0;
    for (int k = 0; k < accuracy.iterations; ++k) {
        if (k >= k_iterations_of_new_factor) ++m_iterations_lost;
        m_system.precondition(m_residual, m_preconditioned);
        const double previous = std::exchange(product, ordered_dot(m_residual, m_preconditioned));
        if (k == 0)
            m_search = m_preconditioned;
        else
            m_search = m_preconditioned + product / previous * m_search;
        m_system.multiply(m_search, m_image, accuracy.shift);
        const double step = product / ordered_dot(m_search, m_image);
        m_multipliers += step * m_search;
        m_residual -= step * m_image;
        if (ordered_dot(m_residual, m_residual) <= enough) return m_multipliers.allFinite();
    }
    return false;
}

}  // namespace chebnet
