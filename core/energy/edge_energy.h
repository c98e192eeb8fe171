#pragma once

namespace chebnet {

/// Second derivatives of an edge term as weights: for an edge of rest length L and unit direction u, the Hessian with
/// respect to the edge vector is (1/L²) [radial · u uᵀ + tangential · (I − u uᵀ)].
struct Curvature {
    double radial;
    double tangential;
};

/// The energy of one edge as a function of its ratio r = length / rest length > 0, with f(1) = 0.
class EdgeEnergy {
public:
    virtual ~EdgeEnergy() = default;

    virtual double value(double r) const = 0;
    virtual double slope(double r) const = 0;
    /// The weights a Newton step is to use: those of a convex majorizer or another positive semi-definite stand-in for
    /// the true Hessian.
    virtual Curvature curvature(double r) const = 0;
};

}  // namespace chebnet
