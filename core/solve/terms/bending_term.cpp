#include "solve/terms/bending_term.h"

#include <Eigen/LU>

#include "solve/parts/nearest_rotation.h"

namespace chebnet {

namespace {

// k / w: far less than what bends the lines, yet enough to say how a cell has turned.
constexpr double k_cell_stiffness = 0.01;
// Pull of a cell's last rotation against its edges, next to nothing: it decides where edges leave the rotation open.
constexpr double k_inertia = 1e-13;
// Below this, of the trace's cube, edges leave the rotation open.
constexpr double k_least_determinant = 1e-9;

}  // namespace

BendingTerm::BendingTerm(const Net& net, const Topology& topology, const Positions& rest, double weight,
                         Reference reference, std::span<const double> stiffness, double curvature)
    : m_weight(weight),
      m_cell_stiffness(reference == Reference::straight ? 0 : k_cell_stiffness),
      m_turns(reference != Reference::straight) {
    m_start.push_back(0);
    for (int b = 0; b < net.vertex_count(); ++b) m_start.push_back(m_start.back() + topology.valence(b));
    const std::vector<int> partners = topology.straight_on(InwardCorners::pass);
    for (int b = 0; b < net.vertex_count(); ++b) {
        const std::span<const int> neighbours = topology.neighbours(b), edges = topology.incident_edges(b);
        for (std::size_t k = 0; k < neighbours.size(); ++k) {
            const double of_edge = stiffness.empty() ? weight : weight * stiffness[edges[k]];
            m_spokes.push_back({neighbours[k], partners[m_spokes.size()], 1 / net.rest_lengths()[edges[k]], of_edge});
        }
    }
    m_tangents.resize(3, static_cast<Eigen::Index>(m_spokes.size()));
    if (m_turns) remember_rest_shape(net, rest, curvature);
}

void BendingTerm::remember_rest_shape(const Net& net, const Positions& rest, double curvature) {
    m_rest = m_rest_formed = m_levers = m_tangents;
    const auto cells = m_start.size() - 1;
    m_rest_compliance.resize(cells);
    m_turned_compliance.resize(cells);
    m_compliance.resize(cells);
    m_quaternions.assign(cells, Eigen::Quaterniond::Identity());
    m_rotations.assign(cells, Eigen::Matrix3d::Identity());
    m_covariances.resize(cells);
    for (int b = 0; b < static_cast<int>(cells); ++b)
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) m_rest.col(i) = tangent(rest, b, i);
    if (curvature != 0) bend_rest_lines(net, rest, curvature);
    for (int b = 0; b < static_cast<int>(cells); ++b) {
        Eigen::Matrix3d inertia = k_inertia * m_weight * Eigen::Matrix3d::Identity();
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            m_rest_formed.col(i) = formed(m_rest, i);
            const Eigen::Matrix3d outer = m_rest_formed.col(i) * m_rest.col(i).transpose();
            inertia += outer.trace() * Eigen::Matrix3d::Identity() - (outer + outer.transpose()) / 2;
        }
        m_rest_compliance[b] = inertia.inverse();
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
    find_compliances();
}

/// Turned by ω further, R_b fits by ½ ωᵀ (tr S I − S) ω less, S = Σ t_i z_iᵀ being symmetric where it fits best.
void BendingTerm::find_compliances() {
    for (std::size_t b = 0; b < m_compliance.size(); ++b) {
        const Eigen::Matrix3d& R = m_rotations[b];
        m_turned_compliance[b] = R * m_rest_compliance[b] * R.transpose();
        const Eigen::Matrix3d S = m_covariances[b] * R.transpose();
        const Eigen::Matrix3d inertia = S.trace() * Eigen::Matrix3d::Identity() - (S + S.transpose()) / 2;
        const double size = inertia.trace();
        const bool is_definite = inertia.determinant() > k_least_determinant * size * size * size;
        m_compliance[b] = is_definite ? Eigen::Matrix3d(inertia.inverse()) : m_turned_compliance[b];
    }
}

