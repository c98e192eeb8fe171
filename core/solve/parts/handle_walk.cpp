#include "solve/parts/handle_walk.h"

#include <algorithm>
#include <utility>

#include "solve/parts/rigid_motion.h"

namespace chebnet {

namespace {

// Where handles move by more edge lengths than one step takes, the net follows in several, with as much care as a slow
// hand takes, so that it ends where that would.
constexpr double k_one_step = 1, k_careful_step = 0.25;
// So far goes no hand in a frame or two.
constexpr double k_jump = 8;
constexpr double k_least_stride = 1.0 / 50;  // of the way: far jumps end, too
// Of a step: where so little is left of it, the net is about to be taut.
constexpr double k_least_progress = 0.1;
// A step repeats so much of the one before it, and no more than so many times that. Less than all, so that what was
// rough in one does not grow from step to step.
constexpr double k_repeated = 0.95, k_most_repeated = 2;
// What a net counts for, beside one handle, where handles alone do not say how a shape is turned.
constexpr double k_free_weight = 1e-10;

Positions columns_of(const Positions& all, const std::vector<int>& vertices) {
    Positions columns(3, static_cast<Eigen::Index>(vertices.size()));
    for (Eigen::Index i = 0; i < columns.cols(); ++i) columns.col(i) = all.col(vertices[i]);
    return columns;
}

Eigen::VectorXd entries_of(const Eigen::VectorXd& all, const std::vector<int>& vertices) {
    Eigen::VectorXd entries(static_cast<Eigen::Index>(vertices.size()));
    for (Eigen::Index i = 0; i < entries.size(); ++i) entries[i] = all[vertices[i]];
    return entries;
}

/// From a shape to where vertices are, by those that are held, which have the weight 1 and others 0, and as far as
/// these do not tell, by all.
RigidMotion placing(const Positions& shape, const Positions& to, const Eigen::VectorXd& is_held) {
    const RigidMotion by_held = is_held.sum() < 3 ? RigidMotion{} : fit_rigid_motion(shape, to, is_held);
    if (by_held.is_determined) return by_held;
    return fit_rigid_motion(shape, to, (is_held.array() + k_free_weight / static_cast<double>(to.cols())).matrix());
}

}  // namespace

void HandleWalk::set_handles(HeldVertices held, const Topology& topology) {
    m_held = std::move(held);
    m_topology = &topology;
    m_pieces = topology.components();
    for (std::vector<int>& piece : m_pieces) std::sort(piece.begin(), piece.end());
}

void HandleWalk::begin(const Positions& from, const Positions& to, double edge_length) {
    m_from = from;
    m_to = to;
    m_edge_length = edge_length;
    m_length = way_left(m_from);
    m_stride = m_length <= k_one_step ? 1 : std::max(k_careful_step / m_length, k_least_stride);
    m_walked = 0;
    m_turned = TurnedHandles::find(*m_topology, m_held, m_from, m_to);
}

bool HandleWalk::is_jump() const { return m_length > k_jump; }

double HandleWalk::next() const { return std::min(1.0, m_walked + m_stride); }

bool HandleWalk::is_nearly_stuck_since(double walked) const {
    return m_walked - walked < k_least_progress * std::min(m_stride, 1 - walked);
}

Eigen::Matrix3Xd HandleWalk::moves_to(double part, const Positions& from) const {
    Eigen::Matrix3Xd moves = Eigen::Matrix3Xd::Zero(3, from.cols());
    for (int v : m_held.vertices())
        moves.col(v) = m_held.held_part(v, m_from.col(v) + part * (m_to.col(v) - m_from.col(v)) - from.col(v));
    if (m_turned) m_turned->go(part, m_from, m_to, from, moves);
    return moves;
}

double HandleWalk::take_off_repeated(Eigen::Matrix3Xd& moves) const {
    double along = 0, before = 0;
    for (int v : m_held.vertices()) {
        const Eigen::Vector3d last = m_held.held_part(v, m_last_move.col(v));
        along += moves.col(v).dot(last);
        before += last.squaredNorm();
    }
    const double part = before > 0 ? k_repeated * std::clamp(along / before, -k_most_repeated, k_most_repeated) : 0;
    for (int v : m_held.vertices()) moves.col(v) -= part * m_held.held_part(v, m_last_move.col(v));
    return part;
}

double HandleWalk::way_left(const Positions& from) const { return m_held.farthest(from, m_to) / m_edge_length; }

bool HandleWalk::ends_as_in(const Positions& shape, const Positions& like) const {
    return way_left(placed(shape, like)) < k_same;
}

Positions HandleWalk::placed(const Positions& shape, const Positions& like) const {
    Positions to = like;
    m_held.take_held(m_to, to);
    Eigen::VectorXd is_held = Eigen::VectorXd::Zero(to.cols());
    for (int v : m_held.vertices()) is_held[v] = 1;
    for (const std::vector<int>& piece : m_pieces) {
        carry_along(piece, is_held, like, to);
        const RigidMotion motion =
            m_pieces.size() == 1 ? placing(shape, to, is_held)
                                 : placing(columns_of(shape, piece), columns_of(to, piece), entries_of(is_held, piece));
        for (int v : piece) to.col(v) = motion.of(shape.col(v));
    }
    return to;
}

}  // namespace chebnet
