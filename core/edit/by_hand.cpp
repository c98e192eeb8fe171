#include <algorithm>
#include <limits>
#include <numeric>

#include "edit/editor.h"
#include "net/measures.h"
#include "solve/parts/rest_energy.h"

namespace chebnet {

namespace {

// What a solve takes in hand itself is drawn by so many iterations at most.
constexpr int k_most_by_hand = 100;

/// Whether an edge folds so much more than before that no smooth bend would fold it so. Nets that are rough as they
/// come, as coarse animals are, may fold sharply all over.
bool folds_more(const Net& net, const Positions& before, const Positions& now) {
    const std::vector<double> old_folds = fold_angles(net, before), folds = fold_angles(net, now);
    for (std::size_t k = 0; k < folds.size(); ++k)
        if (folds[k] > old_folds[k] + k_fold) return true;
    return false;
}

}  // namespace

/// Whether a solve that has ended so may be improved on by hand: where what is pressed together had to be made a net by
/// its lengths alone, it is crumpled.
bool Editor::is_crumpled(Status status) const {
    if (!m_may_take_in_hand || !m_reachable || m_region || !m_method->goes_from_net_to_net()) return false;
    return status == Status::stalled || (keeps_lengths(status) && folds_more(*m_net, m_net_before, m_positions));
}

/// From the last net, or where that has all in place, from the rest shape; once in a solve.
bool Editor::take_in_hand(Status without) {
    m_may_take_in_hand = false;
    return take_in_hand(m_net_before, without) || take_in_hand(m_net->rest_positions(), without);
}

/// Draws handles to their places from where a net has them, as a hand does: what is pressed together gives way as a
/// whole. False if this is no net, or has all of them in place.
bool Editor::take_in_hand(const Positions& from, Status without) {
    if (!(max_deviation(*m_net, from) < m_options.threshold)) return false;
    for (const Handle& handle : m_handles) {
        if (!handle.is_exact() || handle.holds_at(from.col(handle.vertex))) continue;
        m_in_hand.push_back(handle.vertex);
        m_is_in_hand[handle.vertex] = true;
    }
    if (m_in_hand.empty()) return false;
    m_took_in_hand = true;
    m_taken_at = m_iterations;
    m_without_hand = {without, m_positions, energy()};
    m_positions = from;
    hold_back(true);
    return true;
}

/// After a solve that has taken handles in hand itself has ended: near their places they are held there; where that
/// does not lead to a net of less energy than what was found without a hand, that is the end again.
bool Editor::goes_on_by_hand(SolveReport& report) {
    if (m_holds_back && keeps_lengths(report.status) && is_nearly_there()) {
        hold_back(false);
        return true;
    }
    const bool is_better = !m_holds_back && has_all_in_place() && energy() < m_without_hand.energy;
    empty_hand();
    if (is_better && report.status == Status::max_iterations) report.status = Status::exact;
    if (is_better) return false;
    m_positions = m_without_hand.positions;
    m_unit_positions = in_unit(m_positions);
    report.status = m_without_hand.status;
    if (keeps_lengths(report.status)) begin_solve(report.trace);  // the method knows it again
    return false;
}

bool Editor::has_all_in_place() const {
    return std::all_of(m_handles.begin(), m_handles.end(), [&](const Handle& handle) {
        return !handle.is_exact() || handle.holds_at(m_positions.col(handle.vertex));
    });
}

/// Of what take_in_hand() took, while it is on its way: it is not drawn for ever.
Status Editor::drawn_by_hand() const {
    if (m_iterations - m_taken_at < k_most_by_hand) return Status::running;
    return is_nearly_there() ? Status::exact : Status::stalled;
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
