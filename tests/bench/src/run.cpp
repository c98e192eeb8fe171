#include "run.h"

#include <algorithm>
#include <utility>

#include "net/measures.h"

namespace chebnet::bench {
namespace {

double longer_share(const Editor& editor) {
    return (edge_ratios(editor.net(), editor.positions()).array() > 1).cast<double>().mean();
}

/// One iteration at a time, so that the net can be looked at in between; that time does not count.
void solve(Editor& editor, Run& result) {
    do {
        const SolveReport report = editor.solve({.iterations = 1});
        result.status = report.status;
        result.max_deviation = report.max_deviation;
        result.iterations += report.iterations;
        for (const TraceRow& row : report.trace) result.samples.push_back({row, longer_share(editor)});
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

void drag(Editor& editor, const Variant& variant, Run& result) {
    const std::vector<Handle> goal = editor.handles();
    result.status = Status::converged;
    editor.reset();
    for (int frame = 1; frame <= variant.frames; ++frame) {
        if (variant.frame_start == FrameStart::rest) editor.reset();
        for (const Handle& handle : goal) {
            const Eigen::Vector3d rest = editor.net().rest_positions().col(handle.vertex);
            editor.move_handle(handle.vertex, rest + (handle.target - rest) * frame / variant.frames);
        }
        add_frame(editor, editor.solve(), frame, result);
    }
}

Run run_once(const EditCase& edit, const Variant& variant) {
    Problem problem = make_problem(edit, variant.change);
    Editor editor(std::move(problem.net));
    editor.set_method(variant.method);
    editor.set_initialisation(variant.initialisation);
    for (const auto& [key, value] : variant.options) editor.set_option(key, value);
    editor.set_handles(problem.handles);

    Run result;
    result.edit = edit.name();
    result.variant = variant.label;
    result.vertices = editor.net().vertex_count();
    result.handles = static_cast<int>(problem.handles.size());
    if (variant.frames > 0)
        drag(editor, variant, result);
    else
        solve(editor, result);
    result.bend = bend(editor.net(), editor.topology(), editor.positions());
    result.handle_error = editor.handle_error();
    return result;
}

}  // namespace

Run run(const EditCase& edit, const Variant& variant, int repeats) {
    Run fastest = run_once(edit, variant);
    for (int i = 1; i < repeats; ++i) {
        Run again = run_once(edit, variant);
        if (again.milliseconds < fastest.milliseconds) fastest = std::move(again);
    }
    return fastest;
}

}  // namespace chebnet::bench
