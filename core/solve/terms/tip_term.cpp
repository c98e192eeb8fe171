#include "solve/terms/tip_term.h"

#include <span>
#include <utility>

namespace chebnet {

TipTerm::TipTerm(const Net& net, const Topology& topology, double weight) : m_weight(weight) {
    for (int b = 0; b < net.vertex_count(); ++b) {
        if (!topology.is_singular(b)) continue;
        const std::span<const int> ends = topology.neighbours(b), edges = topology.incident_edges(b);
        Hub hub{b, {}};
        for (std::size_t i = 0; i < ends.size(); ++i) hub.spokes.push_back({ends[i], 1 / net.rest_lengths()[edges[i]]});
        m_hubs.push_back(std::move(hub));
    }
}

double TipTerm::multiply(const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& product) const {
    double sum = 0;
    for (const auto& [b, spokes] : m_hubs) {
        Eigen::Vector3d tip = Eigen::Vector3d::Zero();
        for (const auto& [end, inverse_length] : spokes) tip += inverse_length * (x.col(end) - x.col(b));
        sum += m_weight * tip.dot(tip);
        for (const auto& [end, inverse_length] : spokes) {
            const Eigen::Vector3d force = 2 * m_weight * inverse_length * tip;
            product.col(end) += force;
            product.col(b) -= force;
        }
    }
    return sum;
}

double TipTerm::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) { return multiply(x, gradient); }

void TipTerm::add_curvature(Curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const {
    multiply(d, product);
}

/// With p_i = x_i − x_b: ‖Σ α_i p_i‖² = Σ_i α_i (Σ_j α_j) ‖p_i‖² − Σ_(i<j) α_i α_j ‖p_i − p_j‖².
template <class AddLink>
void TipTerm::add_links(const AddLink& add_link) const {
    for (const auto& [b, spokes] : m_hubs) {
        double sum = 0;
        for (const Spoke& spoke : spokes) sum += spoke.inverse_length;
        for (std::size_t i = 0; i < spokes.size(); ++i) {
            const auto& [end, inverse_length] = spokes[i];
            add_link(end, b, m_weight * inverse_length * sum);
            for (std::size_t j = 0; j < i; ++j)
                add_link(end, spokes[j].end, -m_weight * inverse_length * spokes[j].inverse_length);
        }
    }
}

void TipTerm::add_blocks(BlockForm& form) const {
    add_links([&](int a, int b, double weight) { form.add_link(a, b, 2 * weight * Eigen::Matrix3d::Identity()); });
}

void TipTerm::add_bound(QuadraticForm& form) const {
    add_links([&](int a, int b, double weight) { form.add_link(a, b, 2 * weight); });
}

}  // namespace chebnet
