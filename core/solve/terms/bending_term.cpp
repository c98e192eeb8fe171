#include "solve/terms/bending_term.h"

#include <Eigen/LU>

#include "solve/parts/nearest_rotation.h"

namespace chebnet {

namespace {

// k / w: far less than what bends the lines, yet enough to say how a cell has turned.
constexpr double k_cell_stiffness = 0.01;
// Pull of a cell's last rotation against its edges, next to nothing: it decides where edges leave the rotation open.
constexpr double k_inertia = 1e-13;

}  // namespace

BendingTerm::BendingTerm(const Net& net, const Topology& topology, double weight, Reference reference)
    : m_weight(weight),
      m_cell_weight(reference == Reference::rest ? k_cell_stiffness * weight : 0),
      m_turns(reference == Reference::rest) {
    const std::vector<int> across = topology.slots_across();
    m_start.push_back(0);
    for (int b = 0; b < net.vertex_count(); ++b) {
        const std::span<const int> neighbours = topology.neighbours(b), edges = topology.incident_edges(b);
        for (std::size_t k = 0; k < neighbours.size(); ++k)
            m_spokes.push_back({neighbours[k], 1 / net.rest_lengths()[edges[k]], across[m_spokes.size()]});
        m_start.push_back(static_cast<int>(m_spokes.size()));
    }
    m_tangents.resize(3, static_cast<Eigen::Index>(m_spokes.size()));
    if (m_turns) remember_rest_shape(net);
}

void BendingTerm::remember_rest_shape(const Net& net) {
    m_rest = m_rest_formed = m_levers = m_tangents;
    const auto cells = static_cast<std::size_t>(net.vertex_count());
    m_compliance.resize(cells);
    m_quaternions.assign(cells, Eigen::Quaterniond::Identity());
    m_rotations.assign(cells, Eigen::Matrix3d::Identity());
    m_covariances.resize(cells);
    for (int b = 0; b < net.vertex_count(); ++b)
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) m_rest.col(i) = tangent(net.rest_positions(), b, i);
    for (int b = 0; b < net.vertex_count(); ++b) {
        Eigen::Matrix3d inertia = k_inertia * m_weight * Eigen::Matrix3d::Identity();
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            m_rest_formed.col(i) = formed(m_rest, i);
            const Eigen::Matrix3d outer = m_rest_formed.col(i) * m_rest.col(i).transpose();
            inertia += outer.trace() * Eigen::Matrix3d::Identity() - (outer + outer.transpose()) / 2;
        }
        m_compliance[b] = inertia.inverse();
    }
}

double BendingTerm::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) {
    const int cells = static_cast<int>(m_start.size()) - 1;
    for (int b = 0; b < cells; ++b)
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) m_tangents.col(i) = tangent(x, b, i);
    if (m_turns) turn_cells();
    double energy = 0;
    for (int b = 0; b < cells; ++b)
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            const Eigen::Vector3d force = formed(m_tangents, i);
            energy += m_tangents.col(i).dot(force);
            gradient.col(m_spokes[i].vertex) += 2 * m_spokes[i].inverse_length * force;
            gradient.col(b) -= 2 * m_spokes[i].inverse_length * force;
        }
    return energy;
}

/// Finds the rotations and leaves in m_tangents what the tangents differ from those at rest, turned.
void BendingTerm::turn_cells() {
    const int cells = static_cast<int>(m_start.size()) - 1;
    for (int b = 0; b < cells; ++b) {
        m_covariances[b] = k_inertia * m_weight * m_rotations[b];
        for (int i = m_start[b]; i < m_start[b + 1]; ++i)
            m_covariances[b] += m_tangents.col(i) * m_rest_formed.col(i).transpose();
    }
    nearest_rotations(m_covariances, m_quaternions, m_rotations);
    for (int b = 0; b < cells; ++b)
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            m_tangents.col(i) -= m_rotations[b] * m_rest.col(i);
            m_levers.col(i) = m_rotations[b] * m_rest_formed.col(i);
        }
}

/// The tangents move by q_i; the rotation follows by the ω that fits best, (Σ M_ij r_i r_j inertia) ω = Σ z_i × q_i
/// with r_i = R_b t_i⁰ and z_i = Σ M_ij r_j. What is left of the moves costs energy.
void BendingTerm::add_curvature(const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const {
    const int cells = static_cast<int>(m_start.size()) - 1;
    for (int b = 0; b < cells; ++b) {
        Eigen::Vector3d turn = Eigen::Vector3d::Zero();
        if (m_turns) {
            for (int i = m_start[b]; i < m_start[b + 1]; ++i) turn += m_levers.col(i).cross(tangent(d, b, i));
            turn = m_rotations[b] * (m_compliance[b] * (m_rotations[b].transpose() * turn));
        }
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            const Spoke& spoke = m_spokes[i];
            Eigen::Vector3d force = m_cell_weight * tangent(d, b, i);
            if (spoke.partner >= 0) force += m_weight * (tangent(d, b, i) + tangent(d, b, spoke.partner));
            if (m_turns) force -= turn.cross(m_levers.col(i));
            force *= 2 * spoke.inverse_length;
            product.col(spoke.vertex) += force;
            product.col(b) -= force;
        }
    }
}

/// ‖α p + β q‖² = (α² + αβ) ‖p‖² + (β² + αβ) ‖q‖² − αβ ‖p − q‖².
void BendingTerm::add_bound(QuadraticForm& form) const {
    const int cells = static_cast<int>(m_start.size()) - 1;
    for (int b = 0; b < cells; ++b)
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            const auto [vertex, alpha, partner] = m_spokes[i];
            if (m_cell_weight > 0) form.add_link(vertex, b, 2 * m_cell_weight * alpha * alpha);
            if (partner < 0) continue;
            const double beta = m_spokes[partner].inverse_length;
            form.add_link(vertex, b, 2 * m_weight * (alpha * alpha + alpha * beta));
            if (i < partner) form.add_link(vertex, m_spokes[partner].vertex, -2 * m_weight * alpha * beta);
        }
}

}  // namespace chebnet
