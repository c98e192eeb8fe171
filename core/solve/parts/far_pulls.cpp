// What RestDescent does where soft handles pull from afar.

#include <algorithm>
#include <cmath>

#include "solve/parts/bow.h"
#include "solve/parts/pull_walk.h"
#include "solve/parts/rest_descent.h"

namespace chebnet {

namespace {

// Tries of a step of the walk.
constexpr int k_most_pull_trials = 8;
// In edge lengths: farther away lengths have too few digits for a net to be at rest.
constexpr double k_farthest = 1e6;

}  // namespace

void RestDescent::take_pulls(std::span<const Pull> pulls) {
    m_rest_energy.move_pulls(*m_net, pulls);
    m_pulls_wait = !pulls.empty();
    m_pulls_walk = false;
    if (!m_pull_walk) m_pull_walk = std::make_shared<PullWalk>();
    m_pull_walk->take(pulls);
}

std::span<const Pull> RestDescent::pulls_on_their_way() const { return m_pull_walk->now(); }

/// A net that has no force with pulls at their targets stays. A flat one may have to bow, be it drawn ever so little.
void RestDescent::begin_pull_walk(const Positions& positions) {
    m_pulls_wait = false;
    if (is_balanced()) return;
    const bool is_flat = normal_of_flat(*m_net, positions, up_axis(m_options)).has_value();
    m_pull_walk->begin(positions, m_pulls_are_known, m_net->mean_length(), is_flat);
    if (m_pull_walk->walked() < 1) walk_pulls_to(0, positions);
}

/// With all pulls this part of their way; where it has no multipliers then, at their targets.
void RestDescent::walk_pulls_to(double part, const Positions& positions) {
    m_pull_walk->go_to(part);
    m_pulls_walk = part < 1;
    m_rest_energy.move_pulls(*m_net, m_pull_walk->now());
    enter(positions);
    if (!m_is_linearised && part < 1) walk_pulls_to(1, positions);
}

/// One step of the way, or where no net is so near as that, a shorter one, and one Newton step. Where no step leads to
/// a net, the pulls are at their targets at once.
Status RestDescent::follow_pulls(Positions& positions, TraceRow& row) {
    const double walked = m_pull_walk->walked();
    double part = m_pull_walk->next();
    int trial = 0;
    for (; trial < k_most_pull_trials; ++trial, part = walked + (part - walked) / 2) {
        Eigen::Matrix3Xd moves = follow(m_pull_walk->moves_to(part));
        add_bow(positions, moves);
        Positions x = positions + moves;
        if (!project(x)) continue;
        positions = x;
        break;
    }
    walk_pulls_to(trial < k_most_pull_trials ? part : 1, positions);
    begin_steps();
    if (m_is_linearised) take_step(positions, row);
    return Status::running;
}

/// How what is free, 3×V, follows targets that move by these in their place: as far as the energy's bound is the
/// energy, to first order.
Eigen::Matrix3Xd RestDescent::follow(std::span<const Pull> moves) const {
    const double unit = m_net->mean_length();
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, m_net->vertex_count()), follows;
    for (const auto& [v, move, weight, yields] : moves) forces.col(v) = 2 * weight / (unit * unit) * move;
    m_newton->give_way(forces, follows);
    return follows;
}

/// Step by step such a piece would be drawn there like a load by a stiff spring.
void RestDescent::follow_lone_pulls(std::span<const std::vector<int>> loose_pieces, std::span<const Pull> pulls,
                                    Positions& positions) {
    std::vector<const Pull*> pull_at(static_cast<std::size_t>(positions.cols()));
    for (const Pull& pull : pulls) pull_at[pull.vertex] = &pull;
    Positions moved = positions;
    for (const std::vector<int>& piece : loose_pieces) {
        const auto is_pulled = [&](int v) { return pull_at[v] != nullptr; };
        if (std::count_if(piece.begin(), piece.end(), is_pulled) != 1) continue;
        const Pull& pull = *pull_at[*std::find_if(piece.begin(), piece.end(), is_pulled)];
        const Eigen::Vector3d shift = pull.target - positions.col(pull.vertex);
        const bool is_of_hand = std::isfinite(pull.yields), is_far = shift.norm() > k_farthest * m_net->mean_length();
        if (is_of_hand || is_far) continue;
        for (int v : piece) moved.col(v) += shift;
    }
    if (moved == positions) return;
    const double energy = m_energy;
    enter(moved);
    if (m_max_deviation < m_options.threshold && m_energy < energy)
        positions = moved;
    else
        enter(positions);
}

}  // namespace chebnet
