#pragma once

#include <Eigen/Core>
#include <vector>

#include "net/net.h"
#include "solve/terms/term.h"

namespace chebnet {

/// Shear of quads, E = w Σ (d / d⁰ − 1)² over their diagonals, d⁰ being the diagonal at rest or, for a net that wants
/// to be square, the root of the sum of the squares of two adjacent edges. Other faces have no shear.
class ShearTerm : public Term {
public:
    enum class Reference { rest, right_angles };

    /// `rest`: 3×V, the shape of d⁰, with corners below `opened` (radians, above 0) as open as that.
    ShearTerm(const Net& net, const Positions& rest, double weight, Reference reference, double opened);

    const char* name() const override { return "shear"; }
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) override;
    /// The convex one is without what a diagonal shorter than d⁰ lacks across.
    void add_curvature(Curvature curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const override;
    void add_blocks(BlockForm& form) const override;
    void add_bound(QuadraticForm& form) const override;

private:
    struct Diagonal {
        int vertex_a, vertex_b;
        double length;  // d⁰
    };

    double m_weight;
    std::vector<Diagonal> m_diagonals;
    Eigen::Matrix3Xd m_directions;  // of the last evaluation
    Eigen::VectorXd m_across;       // 1 − d⁰ / d
};

}  // namespace chebnet
