#pragma once

#include <string>
#include <vector>

#include "net/net.h"
#include "solve/terms/constraint.h"

namespace chebnet {

/// Two vertices and the distance that they are to keep, or to keep at least.
struct Distance {
    int vertex_a, vertex_b;
    double distance;  ///< positive
    double unit;      ///< the length of an edge there
};

/// c = (‖x_a − x_b‖ − distance) / unit for each of some pairs of vertices.
class DistanceConstraint : public Constraint {
public:
    DistanceConstraint(const char* name, Kind kind, std::vector<Distance> distances);

    const char* name() const override { return m_name; }
    Kind kind() const override { return m_kind; }
    int count() const override { return static_cast<int>(m_distances.size()); }
    const std::vector<Distance>& distances() const { return m_distances; }
    /// Of each pair at the last evaluation, from b to a; zero where the two stand in one place.
    const Eigen::Matrix3Xd& directions() const { return m_directions; }

    Eigen::VectorXd evaluate(const Positions& x) override;
    Eigen::VectorXd multiply(const Eigen::Matrix3Xd& d) const override;
    void add_transposed(const Eigen::VectorXd& y, Eigen::Matrix3Xd& sum) const override;
    /// ∇²c = (I − uuᵀ) / (unit · ‖x_a − x_b‖), u the direction from b to a: a pull stiffens across, a push gives way.
    void add_curvature(const Eigen::VectorXd& y, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const override;

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
/// either. Faces that are no quads have no limit.
DistanceConstraint shear_limit(const Net& net, double angle);

}  // namespace chebnet
