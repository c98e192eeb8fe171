#pragma once

#include <Eigen/Core>
#include <vector>

#include "linear/cholesky.h"
#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// Newton's method on the constraints c_e = ℓ_e / L_e − 1 = 0 by moves of least norm (Goldenthal et al. 2007, "fast
/// projection"): d = −W Jᵀ λ with (J W Jᵀ) λ = c, where J is the Jacobian of c and W is 1 on free vertices, 0 on
/// handles, and between on vertices that shall give way last. The system has a row for each edge and couples edges that
/// share a free vertex. Converges quadratically from close by; from afar it crumples the net.
///
/// The system is solved by conjugate gradients preconditioned with a factor of it in single precision, which is renewed
/// when it has become too old to pay. Nothing is allocated after construction. The same bits come out natively and in
/// WebAssembly. Keeps a reference to the net.
class LengthProjection {
public:
    /// Orders and analyses the system, whatever the handles will be. Throws Error too_large where it would need more
    /// than k_most_factor_bytes, and for vertices of so many edges, all of which it couples, that factoring what they
    /// fill would take long: one of more than 2,000, or several of fewer.
    LengthProjection(const Net& net, const Topology& topology);

    /// V: the vertices that may move. The old factor stays a preconditioner.
    void set_free(const std::vector<bool>& is_free);
    /// W of one vertex that may move, 0 < mobility ≤ 1, until the next set_free().
    void set_mobility(int vertex, double mobility) { m_weight[vertex] = mobility; }

    /// One projection of `positions`, 3×V. False if the system cannot be solved; then the positions stay.
    bool project(Positions& positions);

    /// Σ_e c_e² before the last projection.
    double squared_error() const;
    double factorisation_ms() const { return m_factorisation_ms; }  ///< of the last projection

private:
    void couple_edges(const Topology& topology);
    void assemble(const Positions& positions);
    bool solve();
    bool factorize();
    bool solve_by_conjugate_gradients();
    void precondition(const Eigen::VectorXd& from, Eigen::VectorXd& to);
    void multiply(const Eigen::VectorXd& from, Eigen::VectorXd& to) const;

    using Entry = Eigen::Matrix<double, 1, 1>;
    /// Two edges that share a vertex.
    struct Coupling {
        int edge_a, edge_b, vertex;
        double sign;  // −1 if one edge begins where the other ends
    };

    const Net& m_net;
    std::vector<double> m_weight;  // V: W
    std::vector<Coupling> m_couplings;
    std::vector<Entry> m_diagonal, m_off_diagonal;  // of J W Jᵀ, by edges and by couplings
    Eigen::Matrix3Xd m_jacobian;                    // column e: the gradient of c_e at its first vertex
    Eigen::VectorXd m_rhs, m_multipliers;
    Cholesky<1, float> m_factor;
    bool m_has_factor = false;
    double m_factorisation_ms = 0;
    Eigen::VectorXd m_residual, m_preconditioned, m_search, m_image;
    Eigen::VectorXf m_permuted;
};

}  // namespace chebnet
