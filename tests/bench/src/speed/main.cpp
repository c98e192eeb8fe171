#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>

#include "base/error.h"
#include "compare.h"
#include "io/file.h"
#include "io/obj.h"
#include "measure.h"
#include "page.h"

namespace {

using namespace chebnet;
using namespace chebnet::bench;
using Json = nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* k_targets[] = {"native", "wasm"};

struct Arguments {
    PlanArguments plan;
    bool list = false;
    std::string output = "build/speed";
    std::vector<std::string> compared;
};

std::string file_of(const std::string& folder, const std::string& name) { return folder + '/' + name + ".json"; }

/// The contents of a file that this program or its sister in Node has written.
template <typename Value, typename Read>
Value read(const std::string& path, Read from_json) {
    try {
        return from_json(Json::parse(read_file(path)));
    } catch (const Json::exception& error) {
        throw Error(ErrorCode::bad_syntax, path + ": no measurements of this program: " + error.what());
    }
}

Results read_results(const std::string& path) {
    return read<Results>(path, [](const Json& json) { return json.get<Results>(); });
}

void write(const Json& json, const std::string& path) { write_file(path, json.dump(1) + '\n'); }

void list_tasks(const PlanArguments& arguments) {
    for (const std::string& name : task_names(arguments)) std::cout << name << '\n';
}

/// Writes what is to be measured, for both targets, and says where.
void plan_measurements(const Arguments& arguments) {
    const Plan plan = make_plan(arguments.plan);
    fs::create_directories(arguments.output);
    // Results of an earlier plan would not belong on the same page.
    for (const char* target : k_targets) fs::remove(file_of(arguments.output, target));
    write(to_json(plan), file_of(arguments.output, "plan"));
    std::cout << arguments.output << '\n';
}

template <typename Result>
void append(std::vector<Result> more, std::vector<Result>& all) {
    all.insert(all.end(), more.begin(), more.end());
}

void measure(const std::string& folder) {
    const Plan plan = read<Plan>(file_of(folder, "plan"), plan_from_json);
    Results results{"native", this_machine(), plan.methods, {}, {}, {}, {}, {}};
    measure_growth(plan, results);
    for (const Task& task : plan.tasks) {
        if (task.section == "growth") continue;
        std::cerr << "  " << task.section << "  " << task.edit << std::endl;
        if (task.section == "kernels") append(measure_kernels(task, plan), results.kernels);
        if (task.section == "edits") append(measure_edit(task, plan), results.edits);
        if (task.section == "drags") append(measure_drag(task, plan), results.drags);
    }
    write(results, file_of(folder, results.target));
}

void write_page(const std::string& folder) {
    std::vector<Results> targets;
    for (const char* target : k_targets)
        if (fs::exists(file_of(folder, target))) targets.push_back(read_results(file_of(folder, target)));
    write_file(folder + "/speed.md", speed_page(targets));
    std::cout << folder << "/speed.md\n";
}

void add_plan_options(CLI::App& plan, Arguments& arguments) {
    plan.add_option("--methods", arguments.plan.methods, "Methods; the others are compared with the first")
        ->delimiter(',')
        ->capture_default_str();
    plan.add_option("--nets", arguments.plan.nets, "OBJ files of this folder in place of the project's own shapes")
        ->type_name("DIR");
    plan.add_option("--edits", arguments.plan.edits, "Edits of these, NET.KIND.json; generated where there is none")
        ->type_name("DIR");
    plan.add_option("--only", arguments.plan.only, "Measure only what has this in its name; may be repeated")
        ->type_name("TEXT");
    plan.add_flag("--quick", arguments.plan.quick, "Small sizes, three samples in place of five");
    plan.add_flag("--list", arguments.list, "List the names of what would be measured");
    plan.add_option("-o,--output", arguments.output, "Folder for the results")->type_name("DIR")->take_last();
}

int run_program(int argc, char** argv) {
    CLI::App program("Measures how fast chebnet is: growth, factorisations, cold solves, drags.", "speed");
    Arguments arguments;
    program.require_subcommand(1);
    CLI::App& plan = *program.add_subcommand("plan", "Write down what is to be measured, for both targets");
    add_plan_options(plan, arguments);
    plan.callback([&] { arguments.list ? list_tasks(arguments.plan) : plan_measurements(arguments); });
    CLI::App& native = *program.add_subcommand("native", "Measure what is planned in a folder");
    native.add_option("folder", arguments.output)->required();
    native.callback([&] { measure(arguments.output); });
    CLI::App& page = *program.add_subcommand("page", "Make the page of the results in a folder");
    page.add_option("folder", arguments.output)->required();
    page.callback([&] { write_page(arguments.output); });
    CLI::App& comparison = *program.add_subcommand("compare", "What changed by more than the noise");
    comparison.add_option("files", arguments.compared, "OLD.json NEW.json")->expected(2)->required();
    comparison.callback(
        [&] { std::cout << compare(read_results(arguments.compared[0]), read_results(arguments.compared[1])); });
    CLI11_PARSE(program, argc, argv);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run_program(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "speed: " << error.what() << '\n';
        return 2;
    }
}
