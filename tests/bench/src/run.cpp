#include "run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "net/measures.h"
#include "net/topology.h"
#include "remesh/remesh.h"

namespace chebnet::bench {
namespace {

double longer_share(const Editor& editor) {
    return (edge_ratios(editor.net(), editor.positions()).array() > 1).cast<double>().mean();
}

void add_iteration(const SolveReport& report, const Editor& editor, const Positions& before, Run& result) {
    for (const TraceRow& row : report.trace) {
        const int last_stage = result.samples.empty() ? 0 : result.samples.back().row.stage;
        if (last_stage > 0 && row.stage != last_stage) result.snapshots.push_back({last_stage, before});
        const bool is_start = row.stage == 0;
        result.samples.push_back({row, is_start ? std::numeric_limits<double>::quiet_NaN() : longer_share(editor)});
    }
}

/// One iteration at a time, so that the net can be looked at in between; that time does not count.
void solve(Editor& editor, Run& result) {
    do {
        const Positions before = editor.positions();
        const SolveReport report = editor.solve({.iterations = 1});
        result.status = report.status;
        result.max_deviation = report.max_deviation;
        result.iterations += report.iterations;
        add_iteration(report, editor, before, result);
        result.milliseconds = result.samples.empty() ? report.milliseconds : result.samples.back().row.total_ms;
    } while (result.status == Status::running);
}

void add_frame(const Editor& editor, const SolveReport& report, int frame, Run& result) {
    TraceRow row = report.trace.empty() ? TraceRow{} : report.trace.back();
    row.iteration = frame;
    row.max_deviation = report.max_deviation;
    row.total_ms = report.milliseconds;
    result.samples.push_back({row, longer_share(editor)});
    result.iterations += report.iterations;
    result.milliseconds += report.milliseconds;
    result.max_deviation = std::max(result.max_deviation, report.max_deviation);
    if (report.status != Status::converged) result.status = report.status;
}

void drag(Editor& editor, int frames, Run& result) {
    const std::vector<Handle> goal = editor.handles();
    result.status = Status::converged;
    editor.reset();
    for (int frame = 1; frame <= frames; ++frame) {
        for (const Handle& handle : goal) {
            const Eigen::Vector3d rest = editor.net().rest_positions().col(handle.vertex);
            editor.move_handle(handle.vertex, rest + (handle.target - rest) * frame / frames);
        }
        add_frame(editor, editor.solve(), frame, result);
    }
}

Run run_once(const NamedEdit& edit, const std::shared_ptr<const Edit>& problem, const Variant& variant) {
    Editor editor(problem->net);
    editor.set_method(variant.method);
    editor.set_initialisation(variant.initialisation);
    for (const auto& [key, value] : variant.options) editor.set_option(key, value);
    editor.set_handles(problem->handles);

    Run result;
    result.edit = edit.name;
    result.variant = &variant;
    result.problem = problem;
    if (variant.frames > 0)
        drag(editor, variant.frames, result);
    else
        solve(editor, result);
    result.positions = editor.positions();
    result.bend = bend(editor.net(), editor.topology(), editor.positions());
    result.smallest_angle = corner_angle_range(editor.net(), editor.positions()).smallest;
    result.handle_error = editor.handle_error();
    return result;
}

}  // namespace

namespace {

std::shared_ptr<const Guide> surface_of(const Run& run) {
    return std::make_shared<const Guide>(Surface({run.positions, run.problem->net.faces()}));
}

std::shared_ptr<const NewNet> remeshed(const Run& run) {
    const Stopwatch watch;
    try {
        Net net = remesh(surface_of(run), {.length = run.problem->net.mean_length()}).net;
        return std::make_shared<const NewNet>(NewNet{std::move(net), watch.milliseconds()});
    } catch (const Error&) {
        return nullptr;
    }
}

}  // namespace

Run run(const NamedEdit& edit, const Variant& variant, int repeats) {
    const auto problem = std::make_shared<const Edit>(edit.open());
    Run fastest = run_once(edit, problem, variant);
    for (int i = 1; i < repeats; ++i) {
        Run again = run_once(edit, problem, variant);
        if (again.milliseconds < fastest.milliseconds) fastest = std::move(again);
    }
    if (variant.remeshes) fastest.new_net = remeshed(fastest);
    return fastest;
}

double distance(const Run& a, const Run& b) {
    return std::sqrt((a.positions - b.positions).squaredNorm() / a.vertices()) / a.problem->net.mean_length();
}

double mean_distance(const Net& net, const Positions& positions, const Run& surface) {
    return distance_to(*surface_of(surface), net, positions).mean / surface.problem->net.mean_length();
}

int singular_vertices(const Net& net) {
    int count = 0;
    for (const auto& [valence, vertices] : Topology(net).singular_vertices()) count += vertices;
    return count;
}

int edges_at_rest_since(const Run& run, const Snapshot& snapshot) {
    int count = 0;
    const auto is_at_rest = [&](int v) { return run.positions.col(v) == snapshot.positions.col(v); };
    for (int e = 0; e < run.problem->net.edge_count(); ++e)
        count += is_at_rest(run.problem->net.edges()(0, e)) && is_at_rest(run.problem->net.edges()(1, e));
    return count;
}

}  // namespace chebnet::bench
