#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>

#include "base/error.h"
#include "base/stopwatch.h"
#include "io/file.h"
#include "page_of_figures.h"
#include "plots_of_runs.h"

namespace {

using namespace chebnet;
using namespace chebnet::bench;
namespace fs = std::filesystem;

constexpr int k_repeats = 3;  // of runs whose time a claim is about

struct Arguments {
    bool list = false, record = false;
    std::vector<std::string> only;
    int edits = std::numeric_limits<int>::max();
    std::string figures = CHEBNET_FIGURES, nets, edits_of_nets, output = "build/experiments";
};

/// More edits for each figure that compares variants on one net: those of the OBJ files in a folder.
std::vector<NamedEdit> edits_of_folder(const Arguments& arguments) {
    std::vector<NamedEdit> edits;
    if (arguments.nets.empty()) return edits;
    for (const EditCase& each : cases_of_folder(arguments.nets, arguments.edits_of_nets))
        edits.push_back({each.name(), [each] { return make_problem(each); }});
    return edits;
}

std::vector<const Figure*> chosen(const std::vector<Figure>& figures, const std::vector<std::string>& names) {
    std::vector<const Figure*> list;
    for (const Figure& figure : figures)
        if (names.empty() || std::ranges::count(names, figure.name) > 0) list.push_back(&figure);
    for (const std::string& name : names)
        if (std::ranges::find(figures, name, &Figure::name) == figures.end())
            throw Error(ErrorCode::bad_option, "there is no figure \"" + name + "\"; see --list");
    return list;
}

bool is_about_time(const Figure& figure) {
    return std::ranges::any_of(figure.claims, [](const Claim& claim) { return find_check(claim.check).about_time; });
}

Result run_figure(const Figure& figure, const std::vector<NamedEdit>& more_edits, std::size_t most_edits) {
    std::vector<NamedEdit> edits = figure.edits;
    const bool has_own_edits =
        std::ranges::any_of(figure.variants, [](const Variant& v) { return v.edit.has_value(); });
    if (!has_own_edits) edits.insert(edits.end(), more_edits.begin(), more_edits.end());
    edits.resize(std::min(edits.size(), most_edits));
    Result result{&figure, {}};
    const Stopwatch watch;
    for (const NamedEdit& edit : edits) {
        std::cerr << "  " << figure.name << "  " << edit.name << std::endl;
        Group& group = result.groups.emplace_back();
        for (const Variant& variant : figure.variants)
            group.runs.push_back(run(variant.edit.value_or(edit), variant, is_about_time(figure) ? k_repeats : 1));
    }
    std::cerr << "  took " << watch.milliseconds() / 1000 << " s" << std::endl;
    return result;
}

constexpr const char* k_table_introduction =
    "# The paper, figure by figure\n\n"
    "What became of each claim of Li et al. 2022 that a figure or section 4 makes, on nets of our own. Written by\n"
    "`tests/bench/experiments --record`, whose page `build/experiments/figures.html` has the criteria, the nets, the "
    "plots\n"
    "and all numbers. A claim holds if it is true of every edit tried, does not hold if of none, and else differs. "
    "Times are\n"
    "of one thread.\n\n";

/// What the repository keeps of a run: for the page the verdicts and the plot of figure 6, and the table for readers.
void record(const std::vector<Result>& results, const fs::path& figures) {
    write_file(figures.parent_path() / "verdicts.json", verdicts_json(results));
    write_file(CHEBNET_TABLE, k_table_introduction + verdicts_table(results));
    for (const Result& result : results)
        if (result.figure->plots == std::vector<std::string>{"energies"}) {
            const Plots plots = plots_of_runs(*result.figure, result.groups);
            write_file(figures.parent_path() / (result.figure->name + ".svg"), to_svg(plots.panels, plots.columns));
        }
}

void run_all(const Arguments& arguments, const std::vector<Figure>& figures) {
    const auto list = chosen(figures, arguments.only);
    if (arguments.record && list.size() < figures.size())
        throw Error(ErrorCode::bad_option, "--record wants all figures, without --only");
    const std::vector<NamedEdit> more_edits = edits_of_folder(arguments);
    fs::create_directories(arguments.output);
    const Stopwatch watch;
    std::vector<Result> results;
    for (const Figure* figure : list) {
        std::cerr << '[' << results.size() + 1 << '/' << list.size() << "] " << figure->place() << ": " << figure->title
                  << std::endl;
        results.push_back(run_figure(*figure, more_edits, static_cast<std::size_t>(arguments.edits)));
        write_files(results.back(), arguments.output);
        // After each, so that a run that is broken off leaves a page.
        write_page(results, watch.milliseconds() / 1000, arguments.output);
    }
    if (arguments.record) record(results, arguments.figures);
    std::cout << arguments.output << "/figures.html\n";
}

int run_program(int argc, char** argv) {
    CLI::App program("Makes the figures of Li et al. 2022 again, on our own nets, and judges their claims.",
                     "experiments");
    Arguments arguments;
    program.add_flag("--list", arguments.list, "List the figures");
    program.add_option("--only", arguments.only, "Run this figure; may be repeated")->type_name("NAME");
    program.add_option("--edits-each", arguments.edits, "At most so many edits for each figure")
        ->check(CLI::Range(1, 1000000))
        ->type_name("N");
    program.add_flag("--record", arguments.record, "Renew the verdicts that the page shows and the README links");
    program.add_option("--nets", arguments.nets, "Add the OBJ files of a folder, four edits each")->type_name("DIR");
    program
        .add_option("--edits", arguments.edits_of_nets, "Edits of these, NET.KIND.json; generated where there is none")
        ->type_name("DIR");
    program.add_option("--figures", arguments.figures, "Another description of figures")->type_name("FILE");
    program.add_option("-o,--output", arguments.output, "Folder for the results")->type_name("DIR")->take_last();
    CLI11_PARSE(program, argc, argv);
    const std::vector<Figure> figures = read_figures(arguments.figures);
    if (!arguments.list) {
        run_all(arguments, figures);
        return 0;
    }
    for (const Figure& figure : figures)
        std::cout << figure.name << "  " << figure.place() << ": " << figure.title << '\n';
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
