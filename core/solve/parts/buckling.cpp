#include <random>

#include "solve/parts/tangent_newton.h"

namespace chebnet {

namespace {

// Edge lengths, beyond where the search looks.
constexpr double k_far = 1e6;
// Edges push that push harder than this, in the unit of energies.
constexpr double k_push = 1e-4;

}  // namespace

bool TangentNewton::find_buckling(std::span<const std::unique_ptr<Term>> terms, int most_iterations,
                                  Eigen::Matrix3Xd& d) {
    if (!(m_multipliers.head(m_net.edge_count()).minCoeff() < -k_push)) return false;
    std::minstd_rand numbers;  // the same each time
    m_residual.resize(3, m_net.vertex_count());
    for (Eigen::Index k = 0; k < m_residual.size(); ++k)
        m_residual.data()[k] = static_cast<double>(numbers()) / std::minstd_rand::max() - 0.5;
    mask(m_residual);
    project_forces(m_residual);
    precondition(m_residual, m_preconditioned);
    m_enough = 0;
    d.setZero(3, m_net.vertex_count());
    descend(terms, Curvature::exact, most_iterations, k_far * m_net.mean_length(), d);
    d = m_search;
    return m_met_negative_curvature;
}

}  // namespace chebnet
