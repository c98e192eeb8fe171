#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "edit/editor.h"

/// What must hold of an Editor whatever is asked of it, judged from outside: from positions, handles and rest lengths
/// alone, with none of the core's own measures. Each function returns a sentence for every invariant that is violated.
namespace chebnet::invariants {

using Violations = std::vector<std::string>;

/// The largest dL over all edges in extended precision; infinity if an edge has no length or is not finite.
inline double reckoned_deviation(const Net& net, const Positions& positions) {
    long double largest = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        const auto ends = net.edges().col(e);
        const auto along = [&](int axis) {
            return static_cast<long double>(positions(axis, ends[0])) - positions(axis, ends[1]);
        };
        const long double length = std::hypot(std::hypot(along(0), along(1)), along(2));
        const long double ratio = length / net.rest_lengths()[e];
        const long double dL = (ratio - 1) * (ratio - 1) / ratio;
        if (!std::isfinite(dL)) return std::numeric_limits<double>::infinity();
        largest = std::max(largest, dL);
    }
    return static_cast<double>(largest);
}

/// Of the state: positions are finite, exact handles stand exactly at their targets, those in hand where the net is,
/// and those that a solve draws on their way.
inline Violations of_state(const Editor& editor) {
    Violations violations;
    const Positions& positions = editor.positions();
    for (int v = 0; v < positions.cols(); ++v)
        if (!positions.col(v).allFinite()) {
            violations.push_back("vertex " + std::to_string(v) + " is not finite");
            break;
        }
    for (const Handle& handle : editor.standing_handles())
        if (handle.is_exact() && !editor.draws_handles() && positions.col(handle.vertex) != handle.target)
            violations.push_back("handle " + std::to_string(handle.vertex) + " is not at its target");
    if (editor.handle_error() != 0) violations.push_back("the editor itself finds handles off their targets");
    return violations;
}

/// Whether every edge has its length at such positions, and every handle is where it holds its vertex.
inline bool is_solved(const Editor& editor, const Positions& positions) {
    const auto is_held = [&](const Handle& handle) {
        return !handle.is_exact() || handle.holds_at(positions.col(handle.vertex));
    };
    return std::ranges::all_of(editor.handles(), is_held) &&
           reckoned_deviation(editor.net(), positions) < editor.options().threshold;
}

/// Whether what pulls, soft handles or a locality that would have the net elsewhere, may draw it out of its lengths for
/// a while: `projection` gives way to them and comes back. `equilibrium` goes from net to net.
inline bool may_leave_lengths(const Editor& editor, const Positions& before) {
    if (editor.method() == "equilibrium") return false;
    const auto is_elsewhere = [&](const Pull& pull) { return pull.target != before.col(pull.vertex); };
    if (editor.region() && std::ranges::any_of(editor.region()->pulls, is_elsewhere)) return true;
    return std::ranges::any_of(editor.handles(), [](const Handle& handle) { return !handle.is_exact(); });
}

/// Of what one call of solve() did with `budget` from the positions `before`, beyond the invariants of the state.
inline Violations of_solve(const Editor& editor, const SolveReport& report, const Budget& budget,
                           const Positions& before) {
    Violations violations = of_state(editor);
    const double reckoned = reckoned_deviation(editor.net(), editor.positions());
    const auto require = [&](bool holds, const char* otherwise) {
        if (holds) return;
        char numbers[80];
        std::snprintf(numbers, sizeof numbers, " (dL %.3g, reported %.3g)", reckoned, report.max_deviation);
        violations.push_back(std::string(otherwise) + numbers);
    };
    // An edge so far off that the square of its length is no number may be reported as infinitely so.
    const auto is_lost = [](double dL) { return dL > 1e100; };
    // Lengths in double precision are known to some 1e-16 of themselves, so that a dL above 1e-30 keeps three digits
    // down to 1e-24, the smallest threshold.
    const auto at_most = [](double a, double b) { return a <= b || a - b <= 1e-3 * b + 1e-27; };
    const double threshold = editor.options().threshold;
    require(!keeps_lengths(report.status) || at_most(reckoned, threshold),
            "a solve that says that every edge has its length leaves one without");
    require(at_most(reckoned, threshold) || !is_solved(editor, before) || may_leave_lengths(editor, before),
            "edges have lost their lengths though no handle was moved");
    require((at_most(reckoned, report.max_deviation) && at_most(report.max_deviation, reckoned)) ||
                (is_lost(reckoned) && is_lost(report.max_deviation)),
            "the largest dL reported is not that of the positions");

    require(report.iterations <= std::max(1, budget.iterations), "more iterations were made than the budget allows");
    require(report.iterations <= editor.options().max_iterations, "more iterations were made than a solve may have");
    // Rows of an initialisation have numbers up to 0.
    const auto rows = std::ranges::count_if(report.trace, [](const TraceRow& row) { return row.iteration > 0; });
    require(rows == report.iterations, "the trace misses iterations");
    require(report.status != Status::running || report.iterations >= budget.iterations ||
                report.milliseconds >= budget.milliseconds,
            "the solve was interrupted within its budget");

    if (editor.region())
        require(std::all_of(editor.region()->outside.begin(), editor.region()->outside.end(),
                            [&](int v) { return editor.positions().col(v) == before.col(v); }),
                "a vertex moved outside the region that may move");
    return violations;
}

/// All that an editor shows of its state, to find out whether a call that was refused has changed any of it.
struct Snapshot {
    Positions positions;
    std::vector<Handle> handles;
    std::vector<double> options;
    std::string method, initialisation;
    std::vector<int> fixed;  ///< the vertices outside the region that may move

    explicit Snapshot(const Editor& editor)
        : positions(editor.positions()),
          handles(editor.standing_handles()),
          method(editor.method()),
          initialisation(editor.initialisation()) {
        for (const OptionInfo& info : option_table()) options.push_back(get_option(editor.options(), info.name));
        if (editor.region()) fixed = editor.region()->outside;
    }
};

inline Violations of_refused_call(const Snapshot& before, const Snapshot& after) {
    Violations violations;
    const auto require_same = [&violations](bool same, const char* what) {
        if (!same) violations.push_back("a call that was refused has changed the " + std::string(what));
    };
    const auto same_handle = [](const Handle& a, const Handle& b) {
        return a.vertex == b.vertex && a.target == b.target && a.weight == b.weight && a.slides == b.slides;
    };
    require_same(before.positions == after.positions, "positions");
    require_same(std::equal(before.handles.begin(), before.handles.end(), after.handles.begin(), after.handles.end(),
                            same_handle),
                 "handles");
    require_same(before.options == after.options, "options");
    require_same(before.method == after.method, "method");
    require_same(before.initialisation == after.initialisation, "initialisation");
    require_same(before.fixed == after.fixed, "region");
    return violations;
}

}  // namespace chebnet::invariants
