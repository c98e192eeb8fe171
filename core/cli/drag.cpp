#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>

#include "base/number.h"
#include "command.h"
#include "not_reached.h"
#include "report.h"
#include "solver_arguments.h"

namespace chebnet {
namespace {

// A handle that is as near to its target, in edge lengths, has come there but for rounding.
constexpr double k_arrived = 1e-9;

struct DragArguments {
    SolverArguments solver;
    int frames = 0;
};

/// The point at fraction t of the way: exactly the ends at t = 0 and t = 1, and exactly at rest if both are equal.
Eigen::Vector3d between(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double t) {
    return from.binaryExpr(to, [t](double a, double b) { return std::lerp(a, b, t); });
}

std::vector<Handle> at_rest(std::vector<Handle> handles, const Net& net) {
    for (Handle& handle : handles) handle.target = net.rest_positions().col(handle.vertex);
    return handles;
}

/// What a drag came to.
struct Dragged {
    std::vector<SolveReport> frames;
    double handle_error = 0;   // of exact handles, from their targets in the file
    bool falls_short = false;  // of where the hand went

    /// On its way: nobody knows whether the net goes farther.
    bool is_stopped() const { return falls_short && frames.back().status == Status::max_iterations; }
    /// The net does not go farther.
    bool is_held_back() const { return falls_short && !is_stopped(); }
};

/// The farthest of exact handles from where they are to be.
double farthest_from(const std::vector<Handle>& goal, const Positions& positions) {
    double farthest = 0;
    for (const Handle& handle : goal)
        if (handle.is_exact())
            farthest = std::max(farthest, across(handle.slides, handle.target - positions.col(handle.vertex)).norm());
    return farthest;
}

/// To fraction t of the way. Those that do not move at all are not touched, which would end the drag of those in hand.
void carry_handles(Editor& editor, const std::vector<Handle>& goal, double t, bool in_hand) {
    for (const Handle& handle : goal) {
        const Eigen::Vector3d from = editor.net().rest_positions().col(handle.vertex);
        if (handle.target == from) continue;
        const Eigen::Vector3d target = between(from, handle.target, t);
        if (in_hand)
            editor.drag_handle(handle.vertex, target);
        else
            editor.move_handle(handle.vertex, target);
    }
}

/// One solve for each frame. The handles stand at rest before the first, as when a user takes hold of one; after the
/// last they are let go of. Where edges may grow nothing is held back: they grow as far as the handles go.
Dragged drag(Editor& editor, const std::vector<Handle>& goal, int frame_count, bool in_hand) {
    editor.set_handles(at_rest(goal, editor.net()));
    Dragged dragged;
    for (int frame = 1; frame <= frame_count; ++frame) {
        carry_handles(editor, goal, static_cast<double>(frame) / frame_count, in_hand);
        if (frame == frame_count) editor.release_handles();
        dragged.frames.push_back(editor.solve());
    }
    dragged.handle_error = farthest_from(goal, editor.positions());
    dragged.falls_short = in_hand && dragged.handle_error > k_arrived * editor.net().mean_length();
    return dragged;
}

/// The traces of all frames as one table, with the frame as its first column.
std::string to_csv(const std::vector<SolveReport>& frames) {
    std::string csv;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::istringstream lines(chebnet::to_csv(frames[i].trace));
        std::string line;
        std::getline(lines, line);
        if (i == 0) csv += "frame," + line + '\n';
        while (std::getline(lines, line)) csv += std::to_string(i + 1) + ',' + line + '\n';
    }
    return csv;
}

std::vector<double> sorted_milliseconds(const std::vector<SolveReport>& frames) {
    std::vector<double> times;
    times.reserve(frames.size());
    for (const SolveReport& frame : frames) times.push_back(frame.milliseconds);
    std::ranges::sort(times);
    return times;
}

/// With linear interpolation between neighbours.
double quantile(const std::vector<double>& sorted, double q) {
    const double place = q * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

Json frame_list(const std::vector<SolveReport>& frames) {
    Json list = Json::array();
    for (const SolveReport& frame : frames)
        list.push_back({{"frame", list.size() + 1},
                        {"status", to_string(frame.status)},
                        {"iterations", frame.iterations},
                        {"max_dL", frame.max_deviation},
                        {"to_rest", to_rest_report(frame.to_rest)},
                        {"milliseconds", frame.milliseconds}});
    return list;
}

Json drag_report(const DragArguments& arguments, const Editor& editor, const AdaptedSolve& adapted,
                 const Dragged& dragged) {
    const std::vector<SolveReport>& frames = dragged.frames;
    const auto times = sorted_milliseconds(frames);
    Json report{{"net", arguments.solver.net.name},
                {"method", editor.method()},
                {"status", to_string(adapted.solve.status)},
                {"is_held_back", dragged.is_held_back()},
                {"to_rest", to_rest_report(adapted.solve.to_rest)},
                {"median_milliseconds", quantile(times, 0.5)},
                {"percentile_95_milliseconds", quantile(times, 0.95)}};
    if (adapted.rest_search) report["search_for_rest"] = rest_search_report(*adapted.rest_search);
    report.update(shape_report(editor));
    // Handles that fell short have been let go of where they stood.
    report["max_handle_error"] = dragged.handle_error;
    report.update(forces_report(editor));
    report["frames"] = frame_list(frames);
    return report;
}

/// Why it ends with 1 though its last frame is a net, if it does.
std::string shortcoming(const Editor& editor, const Dragged& dragged, bool adapts_lengths) {
    if (dragged.is_stopped())
        return "every edge has its length, but the iteration limit, " +
               std::to_string(editor.options().max_iterations) + ", stopped handles on their way, up to " +
               number_text(dragged.handle_error, 4) +
               " from their targets; a larger --max-iterations or more --frames often leads there";
    if (dragged.is_held_back())
        return "every edge has its length, but the net goes no farther: handles were held back up to " +
               number_text(dragged.handle_error, 4) +
               " from their targets; --adapt-lengths, which lets edges grow, or a smaller --shear-limit may do";
    // A frame on the way need not have come to rest.
    const auto is_net = [&](const SolveReport& frame) { return frame.max_deviation < editor.options().threshold; };
    const auto others = std::ranges::count_if(dragged.frames, std::not_fn(is_net));
    if (adapts_lengths || others == 0) return "";
    return "every edge has its length at the end, but not in " + std::to_string(others) + " of the " +
           std::to_string(dragged.frames.size()) + " frames; more --frames or a larger --max-iterations may do";
}

int run_drag(const DragArguments& arguments) {
    Editor editor = open_editor(arguments.solver);
    const auto goal = open_edit(arguments.solver, editor);
    const Dragged dragged = drag(editor, goal, arguments.frames, !arguments.solver.adapts_lengths);
    const AdaptedSolve adapted = with_rest_searched(
        arguments.solver, editor, with_lengths_adapted(arguments.solver, editor, dragged.frames.back()));
    const SolveReport& end = adapted.solve;
    write_results(arguments.solver, editor, to_csv(dragged.frames));
    print(drag_report(arguments, editor, adapted, dragged));
    if (!has_lengths(editor, end)) {
        tell_not_reached(editor, end, arguments.solver.adapts_lengths);
        return k_not_converged;
    }
    tell_sharp_quads(editor, end);
    tell_crumpled(editor, end, "handles that move less, or soft ones, may lead to a smoother one");
    const std::string fault = shortcoming(editor, dragged, arguments.solver.adapts_lengths);
    if (fault.empty()) return k_success;
    std::cerr << "chebnet: " << fault << '\n';
    return k_not_converged;
}

}  // namespace

Command add_drag(CLI::App& program) {
    CLI::App& command =
        *program.add_subcommand("drag", "Move handles to their targets frame by frame and report, as JSON");
    const auto arguments = std::make_shared<DragArguments>();
    add_solver_arguments(command, arguments->solver);
    command.add_option("--frames", arguments->frames, "Number of equal steps from rest to the targets")
        ->required()
        ->check(CLI::Range(1, 100000))
        ->type_name("N");
    return {&command, [arguments] { return run_drag(*arguments); }};
}

}  // namespace chebnet
