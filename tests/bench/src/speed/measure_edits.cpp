#include <algorithm>
#include <limits>
#include <numbers>

#include "base/stopwatch.h"
#include "measure.h"
#include "net/measures.h"
#include "open_net.h"

namespace chebnet::bench {
namespace {

/// JSON has no infinity.
double finite(double value) { return std::min(value, std::numeric_limits<double>::max()); }

double smallest_angle(const Editor& editor) {
    return corner_angle_range(editor.net(), editor.positions()).smallest * 180 / std::numbers::pi;
}

EditResult describe(const Task& task, const Editor& editor, const SolveReport& report) {
    return {task.edit,
            editor.method(),
            editor.net().vertex_count(),
            to_string(report.status),
            report.iterations,
            finite(report.max_deviation),
            bend(editor.net(), editor.topology(), editor.positions()),
            smallest_angle(editor),
            fell_back(report),
            {}};
}

Editor at_rest(const Task& task, const std::string& method) {
    Editor editor(open_net(task.net));
    editor.set_method(method);
    editor.set_handles(task.handles);
    editor.reset();
    return editor;
}

void move_handles(const Task& task, double part, Editor& editor) {
    for (const Handle& handle : task.handles) {
        const Eigen::Vector3d rest = editor.net().rest_positions().col(handle.vertex);
        editor.move_handle(handle.vertex, rest + part * (handle.target - rest));
    }
}

void add_frame(Editor& editor, DragResult& result) {
    const Stopwatch watch;
    const SolveReport report = editor.solve();
    result.ms.push_back(watch.milliseconds());
    result.unsolved_frames += report.status != Status::converged;
    result.fallback_frames += fell_back(report);
    result.max_dL = std::max(result.max_dL, finite(report.max_deviation));
}

}  // namespace

bool fell_back(const SolveReport& report) {
    constexpr int fallback_stage = 4;  // see k_projection.make()
    return std::ranges::any_of(report.trace, [](const TraceRow& row) { return row.stage == fallback_stage; });
}

std::vector<EditResult> measure_edit(const Task& task, const Plan& plan) {
    Editor editor(open_net(task.net));
    std::vector<EditResult> results;
    for (int repeat = 0; repeat < plan.repeats; ++repeat)
        for (std::size_t i = 0; i < plan.methods.size(); ++i) {
            editor.reset();
            editor.set_method(plan.methods[i]);  // a new one, for which nothing is prepared
            editor.set_handles(task.handles);
            const Stopwatch watch;
            const SolveReport report = editor.solve();
            const double ms = watch.milliseconds();
            if (repeat == 0) results.push_back(describe(task, editor, report));
            results[i].ms.push_back(ms);
        }
    return results;
}

std::vector<DragResult> measure_drag(const Task& task, const Plan& plan) {
    std::vector<Editor> editors;
    std::vector<DragResult> results;
    for (const std::string& method : plan.methods) {
        editors.push_back(at_rest(task, method));
        results.push_back({task.edit, method, editors.back().net().vertex_count(), 0, 0, 0, 0, {}});
    }
    for (int frame = 1; frame <= plan.frames; ++frame)
        for (std::size_t i = 0; i < editors.size(); ++i) {
            move_handles(task, static_cast<double>(frame) / plan.frames, editors[i]);
            add_frame(editors[i], results[i]);
        }
    for (std::size_t i = 0; i < editors.size(); ++i)
        results[i].bend = bend(editors[i].net(), editors[i].topology(), editors[i].positions());
    return results;
}

}  // namespace chebnet::bench
