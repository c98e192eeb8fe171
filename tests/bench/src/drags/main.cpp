// How a drag feels and whether it ends where it should; see `drags` in the folder above.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "../edit_case.h"
#include "../numbers.h"
#include "base/stopwatch.h"
#include "edit/editor.h"
#include "net/measures.h"

namespace {

using namespace chebnet;
using namespace chebnet::bench;

struct Arguments {
    std::vector<std::string> methods{"li2022", "projection", "local_global", "equilibrium"};
    std::vector<std::string> recipes{"vault:vertices=2000", "dome:vertices=2000", "tube:vertices=2000"};
    std::string nets, edits;
    std::vector<std::string> only;
    int frames = 60;
    bool plans = false;
};

/// What is written of one edit by one method. Lengths in edge lengths, angles in degrees.
struct Row {
    std::vector<double> frame_ms;  // of the way out and of the way back
    std::vector<double> kicks;     // largest move of a vertex in a frame over the hand's
    double frame_deviation = 0, frame_angle = 180;
    double deviation = 0, angle = 180;  // where the slow drag has settled, out
    double bend = 0;                    // likewise
    double way_back = 0;                // RMS distance from where it began
    double path = 0;                    // RMS distance between slow drag and jump
    double rest_ms = 0, jump_ms = 0;    // from the last frame to rest; the jump as a whole
    double cold_ms = 0;                 // the jump of a net for which nothing has been prepared
    int rest_iterations = 0;
    Status status = Status::running;  // of the slow drag, out
};

class Drag {
public:
    Drag(const Edit& problem, const std::string& method) : m_problem(problem), m_editor(problem.net) {
        m_editor.set_method(method);
        m_editor.set_handles(problem.handles);
        m_editor.reset();
        settle();
    }

    /// Solves until it ends.
    SolveReport settle() { return m_editor.solve(); }

    /// Moves the handles to a part of their way, for one frame: until the net has its lengths, or the solve ends.
    SolveReport frame(double part) {
        for (const auto& [vertex, target, weight, slides] : m_problem.handles) {
            const Eigen::Vector3d rest = m_problem.net.rest_positions().col(vertex);
            m_editor.move_handle(vertex, rest + part * (target - rest));
        }
        SolveReport report = m_editor.solve({.iterations = 1});
        while (report.status == Status::running && !(report.max_deviation < m_editor.options().threshold))
            report = m_editor.solve({.iterations = 1});
        return report;
    }

