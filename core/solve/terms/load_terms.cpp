#include "solve/terms/load_terms.h"

#include <cmath>

#include "linear/dense_kernels.h"

namespace chebnet {

PullTerm::PullTerm(const Net& net, std::span<const Pull> pulls)
    : m_scale(1 / (net.mean_length() * net.mean_length())),
      m_pulls(pulls.begin(), pulls.end()),
      m_curvatures(pulls.size(), Eigen::Matrix3d::Zero()) {}

double PullTerm::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) {
    double energy = 0;
    for (std::size_t i = 0; i < m_pulls.size(); ++i) {
        const Pull& pull = m_pulls[i];
        const Eigen::Vector3d off = x.col(pull.vertex) - pull.target, strain = off / pull.yields;
        const double root = std::sqrt(1 + strain.squaredNorm()), weight = 2 * m_scale * pull.weight / root;
        // 2 r² (root − 1), without its cancellation where r is large.
        energy += 2 * m_scale * pull.weight * off.squaredNorm() / (root + 1);
        gradient.col(pull.vertex) += weight * off;
        m_curvatures[i] = weight * (Eigen::Matrix3d::Identity() - strain * strain.transpose() / (root * root));
    }
    return energy;
}

void PullTerm::add_curvature(Curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const {
    for (std::size_t i = 0; i < m_pulls.size(); ++i)
        product.col(m_pulls[i].vertex) += m_curvatures[i] * d.col(m_pulls[i].vertex);
}

void PullTerm::add_blocks(BlockForm& form) const {
    for (std::size_t i = 0; i < m_pulls.size(); ++i) form.add_vertex(m_pulls[i].vertex, m_curvatures[i]);
}

void PullTerm::add_bound(QuadraticForm& form) const {
    for (const Pull& pull : m_pulls) form.add_vertex(pull.vertex, 2 * m_scale * pull.weight);
}

GravityTerm::GravityTerm(const Net& net, double g, const Eigen::Vector3d& down, const std::vector<bool>& weightless)
    : m_gradient(Eigen::Matrix3Xd::Zero(3, net.vertex_count())) {
    const double L = net.mean_length();
    for (int e = 0; e < net.edge_count(); ++e) {
        if (!weightless.empty() && weightless[net.edges()(0, e)]) continue;
        for (int side = 0; side < 2; ++side)
            m_gradient.col(net.edges()(side, e)) -= g * net.rest_lengths()[e] / (2 * L * L) * down;
    }
}

double GravityTerm::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) {
    gradient += m_gradient;
    return dense::dot(m_gradient.data(), x.data(), static_cast<int>(x.size()));
}

}  // namespace chebnet
