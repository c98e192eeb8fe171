// Surfaces and the nets made on them, seen from JavaScript.

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "drape/bridged_drape.h"
#include "drape/cut_proposals.h"
#include "drape/drape.h"
#include "drape/drape_pieces.h"
#include "drape/proposals.h"
#include "drape/surface_report.h"
#include "drape/tilt.h"
#include "mesh_border.h"
#include "net/topology.h"
#include "open_surface.h"
#include "remesh/remesh.h"
#include "session.h"
#include "surface/gallery.h"
#include "surface/shortest_cut.h"
#include "surface/surface_cut.h"

namespace chebnet {
namespace {

OpenSurface* open_surface(val mesh) { return new OpenSurface(Surface(mesh_in(mesh))); }
OpenSurface* own_surface(std::string name) { return new OpenSurface(make_own_surface(name)); }

val own_surface_table() {
    return list_out(own_surfaces(), [](const OwnSurface& surface) {
        val row = val::object();
        row.set("name", std::string(surface.name));
        row.set("title", std::string(surface.title));
        row.set("sentence", std::string(surface.sentence));
        return row;
    });
}

val positions(const OpenSurface& open) { return copy_out(open.surface.positions()); }
val normals(const OpenSurface& open) { return copy_out(open.surface.vertex_normals()); }
val triangles(const OpenSurface& open) { return copy_out(open.surface.triangles()); }

// ------------------------------------------------------------------------------------------------------ what it is
// like

val curvature_out(const TotalCurvature& curvature) {
    val object = val::object();
    object.set("positive", curvature.positive);
    object.set("negative", curvature.negative);
    return object;
}

val describe_surface(const OpenSurface& open) {
    const SurfaceReport report = describe(open.guide);
    val object = val::object();
    object.set("vertices", report.vertices);
    object.set("triangles", report.triangles);
    object.set("trianglesWithoutArea", report.triangles_without_area);
    object.set("components", report.components);
    object.set("boundaryLoops", report.boundary_loops);
    object.set("genus", report.genus);
    object.set("area", report.area);
    object.set("curvature", curvature_out(report.curvature));
    object.set("smoothedCurvature", curvature_out(report.smoothed_curvature));
    object.set("hardestCurvature", report.hardest_curvature);
    object.set("triedCoverage", report.tried_coverage);
    object.set("prospect", std::string(to_string(report.prospect)));
    object.set("sentence", report.sentence);
    return object;
}

val vector_out(const Eigen::Vector3d& vector) { return list_out(vector); }

val place_out(const OpenSurface& open, const Eigen::Vector3d& position, const SurfacePoint& at) {
    val object = val::object();
    object.set("position", vector_out(position));
    object.set("normal", vector_out(open.surface.normal_at(at)));
    return object;
}

val nearest(const OpenSurface& open, double x, double y, double z) {
    const SurfaceTree::Nearest nearest = open.tree.nearest({x, y, z});
    return place_out(open, nearest.position, nearest.at);
}

/// `ray`: a Float64Array of the origin and the direction.
val hit(const OpenSurface& open, val ray) {
    const auto numbers = emscripten::convertJSArrayToNumberVector<double>(ray);
    const auto hit = open.tree.hit(Eigen::Vector3d::Map(numbers.data()), Eigen::Vector3d::Map(numbers.data() + 3));
    return hit ? place_out(open, hit->position, hit->at) : val::null();
}

// ------------------------------------------------------------------------------------------------------------- draping

val suggest(const OpenSurface& open, int cells) {
    const DrapeOptions options = suggested_drape(open.surface, open.tree, cells);
    val object = val::object();
    object.set("seed", vector_out(options.seed));
    object.set("direction", vector_out(options.direction));
    object.set("length", options.length);
    return object;
}

Eigen::Vector3d vector_in(const val& list) {
    return {list[0].as<double>(), list[1].as<double>(), list[2].as<double>()};
}

/// `points`: a Float64Array.
Positions points_in(const val& points) {
    const auto numbers = emscripten::convertJSArrayToNumberVector<double>(points);
    return Positions::Map(numbers.data(), 3, std::ssize(numbers) / 3);
}

DrapeOptions options_in(const val& object) {
    DrapeOptions options;
    options.seed = vector_in(object["seed"]);
    options.direction = vector_in(object["direction"]);
    options.length = object["length"].as<double>();
    options.angle = object["angle"].as<double>();
    options.smallest_angle = object["smallestAngle"].as<double>();
    options.reach = object["reach"].as<int>();
    options.border = named(k_drape_borders, object["border"].as<std::string>(), "border");
    options.arms = named(k_drape_arms, object["arms"].as<std::string>(), "way of the arms");
    options.along = points_in(object["along"]);
    return options;
}

val rows_of(const std::vector<DrapeProposal>& proposals) {
    return list_out(proposals, [](const DrapeProposal& proposal) {
        val row = val::object();
        row.set("seed", vector_out(proposal.options.seed));
        row.set("direction", vector_out(proposal.options.direction));
        row.set("covered", proposal.covered);
        row.set("muchSheared", proposal.much_sheared);
        row.set("meanDistance", proposal.mean_distance);
        return row;
    });
}

/// `options`: an object with all fields of DrapeOptions, of which seed and direction do not matter.
val propose(const OpenSurface& open, val options) {
    const DrapeOptions wanted = options_in(options);
    const Guide& laid_on = *open.laid_on(wanted.length);
    return rows_of(propose_drapes(laid_on.surface(), laid_on.tree(), wanted));
}

/// Likewise, and the direction counts.
val propose_seeds_on(const OpenSurface& open, val options) {
    const DrapeOptions wanted = options_in(options);
    const Guide& laid_on = *open.laid_on(wanted.length);
    return rows_of(propose_seeds(laid_on.surface(), laid_on.tree(), wanted));
}

/// Of a Drape, or of all DrapedPieces together.
template <typename Draped>
val drape_out(const Draped& draped) {
    val object = val::object();
    object.set("mesh", mesh_out(draped.net.rest_positions(), draped.net.faces()));
    object.set("places", copy_out(draped.places));
    object.set("locked", draped.locked);
    object.set("met", draped.met);
    object.set("cutEnds", draped.cut_ends);
    object.set("arms", std::string(name_of(k_drape_arms, draped.arms)));
    return object;
}

/// `options`: an object with all fields of DrapeOptions, and `leave`, 0 or the height for bridged_drape.
val drape_surface(const OpenSurface& open, val options) {
    const double leave = options["leave"].as<double>();
    const DrapeOptions wanted = options_in(options);
    const std::shared_ptr<const Guide>& laid_on = open.laid_on(wanted.length);
    return drape_out(leave != 0 ? bridged_drape(laid_on, wanted, leave)
                                : drape(laid_on->surface(), laid_on->tree(), wanted));
}

val singular_vertices_out(const Net& net) {
    return list_out(Topology(net).singular_vertices(), [](const std::pair<const int, int>& of_valence) {
        val row = val::object();
        row.set("valence", of_valence.first);
        row.set("count", of_valence.second);
        return row;
    });
}

SingularWishes wishes_in(const val& options) {
    SingularWishes wishes;
    for (const val& row : emscripten::vecFromJSArray<val>(options["singular"]))
        wishes.vertices.push_back({vector_in(row["point"]), row["valence"].as<int>()});
    for (const val& row : emscripten::vecFromJSArray<val>(options["forbidden"]))
        wishes.forbidden.push_back({vector_in(row["centre"]), row["radius"].as<double>()});
    wishes.only = options["only"].as<bool>();
    return wishes;
}

val left_off_out(const std::vector<ThinLimb>& limbs) {
    return list_out(limbs, [](const ThinLimb& limb) {
        val row = val::object();
        row.set("point", vector_out(limb.point));
        row.set("girth", limb.girth);
        return row;
    });
}

val singular_out(const std::vector<SingularVertex>& vertices) {
    return list_out(vertices, [](const SingularVertex& singular) {
        val row = val::object();
        row.set("vertex", singular.vertex);
        row.set("valence", singular.valence);
        row.set("position", vector_out(singular.position));
        return row;
    });
}

val kept_out(const SingularWishes& wishes, const KeptWishes& kept) {
    const auto distance_out = [](double distance) { return distance < 0 ? val::null() : val(distance); };
    const auto crease_out = [](double distance) {
        val row = val::object();
        row.set("followed", is_followed(distance));
        row.set("distance", distance);
        return row;
    };
    val object = val::object();
    object.set("vertices", list_out(kept.vertices, [](bool is_kept) { return is_kept; }));
    object.set("distances", list_out(kept.distances, distance_out));
    object.set("intruders", list_out(kept.intruders));
    object.set("others", kept.others);
    object.set("markedCreases", list_out(kept.creases, crease_out));
    object.set("sentences", list_out(unkept_wishes(wishes, kept)));
    return object;
}

/// `options`: an object with all fields of RemeshOptions and of SingularWishes; `progress`: a function of a phase and a
/// part.
val remesh_surface(const OpenSurface& open, val options, val progress) {
    RemeshOptions wanted;
    wanted.cells = options["cells"].as<int>();
    wanted.length = options["length"].as<double>();
    wanted.smallest_angle = options["smallestAngle"].as<double>();
    wanted.smoothing = options["smoothing"].as<double>();
    wanted.fewest = options["fewest"].as<bool>();
    wanted.crease = options["crease"].as<double>();
    wanted.tries_creases = options["triesCreases"].as<bool>();
    for (const val& points : emscripten::vecFromJSArray<val>(options["markedCreases"]))
        wanted.marked_creases.push_back(points_in(points));
    wanted.border = named(k_remesh_borders, options["border"].as<std::string>(), "border");
    wanted.singular = wishes_in(options);
    const Remesh made = remesh(open.guide, wanted,
                               [&](RemeshPhase phase, double done) { progress(std::string(to_string(phase)), done); });
    val milliseconds = val::object();
    for (int phase = 0; phase < k_remesh_phases; ++phase)
        milliseconds.set(to_string(static_cast<RemeshPhase>(phase)), made.milliseconds[phase]);
    val object = val::object();
    object.set("mesh", mesh_out(made.net.rest_positions(), made.net.faces()));
    object.set("singularVertices", singular_vertices_out(made.net));
    object.set("singular", singular_out(made.singular));
    object.set("kept", kept_out(wanted.singular, made.kept));
    object.set("sharpQuads", made.sharp_quads);
    object.set("leftOff", left_off_out(made.left_off));
    object.set("milliseconds", milliseconds);
    return object;
}

// ----------------------------------------------------------------------------------------------------- cuts and pieces

/// `points`: a Float64Array.
CutLine line_in(const OpenSurface& open, const val& points) {
    return cut_line(open.surface, open.tree, points_in(points));
}

val cut_path_on(const OpenSurface& open, val points) { return copy_out(cut_path(open.surface, line_in(open, points))); }

/// `cuts`: an array of Float64Arrays.
OpenSurface* cut_surface(const OpenSurface& open, val cuts) {
    std::vector<CutLine> lines;
    for (const val& points : emscripten::vecFromJSArray<val>(cuts)) lines.push_back(line_in(open, points));
    return new OpenSurface(cut_open(open.surface, lines));
}

val points_out(const Surface& surface, const CutLine& line) {
    return list_out(line, [&](const SurfacePoint& point) { return vector_out(surface.position_at(point)); });
}

/// `from`: null for a cut between borders.
val shortest_cut_on(const OpenSurface& open, val from) {
    const Surface& surface = open.surface;
    return points_out(surface, from.isNull() ? shortest_cut_between_borders(surface)
                                             : shortest_cut_to_border(surface, open.tree.nearest(vector_in(from)).at));
}

/// `options`: an object with all fields of DrapeOptions, and `leave`.
val drape_all_pieces(const OpenSurface& open, val options) {
    PiecesOptions wanted;
    wanted.drape = options_in(options);
    wanted.leave = options["leave"].as<double>();
    wanted.first_seed = true;
    const DrapedPieces made = drape_pieces(open.surface, wanted);
    val object = drape_out(made);
    object.set("pieces", static_cast<int>(made.draped.size()));
    object.set("bare", static_cast<int>(made.bare.size()));
    return object;
}

/// `options`: an object with all fields of DrapeOptions.
val propose_cuts_on(const OpenSurface& open, val options, int most) {
    const CutProposals proposals = propose_cuts(open.surface, options_in(options), most);
    val object = val::object();
    object.set("cuts", list_out(proposals.cuts, [&](const CutLine& line) { return points_out(open.surface, line); }));
    object.set("coverage", list_out(proposals.coverage));
    return object;
}

/// `length`: 0 where it is not known.
val measure(const OpenSurface& open, val net, double length) {
    Mesh mesh = mesh_in(net);
    const auto known = length > 0 ? std::optional(length) : std::nullopt;
    const Net laid(std::move(mesh.positions), std::move(mesh.faces));
    const DrapeReport report = measure_drape(open.surface, open.tree, laid, known);
    val object = val::object();
    object.set("length", report.length);
    object.set("coverage", report.coverage);
    object.set("openBorder", report.open_border);
    object.set("gaps", report.gaps);
    object.set("meanDistance", report.mean_distance);
    object.set("largestDistance", report.largest_distance);
    object.set("wholeCells", report.whole_cells);
    object.set("smallestAngle", report.smallest_angle);
    object.set("largestAngle", report.largest_angle);
    object.set("sheared", report.sheared);
    object.set("muchSheared", report.much_sheared);
    object.set("folds", report.folds);
    object.set("crumpled", report.folds > 0 ? crumpled_edges(*open.guide, laid) : 0);
    object.set("rods", report.rods);
    object.set("rodLength", report.rod_length);
    object.set("maxDeviation", report.max_deviation);
    return object;
}

void guide(Session& session, const OpenSurface& open) { session.editor.set_guide(open.guide); }
void unguide(Session& session) { session.editor.set_guide(nullptr); }

EMSCRIPTEN_BINDINGS(chebnet_surfaces) {
    emscripten::function("guide", guarded<&guide>);
    emscripten::function("unguide", guarded<&unguide>);
    emscripten::function("openSurface", guarded<&open_surface>, emscripten::allow_raw_pointers());
    emscripten::function("ownSurface", guarded<&own_surface>, emscripten::allow_raw_pointers());
    emscripten::function("ownSurfaces", guarded<&own_surface_table>);
    emscripten::class_<OpenSurface>("Surface")
        .function("positions", guarded<&positions>)
        .function("normals", guarded<&normals>)
        .function("triangles", guarded<&triangles>)
        .function("describe", guarded<&describe_surface>)
        .function("nearest", guarded<&nearest>)
        .function("hit", guarded<&hit>)
        .function("suggest", guarded<&suggest>)
        .function("propose", guarded<&propose>)
        .function("proposeSeeds", guarded<&propose_seeds_on>)
        .function("drape", guarded<&drape_surface>)
        .function("cutPath", guarded<&cut_path_on>)
        .function("shortestCut", guarded<&shortest_cut_on>)
        .function("cut", guarded<&cut_surface>, emscripten::allow_raw_pointers())
        .function("drapePieces", guarded<&drape_all_pieces>)
        .function("proposeCuts", guarded<&propose_cuts_on>)
        .function("remesh", guarded<&remesh_surface>)
        .function("measure", guarded<&measure>);
}

}  // namespace
}  // namespace chebnet
