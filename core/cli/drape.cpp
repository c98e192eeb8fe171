#include "drape/drape.h"

#include <memory>
#include <numbers>
#include <utility>

#include "base/stopwatch.h"
#include "command.h"
#include "drape/bridged_drape.h"
#include "drape/proposals.h"
#include "net_output.h"
#include "report.h"
#include "surface/curvature.h"
#include "surface_argument.h"

namespace chebnet {
namespace {

struct DrapeArguments {
    SurfaceArgument surface;
    NetOutput output;
    std::vector<double> seed, direction;
    double length = 0;
    bool has_length = false, best = false;
    int cells = 4000;
    double angle = 90, smallest_angle = 30, leave = 0;
    int reach = DrapeOptions().reach;
    bool inside = false, cut = false;
};

DrapeOptions options_of(const DrapeArguments& arguments, const Surface& surface, const SurfaceTree& tree) {
    DrapeOptions options = suggested_drape(surface, tree, arguments.cells);
    if (arguments.has_length) options.length = arguments.length;
    options.angle = arguments.angle * k_degree;
    options.smallest_angle = arguments.smallest_angle * k_degree;
    options.reach = arguments.reach;
    if (arguments.inside) options.border = DrapeOptions::Border::inside;
    if (arguments.cut) options.border = DrapeOptions::Border::cut;
    if (arguments.best) options = propose_drapes(surface, tree, options).front().options;
    if (!arguments.seed.empty()) options.seed = Eigen::Vector3d::Map(arguments.seed.data());
    if (!arguments.direction.empty()) options.direction = Eigen::Vector3d::Map(arguments.direction.data());
    return options;
}

Json drape_report(const Drape& draped, const DrapeReport& measured) {
    Json report = net_on_surface_report(draped.net, measured);
    report["refused_by_the_shear_limit"] = draped.locked;
    report["refused_where_the_net_meets_itself"] = draped.met;
    report["rod_ends_cut_at_the_border"] = draped.cut_ends;
    return report;
}

int run_drape(const DrapeArguments& arguments) {
    Surface loaded = load_surface(arguments.surface);
    Stopwatch watch;
    const auto guide = std::make_shared<const Guide>(std::move(loaded));
    const Surface& surface = guide->surface();
    const SurfaceTree& tree = guide->tree();
    const double tree_ms = watch.milliseconds();
    watch.restart();
    const DrapeOptions options = options_of(arguments, surface, tree);
    const Drape draped =
        arguments.leave != 0 ? bridged_drape(guide, options, arguments.leave) : drape(surface, tree, options);
    const double drape_ms = watch.milliseconds();
    write_net(arguments.output, draped.net.rest_positions(), draped.net.faces());
    print({{"surface", name_of(arguments.surface)},
           {"described", surface_report(describe(surface))},
           {"net", drape_report(draped, measure_drape(surface, tree, draped.net))},
           {"milliseconds", {{"tree", tree_ms}, {"drape", drape_ms}}}});
    return k_success;
}

}  // namespace

Command add_drape(CLI::App& program) {
    CLI::App& command = *program.add_subcommand(
        "drape",
        "Lay a net on a surface from a seed, every vertex on it and every edge of one length; report, as JSON");
    const auto arguments = std::make_shared<DrapeArguments>();
    add_surface_argument(command, arguments->surface);
    command
        .add_option("--seed", arguments->seed,
                    "Where to begin: the point of the surface nearest to this one; its middle if not given")
        ->type_name("X Y Z")
        ->expected(3);
    command
        .add_option("--direction", arguments->direction,
                    "Of the first family of net lines there, in space; along the x axis if not given")
        ->type_name("X Y Z")
        ->expected(3);
    CLI::Option* length = command.add_option("--edge,--length", arguments->length, "Length of all edges");
    length->type_name("LENGTH");
    command.add_option("--cells", arguments->cells, "In place of the length: about how many cells cover the surface")
        ->capture_default_str()
        ->excludes(length);
    command.add_option("--angle", arguments->angle, "Between the two families at the seed, in degrees")
        ->type_name("DEGREES")
        ->capture_default_str();
    command.add_option("--shear-limit", arguments->smallest_angle, "No corner is sharper than this, in degrees")
        ->type_name("DEGREES")
        ->capture_default_str();
    command
        .add_option("--reach", arguments->reach,
                    "Cells from the seed along each family; as far as it goes if not given")
        ->type_name("CELLS");
    command.add_flag("--best", arguments->best, "Begin where the best of several trials does");
    CLI::Option* inside =
        command.add_flag("--inside", arguments->inside, "Set no vertex beyond the border of the surface");
    command
        .add_flag("--cut", arguments->cut,
                  "Cut rods at the border of the surface; edges there are shorter, and keep the lengths they have")
        ->excludes(inside);
    command
        .add_option("--leave", arguments->leave,
                    "Where the net would lock it leaves the surface by up to this, in edge lengths; 0: a gap stays")
        ->type_name("LENGTHS")
        ->capture_default_str();
    add_net_output(command, "-o,--out,--output", arguments->output)->type_name("OUT");
    return {&command, [arguments, length] {
                arguments->has_length = length->count() > 0;
                return run_drape(*arguments);
            }};
}

}  // namespace chebnet
