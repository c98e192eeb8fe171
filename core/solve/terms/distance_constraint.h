#pragma once

#include <string>
#include <vector>

#include "net/net.h"

namespace chebnet {

/// Two vertices and the distance that they are to keep, or to keep at least.
struct Distance {
    int vertex_a, vertex_b;
    double distance;  ///< positive
    double unit;      ///< the length of an edge there
};

/// Conditions on positions x, c_i(x) = 0 or c_i(x) ≥ 0, all of one kind: c = (‖x_a − x_b‖ − distance) / unit for each
/// of some pairs of vertices. J is the Jacobian of c.
class DistanceConstraint {
public:
    enum class Kind { equal, at_least };

    DistanceConstraint(const char* name, Kind kind, std::vector<Distance> distances);

    const char* name() const { return m_name; }
    Kind kind() const { return m_kind; }
    int count() const { return static_cast<int>(m_distances.size()); }
    const std::vector<Distance>& distances() const { return m_distances; }
    /// Of each pair at the last evaluation, from b to a; zero where the two stand in one place.
    const Eigen::Matrix3Xd& directions() const { return m_directions; }

    /// c at `x` (3×V). Remembers J and the curvatures there.
    Eigen::VectorXd evaluate(const Positions& x);
    /// J d, for `d` 3×V.
    Eigen::VectorXd multiply(const Eigen::Matrix3Xd& d) const;
    /// Adds Jᵀ y to `sum` (3×V).
    void add_transposed(const Eigen::VectorXd& y, Eigen::Matrix3Xd& sum) const;
    /// Adds Σ y_i ∇²c_i d to `product`. ∇²c = (I − uuᵀ) / (unit · ‖x_a − x_b‖), u the direction from b to a: a pull
    /// stiffens across, a push gives way.
    void add_curvature(const Eigen::VectorXd& y, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const;

private:
    const char* m_name;
    Kind m_kind;
    std::vector<Distance> m_distances;
    Eigen::Matrix3Xd m_directions;  // u
    Eigen::VectorXd m_lengths;      // ‖x_a − x_b‖
};

/// Each edge keeps its rest length: c_e = ℓ_e / L_e − 1 = 0.
DistanceConstraint edge_lengths(const Net& net);

/// No corner of a quad is sharper than `angle`, radians in (0, π/2): for both diagonals of each quad, d ≥ the side
/// opposite that angle in the triangle of the two edges at the corner, the larger one of the diagonal's two corners.
/// With equal edges this is d ≥ 2 L sin(angle / 2), and since d₁² + d₂² ≤ 4 L² no corner is blunter than π − angle
/// either. Where edges are so unlike that the two beside the opposite corner keep a corner sharper, or nearly, it is
/// not to be sharper than it is when these are bent by as little as leaves the quad some play. Faces that are no quads
/// have no limit.
DistanceConstraint shear_limit(const Net& net, double angle);

}  // namespace chebnet
