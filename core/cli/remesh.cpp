#include "remesh/remesh.h"

#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "base/stopwatch.h"
#include "command.h"
#include "drape/drape.h"
#include "net/topology.h"
#include "net_output.h"
#include "report.h"
#include "surface_argument.h"

namespace chebnet {
namespace {

struct RemeshArguments {
    SurfaceArgument surface;
    NetOutput output;
    RemeshOptions options;
    double smallest_angle = 30;
};

Json remesh_report(const Net& net, const DrapeReport& measured) {
    Json report = net_on_surface_report(net, measured);
    Json by_valence = Json::object();
    int singular = 0;
    for (const auto& [valence, count] : Topology(net).singular_vertices()) {
        by_valence[std::to_string(valence)] = count;
        singular += count;
    }
    report["singular_vertices"] = singular;
    report["singular_vertices_by_valence"] = by_valence;
    return report;
}

int run_remesh(const RemeshArguments& arguments) {
    Surface loaded = load_surface(arguments.surface);
    Stopwatch watch;
    const auto guide = std::make_shared<const Guide>(std::move(loaded));
    Json milliseconds = {{"tree", watch.milliseconds()}};
    RemeshOptions options = arguments.options;
    options.smallest_angle = arguments.smallest_angle * std::numbers::pi / 180;
    const Remesh made = remesh(guide, options);
    for (int phase = 0; phase < k_remesh_phases; ++phase)
        milliseconds[to_string(static_cast<RemeshPhase>(phase))] = made.milliseconds[phase];
    write_net(arguments.output, made.net.rest_positions(), made.net.faces());
    const DrapeReport measured = measure_drape(guide->surface(), guide->tree(), made.net);
    print({{"surface", name_of(arguments.surface)},
           {"described", surface_report(describe(guide->surface()))},
           {"net", remesh_report(made.net, measured)},
           {"milliseconds", milliseconds}});
    return k_success;
}

}  // namespace

Command add_remesh(CLI::App& program) {
    CLI::App& command = *program.add_subcommand(
        "remesh",
        "Make a net over a whole surface, closed or not, with singular vertices, near it and every edge of one length; "
        "report, as JSON");
    const auto arguments = std::make_shared<RemeshArguments>();
    add_surface_argument(command, arguments->surface);
    CLI::Option* cells =
        command.add_option("--cells", arguments->options.cells, "About so many")->capture_default_str();
    command
        .add_option("--length,--edge", arguments->options.length,
                    "In place of their number: the length of all edges, exactly")
        ->type_name("LENGTH")
        ->check(CLI::PositiveNumber)
        ->excludes(cells);
    command.add_option("--shear-limit", arguments->smallest_angle, "No corner is sharper than this, in degrees")
        ->type_name("DEGREES")
        ->capture_default_str();
    command
        .add_option("--smoothing", arguments->options.smoothing,
                    "The more, the larger are the bumps that make no singular vertices: 0 to 100")
        ->type_name("NUMBER")
        ->capture_default_str();
    add_net_output(command, "-o,--out,--output", arguments->output)->type_name("OUT");
    return {&command, [arguments] { return run_remesh(*arguments); }};
}

}  // namespace chebnet
