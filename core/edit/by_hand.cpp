#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

#include "base/angle.h"
#include "edit/editor.h"
#include "net/measures.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/handle_walk.h"
#include "solve/parts/rest_energy.h"

namespace chebnet {

namespace {

// What a solve takes in hand itself is drawn by so many iterations at most, and by half of those that are left; and in
// each step by so many, and held where that ends by as many, before the walk goes on.
constexpr int k_most_by_hand = 100, k_most_of_a_step = 8;
// Where so many draws after each other leave no less than this part of the way, none will lead there.
constexpr int k_most_idle_draws = 3;
constexpr double k_gain = 0.99;
// The least iterations with which a walk past the limit begins. It takes half of them; should it lead nowhere, the
// lengths alone have the others.
constexpr int k_past_limit = 80;
// So near to the limit, in radians, a corner is held by it.
constexpr double k_at_limit = 0.5 * k_degree;

}  // namespace

/// What a solve knows that has taken handles in hand itself.
struct Editor::ByHand {
    Positions before;                                       // what it had come to
    int until = 0;                                          // no step begins after this iteration
    HandleWalk way;                                         // of the step under way
    double left = std::numeric_limits<double>::infinity();  // the least that a step had still to go, in edge lengths
    int idle_draws = 0;                                     // since a step had markedly less
    Positions goals;                                        // where that ends
    int since = 0;                                          // in which iteration it began
    struct Found {
        Status status;
        Positions positions;
        double energy;
    };
    std::optional<Found> found;  // where another net is looked for all the same
};

/// Draws handles from where the last net has them, or if those are their places, the rest shape; once in a solve. What
/// it has come to is kept for where that leads nowhere. False if neither is a net to begin with.
bool Editor::take_in_hand() {
    m_run.may_take_in_hand = false;
    m_run.by_hand = std::make_shared<ByHand>();
    m_run.by_hand->before = m_positions;
    m_run.by_hand->until =
        m_run.iterations + std::min(k_most_by_hand, (m_options.max_iterations - m_run.iterations) / 2);
    return take_in_hand(m_run.net_before) || take_in_hand(m_net->rest_positions());
}

/// From where a net has them. False if this is no net, or has all of them in place.
bool Editor::take_in_hand(const Positions& from) {
    if (!(max_deviation(*m_net, from) < m_options.threshold)) return false;
    for (const Handle& handle : m_handles) {
        if (!handle.is_exact() || handle.holds_at(from.col(handle.vertex))) continue;
        m_hand.take(handle.vertex, Hand::Owner::solve);
    }
    if (m_hand.is_empty()) return false;
    stand_at(from);
    m_run.by_hand->way.set_handles(HeldVertices(m_net->vertex_count(), m_hand.vertices(), {}), *m_topology);
    draw_a_step();
    return true;
}

/// Pulls what is in hand, from where it stands, as far as a walk goes in a step.
void Editor::draw_a_step() {
    auto& [before, until, way, left, idle_draws, goals, since, found] = *m_run.by_hand;
    Positions to = m_positions;
    for (int vertex : m_hand.vertices()) to.col(vertex) = m_handles[m_handle_at[vertex]].target;
    way.begin(m_positions, to, m_net->mean_length());
    idle_draws = way.length() < k_gain * left ? 0 : idle_draws + 1;
    left = std::min(left, way.length());
    way.go_to(way.next());
    goals = way.walked() < 1 ? Positions(m_positions + way.moves_to(way.walked(), m_positions)) : to;
    since = m_run.iterations;
    hold_back(true);
}

/// Where a handle is to be now.
Eigen::Vector3d Editor::goal(const Handle& handle) const {
    const bool is_on_step = draws_handles() && m_hand.holds(handle.vertex) && m_run.by_hand->way.walked() < 1;
    return is_on_step ? Eigen::Vector3d(m_run.by_hand->goals.col(handle.vertex)) : handle.target;
}

/// After a solve that has taken handles in hand itself has ended. What has given way to the pull of a step is held at
/// its end, and walks on from there; where that leads no farther, it is drawn by the next step.
bool Editor::goes_on_by_hand(SolveReport& report) {
    const bool is_net = max_deviation(*m_net, m_positions) < m_options.threshold;
    if (is_net && m_hand.holds_back() && is_nearly_there()) {
        m_run.by_hand->since = m_run.iterations;
        hold_back(false);
        return true;
    }
    const bool is_held = is_net && !m_hand.holds_back(), is_stuck = report.status == Status::unreachable;
    const bool may_draw = m_run.iterations > m_run.by_hand->since && m_run.iterations < m_run.by_hand->until &&
                          m_run.by_hand->idle_draws < k_most_idle_draws;
    if (is_held && is_stuck && may_draw) {
        draw_a_step();
        return true;
    }
    if (is_held && !is_stuck && m_run.by_hand->way.walked() < 1) {
        m_run.by_hand->way.go_to(1);
        return true;
    }
    return goes_on_without_hand(is_held && has_all_in_place(), report);
}

/// Where handles that were taken in hand have not arrived, or the net came out crumpled all the same, it is looked for
/// past the limit that was in their way, or by its lengths alone.
bool Editor::goes_on_without_hand(bool has_arrived, SolveReport& report) {
    const bool is_last = m_run.iterations >= m_options.max_iterations;
    if (has_arrived && is_last) report.status = Status::exact;
    if (has_arrived && (is_last || new_folds(*m_net, m_run.net_before, m_positions) == 0)) {
        empty_hand();
        return false;
    }
    if (has_arrived) m_run.by_hand->found = {report.status, m_positions, energy()};
    m_run.limit_gives_way = may_pass_limit();
    give_up_by_hand();
    if (m_run.limit_gives_way) stand_at(m_net->rest_positions());
    return true;
}

/// Whether the net that handles were drawn to has corners at the limit, and enough iterations are left.
bool Editor::may_pass_limit() const {
    const bool has_time = m_run.iterations + k_past_limit <= m_options.max_iterations;
    return has_time && !corner_limit(*m_net, m_options, k_at_limit).is_kept(m_positions);
}

/// From a walk past the limit, to which that gave way no more than the handles made it: it is asked for again, or where
/// no walk leads to them even so, the lengths alone.
bool Editor::goes_on_past_limit(Status status) {
    m_run.limit_gives_way = false;
    if (status == Status::unreachable) stand_at(m_run.by_hand->before);
    return true;
}

/// What it had come to before it took handles in hand.
void Editor::give_up_by_hand() {
    empty_hand();
    stand_at(m_run.by_hand->before);
}

/// Where handles hold, but for those in hand, and those that slide have come to stand. A budget may run out before the
/// method moves the net from there.
void Editor::stand_at(const Positions& positions) {
    m_positions = positions;
    for (Handle& handle : m_handles)
        if (handle.is_exact()) handle.follow(m_positions.col(handle.vertex));
}

/// What comes by while another net is looked for is none.
void Editor::show_found_net() {
    if (!m_run.by_hand || !m_run.by_hand->found) return;
    m_positions = m_run.by_hand->found->positions;
    snap_held();
}

/// After a solve that looked for a net by its lengths alone, too: that of less energy stays.
void Editor::take_better_net(SolveReport& report) {
    if (!m_run.by_hand || !m_run.by_hand->found || energy() < m_run.by_hand->found->energy) return;
    m_positions = m_run.by_hand->found->positions;
    m_unit_positions = in_unit(m_positions);
    report.status = m_run.by_hand->found->status;
    begin_solve(report.trace);  // the method knows it again
    store_positions();
}

/// Handles on their way leave an exact net behind them, which says nothing of how far they have come.
double Editor::deviation_with_hand_at_targets() const {
    Positions x = m_unit_positions;
    for (int vertex : m_hand.vertices()) {
        const Handle& handle = m_handles[m_handle_at[vertex]];
        copy_along(k_all_axes - handle.slides, Eigen::Vector3d(handle.target / m_unit).data(), x.col(vertex).data());
    }
    return max_deviation(*m_unit_net, x);
}

/// The status of what take_in_hand() took, while it is under way: a step has its end.
Status Editor::status_by_hand() const {
    const bool has_time = m_run.iterations - m_run.by_hand->since < k_most_of_a_step &&
                          (!m_hand.holds_back() || m_run.iterations < m_run.by_hand->until);
    return has_time || m_run.by_hand->way.walked() == 1 ? Status::running : Status::exact;
}

/// Of the method's last net; infinite where it has found none.
double Editor::energy() const {
    const std::optional<RestState> state = rest_state();
    if (!state || !(max_deviation(*m_net, m_positions) < m_options.threshold))
        return std::numeric_limits<double>::infinity();
    const std::span<const double> energies = state->energy.values();
    return std::accumulate(energies.begin(), energies.end(), 0.0);
}

}  // namespace chebnet
