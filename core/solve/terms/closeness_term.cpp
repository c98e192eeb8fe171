#include "solve/terms/closeness_term.h"

#include "surface/height.h"

namespace chebnet {

ClosenessTerm::ClosenessTerm(const Net& net, const Guide& guide, double unit, double weight, Side side)
    : m_guide(guide),
      m_unit(unit),
      m_scale(weight / (net.mean_length() * net.mean_length())),
      m_side(side),
      m_faces(static_cast<std::size_t>(net.vertex_count()), 0),
      m_changes(static_cast<std::size_t>(net.vertex_count()), Eigen::Matrix3d::Zero()) {}

double ClosenessTerm::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) {
    double energy = 0;
    for (int v = 0; v < x.cols(); ++v) {
        const Offset offset = offset_of(m_guide.surface(), m_guide.tree(), m_unit * x.col(v), m_faces[v]);
        m_faces[v] = offset.face;
        m_changes[v].setZero();
        const double height = m_guide.is_inside_out(offset.face) ? -offset.along_normal : offset.along_normal;
        if (m_side == Side::below && !(height < 0)) continue;
        m_changes[v] = offset.change;
        const Eigen::Vector3d away = offset.away / m_unit;
        energy += m_scale * away.squaredNorm();
        gradient.col(v) += 2 * m_scale * away;
    }
    return energy;
}

void ClosenessTerm::add_curvature(Curvature, const Eigen::Matrix3Xd& d, Eigen::Matrix3Xd& product) const {
    for (int v = 0; v < d.cols(); ++v) product.col(v) += 2 * m_scale * (m_changes[v] * d.col(v));
}

void ClosenessTerm::add_blocks(BlockForm& form) const {
    for (std::size_t v = 0; v < m_changes.size(); ++v) form.add_vertex(static_cast<int>(v), 2 * m_scale * m_changes[v]);
}

void ClosenessTerm::add_bound(QuadraticForm& form) const {
    for (std::size_t v = 0; v < m_changes.size(); ++v) form.add_vertex(static_cast<int>(v), 2 * m_scale);
}

std::unique_ptr<Term> make_closeness_term(const Net& net, const Guide& guide, double unit, double weight,
                                          ClosenessTerm::Side side) {
    return std::make_unique<ClosenessTerm>(net, guide, unit, weight, side);
}

}  // namespace chebnet
