#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/parts/length_system.h"
#include "solve/terms/distance_constraint.h"

namespace chebnet {

/// Newton's method on the constraints c_e = ℓ_e / L_e − 1 = 0 by moves of least norm (Goldenthal et al. 2007, "fast
/// projection"): d = −W Jᵀ λ with (J W Jᵀ) λ = c, see LengthSystem. Converges quadratically from close by; from afar it
/// crumples the net.
///
/// The system is solved by conjugate gradients preconditioned with a factor of it in single precision, which is renewed
/// when it has become too old to pay. Nothing is allocated after construction.
class LengthProjection {
public:
    /// See LengthSystem, also for what it throws.
    LengthProjection(const Net& net, const Topology& topology, std::span<const Distance> more = {});

    /// V: the vertices that may move, and those of them that slide. The old factor stays a preconditioner.
    void set_free(const std::vector<bool>& is_free, std::span<const Slide> slides = {}) {
        m_system.set_free(is_free, slides);
    }
    /// W of one vertex that may move, 0 < mobility ≤ 1, until the next set_free().
    void set_mobility(int vertex, double mobility) { m_system.set_mobility(vertex, mobility); }

    /// One projection of `positions`, 3×V. False if the system cannot be solved; then the positions stay.
    bool project(Positions& positions);
    /// The same of positions for which the system has been assembled.
    bool project_assembled(Positions& positions);

    /// Σ_e c_e² before the last projection.
    double squared_error() const;
    double factorisation_ms() const { return m_factorisation_ms; }  ///< of the last projection

    /// How exactly the system is solved: until this part of the right-hand side is left, by so many iterations at most
    /// with a factor, and with a diagonal that is larger by this part.
    struct Accuracy {
        double tolerance = 0;
        int iterations = 12;  // more would cost more than a new factor
        double shift = LengthSystem::k_shift;
    };
    /// Solves (J W Jᵀ) y = rhs at the positions the system has been assembled for; `y` is the guess to begin with.
    /// False if it cannot be solved.
    bool solve(const Eigen::VectorXd& rhs, const Accuracy& accuracy, Eigen::VectorXd& y);
    LengthSystem& system() { return m_system; }
    const LengthSystem& system() const { return m_system; }

private:
    bool solve_from(const Eigen::VectorXd* guess, const Accuracy& accuracy);
    bool factorize();
    bool solve_by_conjugate_gradients(const Eigen::VectorXd* guess, const Accuracy& accuracy);

    LengthSystem m_system;
    Eigen::VectorXd m_rhs, m_multipliers;
    double m_factorisation_ms = 0;
    int m_iterations_lost = 0;  // to the age of the factor
    Eigen::VectorXd m_residual, m_preconditioned, m_search, m_image;
};

}  // namespace chebnet
