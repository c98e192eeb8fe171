#include "solve/parts/arap_step.h"

#include "solve/parts/nearest_rotation.h"

namespace chebnet {

namespace {

// Pull of a cell's last rotation against its edges of mean length: far too weak to be seen, it decides where edges
// leave the rotation open (a cell of collinear edges, or one without extent). The energy still never rises.
constexpr double k_inertia = 1e-9;

}  // namespace

ArapStep::ArapStep(LaplacianPart& part)
    : AlternatingStep(part),
      m_quaternions(static_cast<std::size_t>(net().vertex_count()), Eigen::Quaterniond::Identity()),
      m_rotations(m_quaternions.size(), Eigen::Matrix3d::Identity()),
      m_covariances(m_quaternions.size()),
      m_rest(3, net().edge_count()) {
    for (int e = 0; e < net().edge_count(); ++e) m_rest.col(e) = edge_vector(e, net().rest_positions());
}

void ArapStep::project(const Positions& positions) {
    const double inertia = k_inertia * net().mean_length() * net().mean_length();
    for (std::size_t v = 0; v < m_rotations.size(); ++v) m_covariances[v] = inertia * m_rotations[v];
    for (int e = 0; e < net().edge_count(); ++e) {
        const Eigen::Matrix3d covariance = edge_vector(e, positions) * m_rest.col(e).transpose();
        for (int side = 0; side < 2; ++side) m_covariances[net().edges()(side, e)] += covariance;
    }
    nearest_rotations(m_covariances, m_quaternions, m_rotations);
    for (int e = 0; e < net().edge_count(); ++e) {
        const Eigen::Matrix3d turned = m_rotations[net().edges()(0, e)] + m_rotations[net().edges()(1, e)];
        m_vectors.col(e) = turned * m_rest.col(e) / 2;
    }
}

double ArapStep::energy(const Positions& positions) const {
    double sum = 0;
    for (int e = 0; e < net().edge_count(); ++e) {
        const Eigen::Vector3d now = edge_vector(e, positions), then = m_rest.col(e);
        for (int side = 0; side < 2; ++side) sum += (now - m_rotations[net().edges()(side, e)] * then).squaredNorm();
    }
    return sum / 2;
}

}  // namespace chebnet
