#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <utility>

#include "base/error.h"
#include "edit/editor.h"
#include "edit/near_targets.h"
#include "net/measures.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/held_vertices.h"

// A run of an editor: from what is to be held where, by the method's iterations, to the positions it comes to.

namespace chebnet {

namespace {

/// How near to the reach of other handles what is in hand walks, before it is pulled on, and how often it is drawn
/// there.
constexpr double k_nearly_taut = 0.995;
constexpr int k_most_drawn = 30;
// Lines that are to be straight are held so when no vertex of them is farther from that, in edge lengths: from there on
// they go straight as nets.
constexpr double k_nearly_straight = 0.05;

}  // namespace

SolveReport Editor::solve(const Budget& budget) {
    try {
        return go_on(budget);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        refuse_size(error.what());
    } catch (const std::bad_alloc&) {
        refuse_size("there is not enough memory");
    }
}

/// The method starts a new solve at the next call. Handles that this one was drawing are at their targets again.
void Editor::refuse_size(const std::string& reason) {
    if (draws_handles()) give_up_by_hand();
    m_prepared = false;
    m_running = false;
    const std::string way_out =
        m_method_name == k_light_method ? "make it coarser" : std::string(k_light_method) + " needs less";
    throw Error(ErrorCode::too_large, "a net of " + std::to_string(m_net->vertex_count()) +
                                          " vertices is too large for method " + m_method_name + ": " + reason + "; " +
                                          way_out);
}

SolveReport Editor::go_on(const Budget& budget) {
    const Stopwatch watch;
    SolveReport report;
    const bool is_begun = m_running;
    if (!is_begun) begin_run(report);
    run(budget, watch, is_begun, report);
    end_run(report);
    report.milliseconds = watch.milliseconds();
    m_run.elapsed_ms += report.milliseconds;
    return report;
}

void Editor::begin_run(SolveReport& report) {
    m_run = {};
    // What is pressed together would come out crumpled where it is made a net by its lengths alone.
    m_run.may_take_in_hand = m_hand.is_empty() && !m_region;
    m_run.net_before = m_last_net;
    if (has_net_in_place()) m_run.begun_in_place = m_positions;
    report.status = begin_solve(report.trace);
}

/// Until it ends or the budget runs out. `has_moved`: the method has moved the net since it was started.
void Editor::run(const Budget& budget, const Stopwatch& watch, bool has_moved, SolveReport& report) {
    for (;;) {
        const bool has_no_more = report.status == Status::running && m_run.iterations >= m_options.max_iterations;
        if (has_no_more) report.status = m_run.reachable ? Status::max_iterations : Status::unreachable;
        if (has_no_more && !draws_handles()) return;
        if (report.status != Status::running) {
            // Where nothing is free the method has nothing to do: handles alone have moved the net.
            if (has_moved || keeps_lengths(report.status)) store_positions();
            if (!begins_again(report)) return;
            has_moved = false;
            continue;
        }
        const bool is_spent = report.iterations >= budget.iterations || watch.milliseconds() >= budget.milliseconds;
        if (is_spent && report.iterations > 0) {
            // Before the method has moved it, what is in hand leaves no net behind it, nor does what is held straight.
            if (has_moved || (m_hand.is_empty() && !has_net_in_place())) store_positions();
            return;
        }
        make_iteration(watch, report);
        has_moved = true;
    }
}

/// After the method has ended: whether it has been started anew, for another way of holding the net.
bool Editor::begins_again(SolveReport& report) {
    const bool found_rest = report.status == Status::converged;
    const bool goes_on = draws_handles() ? goes_on_by_hand(report) : goes_on_otherwise(report.status);
    if (!goes_on && (found_rest || !find_taut_lines())) return false;
    report.status = begin_solve(report.trace);
    return true;
}

void Editor::make_iteration(const Stopwatch& watch, SolveReport& report) {
    TraceRow row;
    report.status = iterate(row);
    row.iteration = ++m_run.iterations;
    if (report.status == Status::running && draws_handles()) report.status = status_by_hand();
    if (draws_handles()) row.max_deviation = deviation_with_hand_at_targets();
    row.total_ms = m_run.elapsed_ms + watch.milliseconds();
    report.factorisation_ms += row.factorisation_ms;
    report.trace.push_back(row);
    ++report.iterations;
}

Status Editor::iterate(TraceRow& row) {
    const Status status = m_method->iterate(m_unit_positions, row);
    if (status != Status::non_finite && m_unit_positions.allFinite()) return status;
    load_positions();
    return Status::non_finite;
}

/// Or leaves it to the next call, where the status is `running`.
void Editor::end_run(SolveReport& report) {
    m_running = report.status == Status::running;
    if (m_running) {
        show_found_net();
    } else {
        store_positions();
        take_better_net(report);
        take_back_net(report);
    }
    if (const std::optional<RestState> state = rest_state()) report.to_rest = state->left;
    report.max_deviation = max_deviation(*m_net, m_positions);
    if (report.max_deviation < m_options.threshold) m_last_net = m_positions;
    if (keeps_lengths(report.status) && !(report.max_deviation < m_options.threshold))
        report.status = Status::unreachable;  // the net is exact, but only where the handles were drawn near
    if (!m_running && m_hand.owner() == Hand::Owner::released) let_go();
}

/// Where a solve has lost a net with all handles in place, e.g. since lines that they nearly pull straight are no net
/// once they are. The method knows it again, with nothing held straight.
void Editor::take_back_net(SolveReport& report) {
    if (m_run.begun_in_place.cols() == 0 || max_deviation(*m_net, m_positions) < m_options.threshold) return;
    m_positions = std::move(m_run.begun_in_place);
    m_unit_positions = in_unit(m_positions);
    m_unit_last_net = m_unit_positions;
    snap_held();
    m_taut.clear();
    prepare();
    m_method->start(problem(), m_unit_positions, m_options);
    if (report.status == Status::max_iterations || report.status == Status::non_finite) return;  // which say more
    report.status = corner_limit(*m_net, m_options).is_kept(m_positions) ? Status::exact : Status::stalled;
}

bool Editor::has_all_in_place() const {
    return std::all_of(m_handles.begin(), m_handles.end(), [&](const Handle& handle) {
        return !handle.is_exact() || handle.holds_at(m_positions.col(handle.vertex));
    });
}

bool Editor::has_net_in_place() const {
    return has_all_in_place() && max_deviation(*m_net, m_positions) < m_options.threshold;
}

/// Adds what the initialisation does to the trace.
Status Editor::begin_solve(Trace& trace) {
    const Stopwatch watch;
    draw_targets_near();
    find_taut_lines();
    if (!m_prepared) prepare();
    m_pulls = holds().pulls(m_unit, m_unit_net->mean_length(), m_near_targets);
    load_positions();
    // What a hand drags is led from net to net, not to where something else would begin.
    if (m_hand.is_empty() && max_deviation(*m_unit_net, m_unit_positions) >= m_options.threshold) {
        const double prepared_ms = watch.milliseconds();
        for (TraceRow& row : m_initialisation.apply(m_unit_positions)) {
            row.total_ms += prepared_ms;
            trace.push_back(row);
        }
    }
    return m_method->start(problem(), m_unit_positions, m_options);
}

/// Decides where the handles are to be for the solver, which is at their targets unless those are too far.
void Editor::draw_targets_near() {
    const auto count = static_cast<Eigen::Index>(m_handles.size());
    const double farthest = k_farthest_target * m_net->mean_length();
    Eigen::Matrix3Xd targets(3, count), rest(3, count);
    bool is_far = false;
    for (Eigen::Index i = 0; i < count; ++i) {
        rest.col(i) = m_net->rest_positions().col(m_handles[i].vertex);
        targets.col(i) = goal(m_handles[i]);
        // A soft handle only draws, in its direction from however far.
        if (!m_handles[i].is_exact()) targets.col(i) = drawn_near(targets.col(i), rest.col(i), farthest);
        is_far |= m_handles[i].is_exact() && (targets.col(i) - rest.col(i)).cwiseAbs().maxCoeff() > farthest;
    }
    const std::vector<UnreachablePair> pairs = unreachable_pairs();
    m_run.stops_short =
        !pairs.empty() && !m_hand.holds_back() && !m_hand.is_empty() && !m_region && draw_within_reach(targets);
    m_run.reachable = (pairs.empty() || m_run.stops_short) && !is_far;
    if (!m_run.reachable) targets = near_targets(handle_graph(), m_net->mean_length(), targets, rest);
    // What is held back may be pulled anywhere.
    const auto both_held = [now = holds()](const UnreachablePair& pair) {
        const Handle* b = now.handle(pair.vertex_b);
        return now.is_held(*now.handle(pair.vertex_a)) && (b == nullptr || now.is_held(*b));
    };
    if (m_hand.holds_back()) m_run.reachable = std::none_of(pairs.begin(), pairs.end(), both_held);
    m_near_targets = targets / m_unit;
}

/// Takes what is in hand to a place that its distances from other handles allow, a little less far than they do. False
/// if there is none, as far as a few rounds tell.
bool Editor::draw_within_reach(Eigen::Matrix3Xd& targets) const {
    for (int round = 0; round < k_most_drawn; ++round) {
        bool is_within = true;
        for (int vertex : m_hand.vertices())
            for (const auto& [other, distance] : handle_graph().neighbours(m_handle_at[vertex])) {
                auto target = targets.col(m_handle_at[vertex]);
                if ((target - targets.col(other)).stableNorm() <= distance) continue;
                target = drawn_near(target, targets.col(other), k_nearly_taut * distance);
                is_within = false;
            }
        if (is_within) return true;
    }
    return false;
}

/// Of lines that exact handles pull straight, once the net has come near to that. Handles that tear such a line are out
/// of reach. False if that has not changed.
bool Editor::find_taut_lines() {
    std::vector<TautVertex> taut;
    if (m_method->heeds().only_nets && m_run.reachable && !m_region) {
        const Holds now = holds();
        std::vector<int> vertices;
        for (const Handle& handle : m_handles)
            vertices.push_back(handle.is_pinned() && now.axes(handle) == k_no_axes ? handle.vertex : -1);
        std::vector<bool> has_handle(m_handle_at.size());
        for (std::size_t v = 0; v < has_handle.size(); ++v) has_handle[v] = m_handle_at[v] >= 0;
        taut =
            m_taut_lines.find(*m_net, *m_topology, handle_graph(), std::move(vertices), m_unit * m_near_targets,
                              std::move(has_handle), m_positions, m_last_net, k_nearly_straight * m_net->mean_length());
    }
    if (!taut.empty() && m_taut_lines.is_torn()) {
        taut.clear();
        m_run.reachable = false;
    }
    if (taut == m_taut) return false;
    m_taut = std::move(taut);
    m_prepared = false;
    return true;
}

void Editor::prepare() {
    m_fixed = holds().fixed_vertices(m_taut);
    m_slides = holds().slides();
    m_method->prepare(problem());
    m_initialisation.prepare(*m_unit_net, HeldVertices(m_net->vertex_count(), m_fixed, m_slides).vertices());
    m_prepared = true;
}

Problem Editor::problem() const {
    return {.net = *m_unit_net,
            .topology = *m_topology,
            .fixed = m_fixed,
            .pulls = m_pulls,
            .reachable = m_run.reachable,
            .last_net = &m_unit_last_net,
            .guide = m_guide,
            .unit = m_unit,
            .only_nets = !m_hand.is_empty(),
            .slides = m_slides,
            .only_walks = m_run.may_take_in_hand || m_run.limit_gives_way,
            .limit_gives_way = m_run.limit_gives_way};
}

/// The positions of the moment in the solver's unit. Vertices that were far handles once may be anywhere, and are taken
/// as near as the targets of handles are; but for a net that has gone after one.
void Editor::load_positions() {
    const double farthest = k_farthest_target + m_unit_net->rest_positions().lpNorm<Eigen::Infinity>();
    m_unit_last_net = in_unit(m_last_net);
    m_unit_positions = in_unit(m_positions);
    if (max_deviation(*m_unit_net, m_unit_positions) >= m_options.threshold)
        m_unit_positions = m_unit_positions.cwiseMax(-2 * farthest).cwiseMin(2 * farthest);
    const Holds now = holds();
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        const Handle& handle = m_handles[i];
        double* position = m_unit_positions.col(handle.vertex).data();
        if (now.is_held(handle)) {
            copy_along(k_all_axes - handle.slides, m_near_targets.col(static_cast<Eigen::Index>(i)).data(), position);
        } else {
            const Eigen::Vector3d kept = place_across_axes(handle) / m_unit;
            copy_along(k_all_axes - now.axes(handle), kept.data(), position);
        }
    }
    const Eigen::Matrix3Xd places = places_of(m_taut, m_near_targets);
    for (std::size_t i = 0; i < m_taut.size(); ++i)
        m_unit_positions.col(m_taut[i].vertex) = places.col(static_cast<Eigen::Index>(i));
}

