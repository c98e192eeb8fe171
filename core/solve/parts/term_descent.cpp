#include "solve/parts/term_descent.h"

#include <algorithm>

namespace chebnet {

namespace {

constexpr double k_term_shift = 1e-4;  // of the diagonal, in the unit of energies
constexpr double k_term_decrease = 1e-4;
constexpr int k_most_halvings = 12;

}  // namespace

TermDescent::TermDescent(const Net& net, const Topology& topology, const FreePart& part)
    : m_net(net), m_part(part), m_pairs(net, topology), m_system(m_pairs, part) {}

double TermDescent::evaluate(std::span<const std::unique_ptr<Term>> terms, const Positions& x) {
    m_gradient.setZero(3, x.cols());
    double energy = 0;
    for (const auto& term : terms) energy += term->evaluate(x, m_gradient);
    return energy;
}

double TermDescent::step(std::span<const std::unique_ptr<Term>> terms, double radius, Positions& positions) {
    const double before = evaluate(terms, positions), L = m_net.mean_length();
    m_system.set_zero();
    for (const auto& term : terms) term->add_blocks(m_system);
    for (const int v : m_part.vertices()) m_system.add_vertex(v, k_term_shift / (L * L) * Eigen::Matrix3d::Identity());
    if (!m_system.factorize()) return 0;
    Eigen::Matrix3Xd direction = Eigen::Matrix3Xd::Zero(3, positions.cols());
    m_system.solve(-m_gradient, direction);
    const double slope = m_gradient.cwiseProduct(direction).sum(), longest = direction.colwise().norm().maxCoeff();
    if (!(slope < 0 && longest > 0)) return 0;
    const Positions origin = positions;
    double part = std::min(1.0, radius / longest);
    for (int trial = 0; trial <= k_most_halvings; ++trial, part /= 2) {
        positions = origin + part * direction;
        if (evaluate(terms, positions) <= before + k_term_decrease * part * slope) return part * longest;
    }
    positions = origin;
    return 0;
}

}  // namespace chebnet
