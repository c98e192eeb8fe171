#include "drape/drape.h"

#include <memory>
#include <numbers>

#include "base/error.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "command.h"
#include "drape/proposals.h"
#include "io/format.h"
#include "net_argument.h"
#include "net_output.h"
#include "report.h"
#include "surface/curvature.h"
#include "surface/gallery.h"

namespace chebnet {
namespace {

struct DrapeArguments {
    std::string surface;
    bool repair = false;
    NetOutput output;
    std::string own;
    std::vector<double> seed, direction;
    double length = 0;
    bool has_length = false, best = false;
    int cells = 4000;
    double angle = 90, smallest_angle = 30;
    int reach = DrapeOptions().reach;
    bool inside = false;
};

DrapeOptions options_of(const DrapeArguments& arguments, const Surface& surface, const SurfaceTree& tree) {
    DrapeOptions options = suggested_drape(surface, tree, arguments.cells);
    if (arguments.has_length) options.length = arguments.length;
    options.angle = arguments.angle * k_degree;
    options.smallest_angle = arguments.smallest_angle * k_degree;
    options.reach = arguments.reach;
    if (arguments.inside) options.border = DrapeOptions::Border::inside;
    if (arguments.best) options = propose_drapes(surface, tree, options).front().options;
    if (!arguments.seed.empty()) options.seed = Eigen::Vector3d::Map(arguments.seed.data());
    if (!arguments.direction.empty()) options.direction = Eigen::Vector3d::Map(arguments.direction.data());
    return options;
}

Surface surface_of(const DrapeArguments& arguments) {
    if (arguments.surface.empty() == arguments.own.empty())
        throw Error(ErrorCode::bad_option, "a net is laid on the surface of a file or on one of ours, by --surface");
    return arguments.own.empty() ? load_surface(arguments.surface, arguments.repair) : make_own_surface(arguments.own);
}

Json curvature_report(const TotalCurvature& curvature) {
    return {{"positive_in_pi", curvature.positive / std::numbers::pi},
            {"negative_in_pi", curvature.negative / std::numbers::pi}};
}

Json surface_report(const SurfaceReport& surface) {
    return {{"vertices", surface.vertices},
            {"triangles", surface.triangles},
            {"triangles_without_area", surface.triangles_without_area},
            {"components", surface.components},
            {"boundary_loops", surface.boundary_loops},
            {"genus", surface.genus},
            {"area", surface.area},
            {"total_curvature", curvature_report(surface.curvature)},
            {"total_curvature_without_noise", curvature_report(surface.smoothed_curvature)},
            {"prospect", surface.sentence}};
}

Json drape_report(const Drape& draped, const DrapeReport& measured) {
    const double length = draped.net.mean_length();
    return {{"vertices", draped.net.vertex_count()},
            {"edges", draped.net.edge_count()},
            {"cells", draped.net.face_count()},
            {"length", length},
            {"max_dL", measured.max_deviation},
            {"coverage", measured.coverage},
            {"mean_distance", measured.mean_distance},
            {"largest_distance", measured.largest_distance},
            {"mean_distance_in_lengths", measured.mean_distance / length},
            {"largest_distance_in_lengths", measured.largest_distance / length},
            {"smallest_corner_angle_degrees", measured.smallest_angle / k_degree},
            {"largest_corner_angle_degrees", measured.largest_angle / k_degree},
            {"cells_sheared_over_15_degrees", measured.sheared},
            {"cells_sheared_over_30_degrees", measured.much_sheared},
            {"rods", measured.rods},
            {"rod_length", measured.rod_length},
            {"refused_by_the_shear_limit", draped.locked},
            {"refused_where_the_net_meets_itself", draped.met}};
}

int run_drape(const DrapeArguments& arguments) {
    const Surface surface = surface_of(arguments);
    Stopwatch watch;
    const SurfaceTree tree(surface);
    const double tree_ms = watch.milliseconds();
    watch.restart();
    const Drape draped = drape(surface, tree, options_of(arguments, surface, tree));
    const double drape_ms = watch.milliseconds();
    write_net(arguments.output, draped.net.rest_positions(), draped.net.faces());
    print({{"surface", arguments.own.empty() ? arguments.surface : arguments.own},
           {"described", surface_report(describe(surface))},
           {"net", drape_report(draped, measure_drape(surface, tree, draped.net))},
           {"milliseconds", {{"tree", tree_ms}, {"drape", drape_ms}}}});
    return k_success;
}

std::string own_surfaces_help() {
    std::string text = "In place of a file, one of our own:";
    for (const OwnSurface& surface : own_surfaces()) text.append(" ").append(surface.name).append(",");
    text.back() = '.';
    return text;
}

}  // namespace

Command add_drape(CLI::App& program) {
    CLI::App& command = *program.add_subcommand(
        "drape",
        "Lay a net on a surface from a seed, every vertex on it and every edge of one length; report, as JSON");
    const auto arguments = std::make_shared<DrapeArguments>();
    command
        .add_option("SURFACE", arguments->surface, "File (" + titles_read("or") + ") of the surface; polygons are cut")
        ->type_name("");
    command.add_option("--surface", arguments->own, own_surfaces_help())->type_name("NAME");
    add_repair_argument(command, arguments->repair);
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
    command.add_flag("--inside", arguments->inside, "Set no vertex beyond the border of the surface");
    add_net_output(command, "-o,--out,--output", arguments->output)->type_name("OUT");
    return {&command, [arguments, length] {
                arguments->has_length = length->count() > 0;
                return run_drape(*arguments);
            }};
}

}  // namespace chebnet
