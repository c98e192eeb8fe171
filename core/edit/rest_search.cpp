#include "edit/rest_search.h"

#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "edit/net_forces.h"
#include "net/measures.h"

namespace chebnet {

namespace {

// Another net has less energy than this part, and by more than that: the same net differs by what is left of it to come
// to rest, and one that lies as its rest shape does has next to none.
constexpr double k_less = 0.999, k_no_energy = 1e-6;

}  // namespace

/// A way to another net, in steps.
struct RestSearch::Way {
    int parts;              // of the way of all handles from the rest shape; 0: it begins at the best net so far,
    double stiffness = 1;   // in whose first step lines bend so many times less,
    bool has_limit = true;  // and corners may be as sharp as they like

    int steps() const { return parts > 0 ? parts : is_detour() ? 2 : 1; }
    bool is_detour() const { return stiffness != 1 || !has_limit; }
};

// The first is the net as it stands, in case that has not come to rest yet.
constexpr RestSearch::Way RestSearch::k_ways[] = {{0}, {1}, {12}, {0, 8}, {0, 1, false}};

RestSearch::RestSearch(const Editor& editor) : m_editor(editor.original()), m_asked(editor.state()), m_best(m_asked) {
    if (m_asked.method != k_default_method)
        throw Error(ErrorCode::bad_option,
                    "method " + m_asked.method + " brings no net to rest; " + std::string(k_default_method) + " does");
    begin_step();
}

RestSearchReport RestSearch::solve(const Budget& budget) {
    const Stopwatch watch;
    const int before = m_report.iterations;
    while (m_report.status == Status::running && m_report.iterations - before < budget.iterations &&
           (m_report.iterations == before || watch.milliseconds() < budget.milliseconds))
        iterate();
    m_report.milliseconds += watch.milliseconds();
    return m_report;
}

void RestSearch::iterate() {
    const SolveReport report = m_editor.solve({.iterations = 1});
    ++m_report.iterations;
    const Way& way = k_ways[m_way];
    const bool is_last = m_step + 1 == way.steps();
    // On their way handles need not wait for rest.
    const bool is_passed = way.parts > 0 && !is_last && report.max_deviation < m_asked.options.threshold;
    if (report.status == Status::running && !is_passed) return;
    if (is_last) return end_way(report.status);
    ++m_step;
    begin_step();
}

void RestSearch::begin_step() {
    const Way& way = k_ways[m_way];
    const double steps = way.steps(), ways = static_cast<double>(std::size(k_ways));
    m_report.done = (static_cast<double>(m_way) + m_step / steps) / ways;
    EditState state = m_step == 0 ? m_best : m_editor.state();
    state.options = m_asked.options;
    if (way.parts > 0) {
        if (m_step == 0) state.positions = m_editor.net().rest_positions();
        move_handles((m_step + 1) / steps, state);
    } else if (m_step == 0) {
        state.options.bending_weight *= way.stiffness;
        if (!way.has_limit) state.options.shear_limit = 0;
    }
    m_editor.set_state(std::move(state));
}

/// To this part of their way from where the rest shape has them.
void RestSearch::move_handles(double part, EditState& state) const {
    for (std::size_t i = 0; i < state.handles.size(); ++i) {
        const Eigen::Vector3d rest = m_editor.net().rest_positions().col(state.handles[i].vertex);
        const Eigen::Vector3d& target = m_asked.handles[i].target;
        state.handles[i].target = part < 1 ? Eigen::Vector3d(rest + part * (target - rest)) : target;
    }
}

void RestSearch::end_way(Status status) {
    const double found = keeps_lengths(status) ? energy() : std::numeric_limits<double>::infinity();
    const bool is_better = found < k_less * m_report.energy - k_no_energy;
    if (m_way == 0) m_report.energy_before = found;
    if (m_way == 0 || is_better) {
        m_best = m_editor.state();
        m_report.energy = found;
    }
    m_step = 0;
    const bool has_locality = m_asked.locality.has_value();
    do {
        ++m_way;  // what a locality holds stays where it stands
    } while (m_way < std::size(k_ways) && has_locality && k_ways[m_way].parts > 0);
    if (m_way < std::size(k_ways)) return begin_step();
    m_report.done = 1;
    m_report.status = m_report.energy < m_report.energy_before ? Status::converged : Status::unreachable;
}

/// Of the net that the editor has come to; infinite if that is none.
double RestSearch::energy() const {
    const std::optional<NetForces> forces = net_forces(m_editor);
    if (!forces || !(max_deviation(m_editor.net(), m_editor.positions()) < m_asked.options.threshold))
        return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (const TermEnergy& term : forces->energies) sum += term.energy;
    return sum;
}

EditState RestSearch::state() const {
    if (m_report.status != Status::converged)
        throw Error(ErrorCode::bad_option, "no net with less energy has been found");
    return m_best;
}

}  // namespace chebnet
