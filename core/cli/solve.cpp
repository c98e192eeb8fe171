#include <map>
#include <memory>

#include "command.h"
#include "not_reached.h"
#include "report.h"
#include "solver_arguments.h"

namespace chebnet {
namespace {

Json iterations_by_stage(const Trace& trace) {
    std::map<int, int> counts;
    for (const TraceRow& row : trace) ++counts[row.stage];
    Json stages = Json::object();
    for (const auto& [stage, count] : counts) stages[std::to_string(stage)] = count;
    return stages;
}

Json solve_report(const SolverArguments& arguments, const Editor& editor, const AdaptedSolve& adapted) {
    const SolveReport& solved = adapted.solve;
    Json report{{"net", arguments.net.name},           {"method", editor.method()},
                {"status", to_string(solved.status)},  {"to_rest", to_rest_report(solved.to_rest)},
                {"iterations", solved.iterations},     {"iterations_by_stage", iterations_by_stage(solved.trace)},
                {"milliseconds", solved.milliseconds}, {"factorisation_milliseconds", solved.factorisation_ms}};
    if (adapted.search)
        report["search_for_lengths"] = {{"iterations", adapted.search->iterations},
                                        {"milliseconds", adapted.search->milliseconds}};
    if (adapted.rest_search) report["search_for_rest"] = rest_search_report(*adapted.rest_search);
    report.update(shape_report(editor));
    report.update(forces_report(editor));
    return report;
}

int run_solve(const SolverArguments& arguments) {
    Editor editor = open_editor(arguments);
    editor.set_handles(open_edit(arguments, editor));
    const AdaptedSolve adapted =
        with_rest_searched(arguments, editor, with_lengths_adapted(arguments, editor, editor.solve()));
    write_results(arguments, editor, to_csv(adapted.solve.trace));
    print(solve_report(arguments, editor, adapted));
    if (!has_lengths(editor, adapted.solve)) {
        tell_not_reached(editor, adapted.solve, arguments.adapts_lengths);
        return k_not_converged;
    }
    tell_sharp_quads(editor, adapted.solve);
    tell_crumpled(editor, adapted.solve, "chebnet drag, which goes there in steps, may lead to a smoother one");
    return k_success;
}

}  // namespace

Command add_solve(CLI::App& program) {
    CLI::App& command = *program.add_subcommand("solve", "Move handles to their targets at once and report, as JSON");
    const auto arguments = std::make_shared<SolverArguments>();
    add_solver_arguments(command, *arguments);
    return {&command, [arguments] { return run_solve(*arguments); }};
}

}  // namespace chebnet
