#pragma once

#include <algorithm>

namespace chebnet {

/// Second derivatives of an edge term as weights: for an edge of rest length L and unit direction u, the Hessian with
/// respect to the edge vector is (1/L²) [radial · u uᵀ + tangential · (I − u uᵀ)]. The weights are its eigenvalues,
/// times L².
struct EdgeCurvature {
    double radial;
    double tangential;
};

/// The nearest positive semi-definite matrix: negative eigenvalues become 0.
inline EdgeCurvature positive_part(const EdgeCurvature& c) {
    return {std::max(c.radial, 0.0), std::max(c.tangential, 0.0)};
}

/// The energy of one edge as a function of its ratio r = length / rest length > 0, with f(1) = 0.
class EdgeEnergy {
public:
    virtual ~EdgeEnergy() = default;

    virtual double value(double r) const = 0;
    virtual double slope(double r) const = 0;              ///< f′
    virtual double second_derivative(double r) const = 0;  ///< f″
    /// The weights a Newton step is to use: those of a convex majorizer or another positive semi-definite stand-in for
    /// the true Hessian.
    virtual EdgeCurvature curvature(double r) const = 0;

    /// The slope where an edge deviates by so little (see deviation()), beside that of a quadratic energy, whose slopes
    /// tell how near it is to its minimum: so much less is a slope that is as near. 1 for energies with f″(1) > 0.
    virtual double relative_slope(double /*deviation*/) const { return 1; }

    /// The true Hessian of f. Where f falls with r, its tangential weight is negative.
    EdgeCurvature hessian(double r) const { return {second_derivative(r), slope(r) / r}; }
};

}  // namespace chebnet