/// The tangents move by q_i; the rotation follows by the ω that fits best, (tr S I − S) ω = Σ z_i × q_i with
/// z_i = Σ M_ij R_b t_j⁰. What is left of the moves costs energy. The convex H takes S as it is at rest.
void BendingTerm::add_curvature(Curvature curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const {
    const int cells = static_cast<int>(m_start.size()) - 1;
    for (int b = 0; b < cells; ++b) {
        Eigen::Vector3d turn = Eigen::Vector3d::Zero();
        if (m_turns) {
            for (int i = m_start[b]; i < m_start[b + 1]; ++i) turn += m_levers.col(i).cross(tangent(d, b, i));
            turn = (curvature == Curvature::exact ? m_compliance[b] : m_turned_compliance[b]) * turn;
        }
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            const Spoke& spoke = m_spokes[i];
            Eigen::Vector3d force = m_cell_stiffness * spoke.weight * tangent(d, b, i);
            if (spoke.partner >= 0) force += spoke.weight * (tangent(d, b, i) + tangent(d, b, spoke.partner));
            if (m_turns) force -= turn.cross(m_levers.col(i));
            force *= 2 * spoke.inverse_length;
            product.col(spoke.vertex) += force;
            product.col(b) -= force;
        }
    }
}

/// In the moves q_i of the tangents: B_ij = 2 (M_ij I + [z_i] C [z_j]) with C the inverse of the inertia and [z] v = z
/// × v.
void BendingTerm::add_blocks(BlockForm& form) const {
    const int cells = static_cast<int>(m_start.size()) - 1;
    const auto cross = [&](int i) {
        Eigen::Matrix3d matrix;
        const auto z = m_levers.col(i);
        matrix << 0, -z.z(), z.y(), z.z(), 0, -z.x(), -z.y(), z.x(), 0;
        return matrix;
    };
    for (int b = 0; b < cells; ++b) {
        Eigen::Matrix3d compliance = Eigen::Matrix3d::Zero(), middle = Eigen::Matrix3d::Zero();
        if (m_turns) compliance = m_turned_compliance[b];
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            const Spoke& spoke = m_spokes[i];
            Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
            const Eigen::Matrix3d turned = m_turns ? Eigen::Matrix3d(cross(i) * compliance) : compliance;
            for (int j = m_start[b]; j < m_start[b + 1]; ++j) {
                double entry = 0;  // M_ij
                if (i == j) entry = m_cell_stiffness * spoke.weight + (spoke.partner >= 0 ? spoke.weight : 0);
                if (j == spoke.partner) entry = spoke.weight;
                if (!m_turns && entry == 0) continue;
                Eigen::Matrix3d B = entry * Eigen::Matrix3d::Identity();
                if (m_turns) B += turned * cross(j);
                B *= 2 * spoke.inverse_length * m_spokes[j].inverse_length;
                sum += B;
                if (i == j) form.add_vertex(spoke.vertex, B);
                if (i < j) form.add_pair(spoke.vertex, m_spokes[j].vertex, B);
            }
            form.add_pair(spoke.vertex, b, -sum);
            middle += sum;
        }
        form.add_vertex(b, middle);
    }
}

/// ‖α p + β q‖² = (α² + αβ) ‖p‖² + (β² + αβ) ‖q‖² − αβ ‖p − q‖².
void BendingTerm::add_bound(QuadraticForm& form) const {
    const int cells = static_cast<int>(m_start.size()) - 1;
    for (int b = 0; b < cells; ++b)
        for (int i = m_start[b]; i < m_start[b + 1]; ++i) {
            const auto [vertex, partner, alpha, weight] = m_spokes[i];
            if (m_turns) form.add_link(vertex, b, 2 * weight * m_cell_stiffness * alpha * alpha);
            if (partner < 0) continue;
            const double beta = m_spokes[partner].inverse_length;
            form.add_link(vertex, b, 2 * weight * (alpha * alpha + alpha * beta));
            if (i < partner) form.add_link(vertex, m_spokes[partner].vertex, -2 * weight * alpha * beta);
        }
}

}  // namespace chebnet
