#include "solve/terms/shear_term.h"

#include <algorithm>
#include <numbers>

#include "solve/terms/distance_constraint.h"

namespace chebnet {

ShearTerm::ShearTerm(const Net& net, const Positions& rest, double weight, Reference reference, double opened)
    : m_weight(weight) {
    const double least = reference == Reference::rest ? opened : std::numbers::pi / 2;
    const DistanceConstraint shortest = shear_limit(net, least);
    for (const auto& [a, b, distance, unit] : shortest.distances()) {
        const double at_rest = (rest.col(a) - rest.col(b)).norm();
        m_diagonals.push_back({a, b, reference == Reference::rest ? std::max(at_rest, distance) : distance});
    }
    m_directions.resize(3, static_cast<Eigen::Index>(m_diagonals.size()));
    m_across.resize(static_cast<Eigen::Index>(m_diagonals.size()));
}

double ShearTerm::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) {
    double energy = 0;
    for (std::size_t i = 0; i < m_diagonals.size(); ++i) {
        const auto& [a, b, length] = m_diagonals[i];
        const Eigen::Vector3d d = x.col(a) - x.col(b);
        const double now = d.norm(), strain = now / length - 1;
        energy += m_weight * strain * strain;
        const auto k = static_cast<Eigen::Index>(i);
        m_directions.col(k) = now > 0 ? Eigen::Vector3d(d / now) : Eigen::Vector3d::Zero();
        m_across[k] = now > 0 ? 1 - length / now : 0;
        const Eigen::Vector3d force = 2 * m_weight * strain / length * m_directions.col(k);
        gradient.col(a) += force;
        gradient.col(b) -= force;
    }
    return energy;
}

void ShearTerm::add_curvature(Curvature curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const {
    for (std::size_t i = 0; i < m_diagonals.size(); ++i) {
        const auto& [a, b, length] = m_diagonals[i];
        const auto k = static_cast<Eigen::Index>(i);
        const Eigen::Vector3d u = m_directions.col(k), move = d.col(a) - d.col(b);
        const double across = curvature == Curvature::exact ? m_across[k] : std::max(0.0, m_across[k]);
        const Eigen::Vector3d force =
            2 * m_weight / (length * length) * (across * move + (1 - across) * u.dot(move) * u);
        product.col(a) += force;
        product.col(b) -= force;
    }
}

void ShearTerm::add_blocks(BlockForm& form) const {
    for (std::size_t i = 0; i < m_diagonals.size(); ++i) {
        const auto& [a, b, length] = m_diagonals[i];
        const auto k = static_cast<Eigen::Index>(i);
        const Eigen::Matrix3d along = m_directions.col(k) * m_directions.col(k).transpose();
        const double across = std::max(0.0, m_across[k]);
        form.add_link(a, b,
                      2 * m_weight / (length * length) * (across * Eigen::Matrix3d::Identity() + (1 - across) * along));
    }
}

void ShearTerm::add_bound(QuadraticForm& form) const {
    for (const auto& [a, b, length] : m_diagonals) form.add_link(a, b, 2 * m_weight / (length * length));
}

}  // namespace chebnet
