#pragma once

#include <Eigen/Core>
#include <memory>

#include "solve/terms/distance_constraint.h"
#include "solve/terms/term.h"

namespace chebnet {

/// A constraint that gives way: E = w Σ c_i², over all distances or, where they are one-sided, those that are too
/// short.
class PenaltyTerm : public Term {
public:
    PenaltyTerm(DistanceConstraint constraint, double weight);

    const char* name() const override { return m_constraint.name(); }
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) override;
    /// The convex one is without what distances that are too short lack across.
    void add_curvature(Curvature curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const override;
    void add_blocks(BlockForm& form) const override;
    void add_bound(QuadraticForm& form) const override;

private:
    bool counts(Eigen::Index i) const {
        return m_constraint.kind() == DistanceConstraint::Kind::equal || m_errors[i] < 0;
    }

    DistanceConstraint m_constraint;
    double m_weight;
    Eigen::VectorXd m_errors;  // c at the last evaluation, zero for what does not count
};

/// Of shear_limit(), for those who may do without. Throws Error left_out in a build that does.
std::unique_ptr<Term> make_yielding_limit(const Net& net, double angle, double weight);

}  // namespace chebnet
