#include "solve/parts/spring_descent.h"

namespace chebnet {

namespace {

constexpr double k_sufficient_decrease = 1e-4;  // of Armijo's rule
constexpr int k_max_halvings = 10;

}  // namespace

SpringDescent::SpringDescent(LaplacianPart& part, std::span<const Slide> slides)
    : m_part(part),
      m_slides(slides.begin(), slides.end()),
      m_gradient(4, part.part().size()),
      m_next_gradient(4, part.part().size()),
      m_direction(4, part.part().size()),
      m_gradient_change(4, part.part().size()) {}

void SpringDescent::start(const Positions& positions, const Positions& centres) {
    m_centres = &centres;
    m_history.clear();
    m_energy = evaluate(positions, m_gradient);
}

/// Sets the parts of what is kept to 0, of moves or gradients. Taken off both sides of the first guess of the Hessian's
/// inverse it leaves one of the coordinates that may move.
template <typename Moves>
void SpringDescent::keep_what_slides(Moves& moves) const {
    for (const auto& [vertex, along] : m_slides)
        for (int k = 0; k < 3; ++k)
            if (!has_axis(along, k)) moves(k, m_part.part().node_of(vertex)) = 0;
}

bool SpringDescent::iterate(Positions& positions) {
    m_descent = -m_gradient.cast<float>();
    m_direction = m_descent;
    // The Hessian of Σ ‖d_e − t_e‖² is twice the Laplacian.
    m_history.apply(m_direction, [&](Eigen::Matrix4Xf& d) {
        m_part.solve_in_place(d);
        d /= 2;
    });
    keep_what_slides(m_direction);
    const double slope = -dense::dot(m_descent.data(), m_direction.data(), static_cast<int>(m_direction.size()));
    const std::vector<int>& vertices = m_part.part().vertices();
    m_origin = positions;
    m_step = 1;
    for (int halving = 0; halving <= k_max_halvings; ++halving, m_step /= 2) {
        for (int i = 0; i < m_part.part().size(); ++i)
            positions.col(vertices[i]) =
                m_origin.col(vertices[i]) + m_step * m_direction.col(i).head<3>().cast<double>();
        const double energy = evaluate(positions, m_next_gradient);
        if (!(energy <= m_energy + k_sufficient_decrease * m_step * slope)) continue;
        m_energy = energy;
        m_direction *= static_cast<float>(m_step);
        m_gradient_change = (m_next_gradient - m_gradient).cast<float>();
        m_history.learn(m_direction, m_gradient_change);
        m_gradient.swap(m_next_gradient);
        return true;
    }
    positions = m_origin;
    m_step = 0;
    return false;
}

double SpringDescent::evaluate(const Positions& positions, Eigen::Matrix4Xd& gradient) const {
    const Net& net = m_part.net();
    double energy = 0;
    gradient.setZero();
    for (const FreePart::Edge& edge : m_part.part().edges()) {
        const Eigen::Vector3d d = positions.col(net.edges()(0, edge.index)) - positions.col(net.edges()(1, edge.index));
        const double length = d.norm(), off = length - net.rest_lengths()[edge.index];
        energy += off * off;
        if (length == 0) continue;  // no direction to push in; neighbours will open it
        const Eigen::Vector3d force = 2 * off / length * d;
        if (edge.node_a >= 0) gradient.col(edge.node_a).head<3>() += force;
        if (edge.node_b >= 0) gradient.col(edge.node_b).head<3>() -= force;
    }
    for (const Pull& pull : m_part.pulls()) {
        const Eigen::Vector3d off = positions.col(pull.vertex) - m_centres->col(pull.vertex);
        energy += pull.weight * off.squaredNorm();
        gradient.col(m_part.part().node_of(pull.vertex)).head<3>() += 2 * pull.weight * off;
    }
    keep_what_slides(gradient);
    return energy;
}

}  // namespace chebnet