/// Where what is held back is across the axes to which its hand keeps it. As far away as a target may be an edge has no
/// digits left.
Eigen::Vector3d Editor::place_across_axes(const Handle& handle) const {
    return drawn_near(handle.target, m_net->rest_positions().col(handle.vertex),
                      k_farthest_target * m_net->mean_length());
}

/// What stands where the solver has left it has the solver's own digits.
Positions Editor::in_unit(const Positions& positions) const {
    Positions x = positions / m_unit;
    for (Eigen::Index i = 0; i < m_unit_positions.size(); ++i)
        if (positions.data()[i] == m_unit * m_unit_positions.data()[i]) x.data()[i] = m_unit_positions.data()[i];
    return x;
}

void Editor::store_positions() {
    const Positions kept = m_region ? Positions(m_positions(Eigen::all, m_region->outside)) : Positions();
    m_positions = m_unit * m_unit_positions;
    if (m_region) m_positions(Eigen::all, m_region->outside) = kept;
    snap_held();
}

/// After a solve. What is in hand may still be on its way; where it has arrived it takes its target's own digits.
void Editor::snap_held() {
    const Holds now = holds();
    for (Handle& handle : m_handles) {
        if (!handle.is_exact()) continue;
        const int vertex = handle.vertex;
        const Axes axes = now.is_held(handle) ? handle.slides : now.axes(handle);
        const bool has_arrived =
            !m_hand.holds(vertex) || across(axes, m_unit_positions.col(vertex)) == across(axes, handle.target / m_unit);
        handle.follow(m_positions.col(vertex));
        if (has_arrived) copy_along(k_all_axes - axes, handle.target.data(), m_positions.col(vertex).data());
    }
}

}  // namespace chebnet
