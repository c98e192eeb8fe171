#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "linear/cholesky.h"
#include "net/net.h"
#include "net/topology.h"
#include "solve/slide.h"
#include "solve/terms/distance_constraint.h"

namespace chebnet {

/// The system J W Jᵀ of the constraints c_e = ℓ_e / L_e − 1, where J is their Jacobian and W is 1 on vertices that may
/// move, 0 on handles, and between on vertices that shall give way last; of a vertex that slides it is 0 for the
/// coordinates that it keeps. It has a row for each edge and couples edges
/// that share a free vertex. More distances may be kept beside the edges, each a further row that can be switched on
/// and off. Its factor in single precision serves as preconditioner for the system of the moment, from which it may be
/// older. Nothing is allocated after construction.
class LengthSystem {
public:
    /// Keeps the system definite where constraints depend on each other, e.g. beside handles that are close together.
    static constexpr double k_shift = 1e-9;
    /// Enough where only a part of the right-hand side is in question that the constraints can bear.
    static constexpr double k_least_shift = 1e-11;

    /// Orders and analyses the system, whatever the handles will be. Throws Error too_large where it would need more
    /// than k_most_factor_bytes, and for vertices of so many edges, all of which it couples, that factoring what they
    /// fill would take long: one of more than 2,000, or several of fewer.
    LengthSystem(const Net& net, const Topology& topology, std::span<const Distance> more = {});

    /// The edges, in their order, then the distances beside them; those are off until they are switched on.
    int row_count() const { return static_cast<int>(m_rows.size()); }
    const Distance& row(int row) const { return m_rows[row]; }
    /// A distance beside the edges: off, or on and to be as long as this. The old factor stays a preconditioner.
    void switch_off(int row) { m_is_on[row] = false; }
    void switch_on(int row, double distance);
    bool is_on(int row) const { return m_is_on[row]; }

    /// V: the vertices that may move, and those of them that slide. The old factor stays a preconditioner.
    void set_free(const std::vector<bool>& is_free, std::span<const Slide> slides = {});
    /// W of one vertex that may move, 0 < mobility ≤ 1, until the next set_free().
    void set_mobility(int vertex, double mobility) { m_weight[vertex] = mobility; }
    double weight(int vertex) const { return m_weight[vertex]; }

    /// Takes the Jacobian of these positions, 3×V.
    void assemble(const Positions& positions);
    /// A column for each row: the gradient of c at its first vertex; at the second it is the opposite. 0 if it is off.
    const Eigen::Matrix3Xd& jacobian() const { return m_jacobian; }
    /// c at the positions assembled last; 0 between two handles, which cannot change, and for rows that are off.
    const Eigen::VectorXd& errors() const { return m_errors; }
    /// Applies the system, with a diagonal larger by this part.
    void multiply(const Eigen::VectorXd& from, Eigen::VectorXd& to, double shift) const;

    /// J d, for moves d of the vertices, 3×V.
    void stretch(const Eigen::Matrix3Xd& moves, Eigen::VectorXd& changes) const;
    /// Adds W Jᵀ y to `moves`, 3×V.
    void add_pull(const Eigen::VectorXd& y, Eigen::Matrix3Xd& moves) const;

    /// False if the system cannot be factored.
    bool factorize();
    bool has_factor() const { return m_has_factor; }
    /// Whether the system has been assembled since.
    bool is_factor_old() const { return m_is_factor_old; }
    /// Applies the inverse of the system as it was when it was factored.
    void precondition(const Eigen::VectorXd& from, Eigen::VectorXd& to);

private:
    void couple_rows(int vertex_count);
    // In slides.cpp:
    void set_slides(std::span<const Slide> slides);
    void take_off_what_is_kept();
    void add_pull_beside_what_is_kept(const Eigen::VectorXd& y, Eigen::Matrix3Xd& moves) const;

    using Entry = Eigen::Matrix<double, 1, 1>;
    /// Two rows that share a vertex.
    struct Coupling {
        int row_a, row_b, vertex;
        double sign;  // −1 if one begins where the other ends
    };

    std::vector<Distance> m_rows;
    std::vector<bool> m_is_on;
    std::vector<double> m_weight;  // V: W
    std::vector<Coupling> m_couplings;
    std::vector<Axes> m_kept;  // V, coordinates that a vertex keeps though it may move; empty: nothing slides
    std::vector<int> m_rows_that_slide, m_couplings_that_slide;
    std::vector<Entry> m_diagonal, m_off_diagonal;  // of J W Jᵀ, by rows and by couplings
    Eigen::Matrix3Xd m_jacobian;
    Eigen::VectorXd m_errors;
    Cholesky<1, float> m_factor;
    bool m_has_factor = false, m_is_factor_old = false;
    Eigen::VectorXf m_permuted;
};

}  // namespace chebnet
