#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>

#include "experiments.h"
#include "net/error.h"
#include "results.h"
#include "solve/stopwatch.h"

namespace {

using namespace chebnet;
using namespace chebnet::bench;

struct Arguments {
    bool list = false;
    std::vector<std::string> only;
    int cases = std::numeric_limits<int>::max();
    std::string nets, edits, output = "build/experiments";
};

void list_experiments() {
    for (const Experiment& experiment : experiments())
        std::cout << experiment.name << "  figure " << experiment.figure << ": " << experiment.title << '\n';
}

std::vector<const Experiment*> chosen(const std::vector<std::string>& names) {
    std::vector<const Experiment*> list;
    for (const Experiment& experiment : experiments())
        if (names.empty() || std::ranges::count(names, experiment.name) > 0) list.push_back(&experiment);
    for (const std::string& name : names)
        if (std::ranges::find(experiments(), name, &Experiment::name) == experiments().end())
            throw Error(ErrorCode::bad_option, "there is no experiment \"" + name + "\"; see --list");
    return list;
}

Group run_group(const Experiment& experiment, const EditCase& edit) {
    Group group;
    for (const Variant& variant : experiment.variants) group.runs.push_back(run(edit, variant, experiment.repeats));
    return group;
}

Result run_experiment(const Experiment& experiment, const std::vector<EditCase>& more_cases, std::size_t most_cases) {
    std::vector<EditCase> cases = experiment.cases;
    if (!experiment.needs_recipes) cases.insert(cases.end(), more_cases.begin(), more_cases.end());
    cases.resize(std::min(cases.size(), most_cases));
    Result result{&experiment, {}};
    const Stopwatch watch;
    for (const EditCase& edit : cases) {
        std::cerr << "  " << experiment.name << "  " << result.groups.size() + 1 << " of " << cases.size() << "  "
                  << edit.name() << std::endl;
        result.groups.push_back(run_group(experiment, edit));
    }
    std::cerr << "  took " << watch.milliseconds() / 1000 << " s" << std::endl;
    return result;
}

void run_all(const Arguments& arguments) {
    const auto list = chosen(arguments.only);
    std::vector<EditCase> more_cases;
    if (!arguments.nets.empty()) more_cases = cases_of_folder(arguments.nets, arguments.edits);
    std::filesystem::create_directories(arguments.output);
    const Stopwatch watch;
    std::vector<Result> results;
    for (const Experiment* experiment : list) {
        std::cerr << '[' << results.size() + 1 << '/' << list.size() << "] " << experiment->title << std::endl;
        results.push_back(run_experiment(*experiment, more_cases, static_cast<std::size_t>(arguments.cases)));
        write_files(results.back(), arguments.output);
        // After each, so that a run that is broken off leaves a page.
        write_page(results, watch.milliseconds() / 1000, arguments.output);
    }
    std::cout << arguments.output << "/results.md\n";
}

int run_program(int argc, char** argv) {
    CLI::App program("Runs the comparisons of Li et al. 2022 on our own nets.", "experiments");
    Arguments arguments;
    program.add_flag("--list", arguments.list, "List the experiments");
    program.add_option("--only", arguments.only, "Run this experiment; may be repeated")->type_name("NAME");
    program.add_option("--cases", arguments.cases, "At most so many edits for each experiment")
        ->check(CLI::Range(1, 1000000))
        ->type_name("N");
    program.add_option("--nets", arguments.nets, "Add the OBJ files of a folder, four edits each")->type_name("DIR");
    program.add_option("--edits", arguments.edits, "Edits of these, NET.KIND.json; generated where there is none")
        ->type_name("DIR");
    program.add_option("-o,--output", arguments.output, "Folder for the results")->type_name("DIR")->take_last();
    CLI11_PARSE(program, argc, argv);
    if (arguments.list)
        list_experiments();
    else
        run_all(arguments);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run_program(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "experiments: " << error.what() << '\n';
        return 2;
    }
}