    const Positions& positions() const { return m_editor.positions(); }
    double angle() const { return corner_angle_range(m_editor.net(), positions()).smallest * 180 / std::numbers::pi; }
    double bend() const { return chebnet::bend(m_editor.net(), m_editor.topology(), positions()); }
    double rms_from(const Positions& other) const {
        return std::sqrt((positions() - other).squaredNorm() / static_cast<double>(other.cols())) /
               m_editor.net().mean_length();
    }
    /// The farthest that a handle goes, in all frames together.
    double hand() const {
        double farthest = 0;
        for (const Handle& handle : m_problem.handles)
            farthest = std::max(farthest, (handle.target - m_problem.net.rest_positions().col(handle.vertex)).norm());
        return farthest;
    }

private:
    const Edit& m_problem;
    Editor m_editor;
};

/// All handles at once at their targets.
double cold_ms(const Edit& problem, const std::string& method) {
    Editor editor(problem.net);
    editor.set_method(method);
    const Stopwatch watch;
    editor.set_handles(problem.handles);
    editor.solve();
    return watch.milliseconds();
}

void drag_to(double from, double to, int frames, Drag& drag, Row& row) {
    for (int k = 1; k <= frames; ++k) {
        const Positions before = drag.positions();
        const Stopwatch watch;
        const SolveReport report = drag.frame(from + (to - from) * k / frames);
        row.frame_ms.push_back(watch.milliseconds());
        const double moved = (drag.positions() - before).colwise().norm().maxCoeff();
        row.kicks.push_back(moved / (drag.hand() * std::abs(to - from) / frames));
        row.frame_deviation = std::max(row.frame_deviation, report.max_deviation);
        row.frame_angle = std::min(row.frame_angle, drag.angle());
    }
}

Row measure(const Edit& problem, const std::string& method, int frames) {
    Row row;
    row.cold_ms = cold_ms(problem, method);
    Drag slow(problem, method);
    const Positions start = slow.positions();
    drag_to(0, 1, frames, slow, row);
    const Stopwatch watch;
    const SolveReport report = slow.settle();
    row.rest_ms = watch.milliseconds();
    row.rest_iterations = report.iterations;
    row.status = report.status;
    row.deviation = report.max_deviation;
    row.angle = slow.angle();
    row.bend = slow.bend();

    Drag jump(problem, method);
    const Stopwatch jump_watch;
    jump.frame(1);
    jump.settle();
    row.jump_ms = jump_watch.milliseconds();
    row.path = slow.rms_from(jump.positions());

    drag_to(1, 0, frames, slow, row);
    slow.settle();
    row.way_back = slow.rms_from(start);
    return row;
}

void print_head() {
    std::puts(
        "| edit | method | V | frame ms: median, 95 %, largest | dL in a frame, settled | angle in a frame, settled "
        "| kick 95 % | return | path | bend | to rest: iterations, ms | jump ms | cold ms | |");
    std::puts("|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
}

void print(const std::string& edit, const std::string& method, int vertices, const Row& row) {
    std::printf(
        "| %s | %s | %d | %.1f, %.1f, %.1f | %.0e, %.0e | %.2f, %.2f | %.2f | %.4f | %.4f | %.4f | %d, %.0f | "
        "%.0f | %.0f | %s |\n",
        edit.c_str(), method.c_str(), vertices, median(row.frame_ms), quantile(row.frame_ms, 0.95),
        quantile(row.frame_ms, 1), row.frame_deviation, row.deviation, row.frame_angle, row.angle,
        quantile(row.kicks, 0.95), row.way_back, row.path, row.bend, row.rest_iterations, row.rest_ms, row.jump_ms,
        row.cold_ms, to_string(row.status));
    std::fflush(stdout);
}

std::vector<EditCase> wanted_cases(const Arguments& arguments) {
    std::vector<EditCase> cases;
    if (!arguments.nets.empty()) {
        cases = cases_of_folder(arguments.nets, arguments.edits);
    } else {
        for (const std::string& recipe : arguments.recipes)
            for (const std::string& kind : edit_kinds()) cases.push_back({recipe, kind, ""});
    }
    std::erase_if(cases, [&](const EditCase& edit) {
        return !arguments.only.empty() && std::ranges::none_of(arguments.only, [&](const std::string& text) {
            return edit.name().find(text) != std::string::npos;
        });
    });
    return cases;
}

void measure_all(const Arguments& arguments) {
    print_head();
    for (const EditCase& edit : wanted_cases(arguments)) {
        const Edit problem = make_problem(edit);
        for (const std::string& method : arguments.methods)
            print(edit.name(), method, problem.net.vertex_count(), measure(problem, method, arguments.frames));
    }
}

/// What `drags_in_node.mjs` measures.
void print_plan(const Arguments& arguments) {
    using Json = nlohmann::json;
    Json tasks = Json::array();
    for (const EditCase& edit : wanted_cases(arguments)) {
        Json handles = Json::array();
        for (const Handle& handle : make_problem(edit).handles)
            handles.push_back(
                {{"vertex", handle.vertex}, {"target", {handle.target.x(), handle.target.y(), handle.target.z()}}});
        tasks.push_back({{"edit", edit.name()}, {"net", edit.net}, {"handles", handles}});
    }
    std::puts(Json{{"methods", arguments.methods}, {"frames", arguments.frames}, {"tasks", tasks}}.dump().c_str());
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App program("Drags handles out and back, slowly and at once, and prints how that went as a table.", "drags");
    Arguments arguments;
    program.add_option("--methods", arguments.methods, "Methods")->delimiter(',')->capture_default_str();
    program.add_option("--recipes", arguments.recipes, "Shapes to drag, four edits each")->capture_default_str();
    program.add_option("--nets", arguments.nets, "OBJ files of this folder in place of shapes")->type_name("DIR");
    program.add_option("--edits", arguments.edits, "Edits of these, NET.KIND.json; generated where there is none")
        ->type_name("DIR");
    program.add_option("--only", arguments.only, "Only what has this in its name; may be repeated")->type_name("TEXT");
    program.add_option("--frames", arguments.frames, "Frames of the slow drag, each way")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    program.add_flag("--plan", arguments.plans, "Print what would be measured, for the same in WebAssembly");
    CLI11_PARSE(program, argc, argv);
    try {
        arguments.plans ? print_plan(arguments) : measure_all(arguments);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "drags: %s\n", error.what());
        return 2;
    }
    return 0;
}
