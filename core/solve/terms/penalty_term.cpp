#include "solve/terms/penalty_term.h"

#include <algorithm>
#include <utility>

namespace chebnet {

PenaltyTerm::PenaltyTerm(DistanceConstraint constraint, double weight)
    : m_constraint(std::move(constraint)), m_weight(weight), m_errors(Eigen::VectorXd::Zero(m_constraint.count())) {}

double PenaltyTerm::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) {
    m_errors = m_constraint.evaluate(x);
    for (Eigen::Index i = 0; i < m_errors.size(); ++i)
        if (!counts(i)) m_errors[i] = 0;
    m_constraint.add_transposed(2 * m_weight * m_errors, gradient);
    return m_weight * m_errors.squaredNorm();
}

void PenaltyTerm::add_curvature(Curvature curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const {
    Eigen::VectorXd changes = m_constraint.multiply(d);
    for (Eigen::Index i = 0; i < changes.size(); ++i)
        if (!counts(i)) changes[i] = 0;
    m_constraint.add_transposed(2 * m_weight * changes, product);
    const Eigen::VectorXd errors = curvature == Curvature::exact ? m_errors : m_errors.cwiseMax(0.0).eval();
    m_constraint.add_curvature(2 * m_weight * errors, d, product);
}

void PenaltyTerm::add_blocks(BlockForm& form) const {
    for (int i = 0; i < m_constraint.count(); ++i) {
        if (!counts(i)) continue;
        const Distance& pair = m_constraint.distances()[i];
        const Eigen::Vector3d u = m_constraint.directions().col(i);
        const Eigen::Matrix3d along = u * u.transpose();
        // c / ‖x_a − x_b‖, of ∇²c
        const double pull = m_errors[i] > 0 ? m_errors[i] / (pair.distance + m_errors[i] * pair.unit) : 0;
        form.add_link(pair.vertex_a, pair.vertex_b,
                      2 * m_weight / pair.unit * (along / pair.unit + pull * (Eigen::Matrix3d::Identity() - along)));
    }
}

void PenaltyTerm::add_bound(QuadraticForm& form) const {
    for (const Distance& pair : m_constraint.distances())
        form.add_link(pair.vertex_a, pair.vertex_b, 2 * m_weight / (pair.unit * pair.unit));
}

std::unique_ptr<Term> make_yielding_limit(const Net& net, double angle, double weight) {
    return std::make_unique<PenaltyTerm>(shear_limit(net, angle), weight);
}

}  // namespace chebnet
