#pragma once

#include <Eigen/Core>

#include "net/net.h"

namespace chebnet {

/// Conditions on positions, c_i(x) = 0 or c_i(x) ≥ 0, all of one kind. J is the Jacobian of c.
class Constraint {
public:
    enum class Kind { equal, at_least };

    virtual ~Constraint() = default;
    virtual const char* name() const = 0;
    virtual Kind kind() const = 0;
    virtual int count() const = 0;

    /// c at `x` (3×V). Remembers J and the curvatures there.
    virtual Eigen::VectorXd evaluate(const Positions& x) = 0;
    /// J d, for `d` 3×V.
    virtual Eigen::VectorXd multiply(const Eigen::Matrix3Xd& d) const = 0;
    /// Adds Jᵀ y to `sum` (3×V).
    virtual void add_transposed(const Eigen::VectorXd& y, Eigen::Matrix3Xd& sum) const = 0;
    /// Adds Σ y_i ∇²c_i d to `product`.
    virtual void add_curvature(const Eigen::VectorXd& y, const Eigen::Matrix3Xd& d,
                               Eigen::Matrix3Xd& product) const = 0;
};

}  // namespace chebnet
