#include "surface_argument.h"

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <system_error>

#include "base/angle.h"
#include "base/error.h"
#include "io/format.h"
#include "io/mesh_file.h"
#include "net_argument.h"
#include "surface/gallery.h"

namespace chebnet {

namespace {

std::string own_surfaces_help() {
    std::string text = "In place of a file, one of our own:";
    for (const OwnSurface& surface : own_surfaces()) text.append(" ").append(surface.name).append(",");
    text.back() = '.';
    return text;
}

Json curvature_report(const TotalCurvature& curvature) {
    return {{"positive_in_pi", curvature.positive / std::numbers::pi},
            {"negative_in_pi", curvature.negative / std::numbers::pi}};
}

}  // namespace

void add_surface_argument(CLI::App& command, SurfaceArgument& argument) {
    command.add_option("SURFACE", argument.file, "File (" + titles_read("or") + ") of the surface; polygons are cut")
        ->type_name("");
    command.add_option("--surface", argument.own, own_surfaces_help())->type_name("NAME");
    add_repair_argument(command, argument.repair);
}

Surface load_surface(const SurfaceArgument& argument) {
    if (argument.file.empty() == argument.own.empty())
        throw Error(ErrorCode::bad_option, "a net is laid on the surface of a file or on one of ours, by --surface");
    if (!argument.own.empty()) return make_own_surface(argument.own);
    Surface surface = load_surface(argument.file, argument.repair);
    if (!(surface.area() > 0)) throw Error(ErrorCode::bad_option, argument.file + ": the surface has no area");
    return surface;
}

std::shared_ptr<const Guide> load_guide(const std::string& name, bool repair) {
    const auto is_own = [&](const OwnSurface& own) { return own.name == name; };
    const bool own = std::ranges::any_of(own_surfaces(), is_own);
    // What is no file by its name was meant as one of ours, which are told then.
    std::error_code unknown;
    const bool is_file = has_mesh_extension(name) || std::filesystem::exists(name, unknown) || unknown;
    return std::make_shared<const Guide>(own || !is_file ? make_own_surface(name) : load_surface(name, repair));
}

std::string name_of(const SurfaceArgument& argument) { return argument.own.empty() ? argument.file : argument.own; }

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

Json net_on_surface_report(const Net& net, const DrapeReport& measured) {
    const double length = measured.length;
    const auto of_cells = [&](double number) { return measured.whole_cells > 0 ? Json(number) : Json(nullptr); };
    return {{"vertices", net.vertex_count()},
            {"edges", net.edge_count()},
            {"cells", net.face_count()},
            {"length", length},
            {"max_dL", measured.max_deviation},
            {"coverage", measured.coverage},
            {"open_border_in_lengths", measured.open_border / length},
            {"gaps", measured.gaps},
            {"mean_distance", measured.mean_distance},
            {"largest_distance", measured.largest_distance},
            {"mean_distance_in_lengths", measured.mean_distance / length},
            {"largest_distance_in_lengths", measured.largest_distance / length},
            {"smallest_corner_angle_degrees", of_cells(measured.smallest_angle / k_degree)},
            {"largest_corner_angle_degrees", of_cells(measured.largest_angle / k_degree)},
            {"part_of_cells_sheared_over_15_degrees", of_cells(measured.sheared)},
            {"part_of_cells_sheared_over_30_degrees", of_cells(measured.much_sheared)},
            {"folds_over_60_degrees", measured.folds},
            {"rods", measured.rods},
            {"rod_length", measured.rod_length}};
}

}  // namespace chebnet
