#include "solver_arguments.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <utility>

#include "base/error.h"
#include "edit/net_forces.h"
#include "edit_file.h"
#include "fabricate/rod_table.h"
#include "io/file.h"
#include "surface_argument.h"
#include "text_table.h"

namespace chebnet {
namespace {

/// By the numbers that traces have.
std::string stage_list(const MethodInfo& method) {
    std::string list;
    for (std::size_t i = 0; i < method.stages.size(); ++i)
        if (method.stages[i][0] != '\0')
            list += (list.empty() ? "" : ", ") + std::to_string(i + 1) + " " + method.stages[i];
    return list;
}

std::string method_list() {
    std::vector<std::vector<std::string>> rows;
    for (const MethodInfo& method : method_table())
        rows.push_back({method.name, std::string(method.sentence) +
                                         (method.heeds.slides ? " Lets handles slide." : "") + " (" + method.citation +
                                         ") Stages: " + stage_list(method) + "."});
    return "Methods:\n" + text_table(rows);
}

std::string default_text(const OptionInfo& option) {
    const double value = get_option(Options{}, option.name);
    return option.kind == OptionKind::flag ? (value != 0 ? "on" : "off") : to_text(value);
}

std::string range_text(const OptionInfo& option) {
    return option.kind == OptionKind::flag ? "on, off" : to_text(option.smallest) + " to " + to_text(option.largest);
}

std::string option_list() {
    std::vector<std::vector<std::string>> rows;
    for (const OptionInfo& option : option_table())
        rows.push_back({option.name, default_text(option), range_text(option), option.sentence});
    return "Options for --set (default, range, meaning):\n" + text_table(rows);
}

/// What is wrong with a word after --set; nothing if it is key=value. As --set takes every word up to the next option
/// it may have swallowed the net, and a recipe holds an equals sign too.
std::string setting_fault(const std::string& word) {
    const auto equals = word.find('=');
    const bool is_setting = equals != std::string::npos && word.find(':') > equals;
    return is_setting ? "" : "wants key=value, not " + word + " (NET stands before --set)";
}

const MethodInfo& method_of(const Editor& editor) {
    const auto is_used = [&](const MethodInfo& method) { return method.name == editor.method(); };
    return *std::ranges::find_if(method_table(), is_used);
}

/// Says so where the method does not read it: one line of options may be tried with every method.
void set_option(Editor& editor, const std::string& key, const std::string& value) {
    editor.set_option(key, value);
    if (!reads(method_of(editor), key))
        std::cerr << "chebnet: method " << editor.method() << " does not read option " << key << '\n';
}

/// Of GuideMode, as the text of an option.
std::string guide_mode_number(const std::string& name) {
    const std::vector<std::string> names{"off", "near", "on", "outside"};
    return std::to_string(std::find(names.begin(), names.end(), name) - names.begin());
}

/// Keys and values of options, those by short names first. Throws Error bad_option for a key that is given twice.
std::vector<std::pair<std::string, std::string>> settings_of(const SolverArguments& arguments) {
    std::vector<std::pair<std::string, std::string>> settings;
    const auto add = [&](const std::string& key, const std::string& value) {
        if (std::ranges::any_of(settings, [&](const auto& setting) { return setting.first == key; }))
            throw Error(ErrorCode::bad_option, "option " + key + " is given twice");
        settings.emplace_back(key, value);
    };
    if (!arguments.threshold.empty()) add("threshold", arguments.threshold);
    if (!arguments.max_iterations.empty()) add("max_iterations", arguments.max_iterations);
    if (!arguments.shear_limit.empty()) add("shear_limit", arguments.shear_limit);
    if (!arguments.length_scale.empty()) add("length_scale", arguments.length_scale);
    if (!arguments.guide_mode.empty()) add("guide_mode", guide_mode_number(arguments.guide_mode));
    for (const std::string& setting : arguments.settings) {
        const auto equals = setting.find('=');
        add(setting.substr(0, equals), setting.substr(equals + 1));
    }
    return settings;
}

/// As with options, says so where the method does nothing with it.
void set_guide(Editor& editor, const SolverArguments& arguments) {
    if (!reads(method_of(editor), "guide_mode"))
        std::cerr << "chebnet: method " << editor.method() << " does nothing with a guide\n";
    editor.set_guide(load_guide(arguments.guide, arguments.net.repair));
}

/// Another solve, so many milliseconds after the first.
void go_on_with(SolveReport& solved, const SolveReport& next, double pause_ms) {
    const int iterations = solved.trace.empty() ? 0 : solved.trace.back().iteration;
    const double before_ms = solved.milliseconds + pause_ms;
    for (TraceRow row : next.trace) {
        row.iteration += iterations;
        row.total_ms += before_ms;
        solved.trace.push_back(row);
    }
    solved.iterations += next.iterations;
    solved.milliseconds += next.milliseconds;
    solved.factorisation_ms += next.factorisation_ms;
    solved.max_deviation = next.max_deviation;
    solved.to_rest = next.to_rest;
}

}  // namespace

std::string usual_methods() {
    return "unless given " + std::string(usual_method(0)) + ", beyond " + std::to_string(k_most_vertices_at_rest) +
           " vertices " + std::string(usual_method(k_most_vertices_at_rest + 1));
}

void add_solver_arguments(CLI::App& command, SolverArguments& arguments) {
    add_net_argument(command, arguments.net);
    command
        .add_option("--edit", arguments.edit,
                    R"({"handles": [{"vertex": 0, "target": [x, y, z]}, ...]}; "weight": 1 makes a handle soft, )"
                    R"("slides": "xy" lets it slide along these axes, with methods that do)")
        ->required()
        ->type_name("EDIT.json");
    command.add_option("--method", arguments.method, "Method, see below; " + usual_methods())->type_name("NAME");
    command.add_option("--init", arguments.initialisation, "Start of each solve: naive, arap:N or local_global:N")
        ->type_name("INIT")
        ->capture_default_str();
    command.add_option("--threshold", arguments.threshold, "Short for --set threshold=...")->type_name("NUMBER");
    command.add_option("--max-iterations", arguments.max_iterations, "Short for --set max_iterations=...")
        ->type_name("NUMBER");
    command.add_option("--shear-limit", arguments.shear_limit, "Short for --set shear_limit=..., degrees; 0: none")
        ->type_name("NUMBER");
    command
        .add_option("--length-scale", arguments.length_scale,
                    "Short for --set length_scale=..., every edge so many times as long")
        ->type_name("NUMBER");
    command.add_flag("--adapt-lengths", arguments.adapts_lengths,
                     "If handles are out of reach, let all edges grow by one factor, as small as does");
    command.add_flag("--search-rest", arguments.searches_rest,
                     "Then look for another net at rest with less energy, for method equilibrium: takes several times "
                     "as long");
    CLI::Option* const guide =
        command
            .add_option(
                "--guide", arguments.guide,
                "A surface beside the net, for method equilibrium: a file, or the name of one of ours (see drape)")
            ->type_name("SURFACE");
    command.add_option("--guide-mode", arguments.guide_mode, "What it does to the net: off, near, on or outside")
        ->check(CLI::IsMember({"off", "near", "on", "outside"}))
        ->needs(guide)
        ->type_name("MODE");
    command.add_option("--set", arguments.settings, "Options of the solver, see below")
        ->check(setting_fault)
        ->type_name("KEY=VALUE");
    add_net_output(command, "-o,--output", arguments.output)->type_name("OUT");
    command.add_option("--trace", arguments.trace, "Write one line for each iteration, as CSV")->type_name("TRACE.csv");
    command
        .add_option("--edges", arguments.edges,
                    "Write one line for each edge with its length, and with its force if the method knows it, as CSV")
        ->type_name("EDGES.csv");
    command
        .add_option("--rods", arguments.rods,
                    "Write one line for each rod with its length and the marks where others cross it, as CSV")
        ->type_name("RODS.csv");
    command.footer([] { return method_list() + '\n' + option_list(); });
}

Editor open_editor(const SolverArguments& arguments) {
    check_apart({arguments.output.path, arguments.trace, arguments.edges, arguments.rods});
    Editor editor(load_net(arguments.net));
    const std::string_view usual = usual_method(editor.net().vertex_count());
    editor.set_method(arguments.method.empty() ? usual : std::string_view(arguments.method));
    editor.set_initialisation(arguments.initialisation);
    for (const auto& [key, value] : settings_of(arguments)) set_option(editor, key, value);
    if (!arguments.guide.empty()) set_guide(editor, arguments);
    return editor;
}

std::vector<Handle> open_edit(const SolverArguments& arguments, const Editor& editor) {
    std::vector<Handle> handles = read_edit(arguments.edit, editor.net().vertex_count());
    const auto slides = [](const Handle& handle) { return handle.slides != k_no_axes; };
    if (!method_of(editor).heeds.slides && std::ranges::any_of(handles, slides))
        std::cerr << "chebnet: method " << editor.method() << " lets no handles slide: they stay where they are\n";
    return handles;
}

AdaptedSolve with_lengths_adapted(const SolverArguments& arguments, Editor& editor, SolveReport solved) {
    if (!arguments.adapts_lengths || keeps_lengths(solved.status)) return {solved};
    LengthAdapter adapter(editor, {});
    const AdaptReport search = adapter.solve();
    solved.status = search.status;
    if (solved.status != Status::converged) return {solved, search};
    editor.set_state(adapter.state());
    const SolveReport at_rest = editor.solve();
    // A net that is found stays so, whether or not there is time for it to come to rest.
    const bool is_net = at_rest.max_deviation < editor.options().threshold;
    if (!(is_net && at_rest.status == Status::max_iterations)) solved.status = at_rest.status;
    go_on_with(solved, at_rest, search.milliseconds);
    return {solved, search};
}

AdaptedSolve with_rest_searched(const SolverArguments& arguments, Editor& editor, AdaptedSolve solved) {
    if (!arguments.searches_rest || !keeps_lengths(solved.solve.status)) return solved;
    RestSearch search(editor);
    solved.rest_search = search.solve();
    if (solved.rest_search->status != Status::converged) return solved;
    editor.set_state(search.state());
    const SolveReport at_rest = editor.solve();
    solved.solve.status = at_rest.status;
    go_on_with(solved.solve, at_rest, solved.rest_search->milliseconds);
    return solved;
}

void write_results(const SolverArguments& arguments, const Editor& editor, std::string_view trace_csv) {
    write_net(arguments.output, editor.positions(), editor.net().faces());
    if (!arguments.trace.empty()) write_file(arguments.trace, trace_csv);
    if (!arguments.edges.empty()) write_file(arguments.edges, edge_table(editor));
    if (!arguments.rods.empty())
        write_file(arguments.rods, rod_table(editor.net(), Topology(editor.net()), editor.positions()));
}

}  // namespace chebnet
