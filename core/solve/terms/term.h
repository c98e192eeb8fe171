#pragma once

#include <Eigen/Core>

#include "net/net.h"

namespace chebnet {

/// Collects a fixed quadratic form of positions that treats the three coordinates alike,
///
///     dᵀ M d = Σ w_ab ‖d_a − d_b‖² + Σ w_a ‖d_a‖².
class QuadraticForm {
public:
    virtual ~QuadraticForm() = default;
    virtual void add_link(int vertex_a, int vertex_b, double weight) = 0;
    virtual void add_vertex(int vertex, double weight) = 0;
};

/// A part of an energy of positions; energies add up. A term knows which vertices it is about and nothing else of the
/// net. Evaluating remembers what the other functions are about.
class Term {
public:
    virtual ~Term() = default;
    virtual const char* name() const = 0;

    /// Its energy at `x` (3×V). Adds its gradient to `gradient` (3×V).
    virtual double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) = 0;

    /// Adds H d to `product` (both 3×V), where H is the Hessian at the positions of the last evaluate(), or what is
    /// left of it when what is negative has been taken off: always positive semidefinite.
    virtual void add_curvature(const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const = 0;

    /// Adds a form M with dᵀ H d ≤ dᵀ M d everywhere, as tight as treating all directions alike allows.
    virtual void add_bound(QuadraticForm& form) const = 0;
};

}  // namespace chebnet
