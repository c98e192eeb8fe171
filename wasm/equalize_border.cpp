// Equalising, seen from JavaScript.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/enum_names.h"
#include "edit/equalize.h"
#include "mesh_border.h"
#include "open_surface.h"

namespace chebnet {
namespace {

/// `options`: an object of `choice`, `length`, `handles` (an Int32Array), `method`, `shearLimit` and `guide`
/// (a surface or null).
Equalizer* equalizer(val mesh, val given) {
    Mesh original = mesh_in(mesh);
    EqualizeOptions options;
    options.choice = named(k_equal_lengths, given["choice"].as<std::string>(), "length");
    options.length = given["length"].as<double>();
    options.handles = emscripten::convertJSArrayToNumberVector<int>(given["handles"]);
    options.way = equalize_way_named(given["method"].as<std::string>());
    options.shear_limit = given["shearLimit"].as<double>();
    if (!given["guide"].isNull())
        options.guide = given["guide"].as<OpenSurface*>(emscripten::allow_raw_pointers())->guide;
    return new Equalizer(Net(std::move(original.positions), std::move(original.faces), RestLengths::own),
                         std::move(options));
}

val spread_out(const LengthSpread& spread) {
    val object = val::object();
    object.set("shortest", spread.shortest);
    object.set("longest", spread.longest);
    object.set("standardDeviation", spread.standard_deviation);
    return object;
}

val distance_out(const GuideDistance& distance) {
    val object = val::object();
    object.set("mean", distance.mean);
    object.set("largest", distance.largest);
    return object;
}

val worst_edges_out(const Equalizer& equalizer, const std::vector<int>& edges) {
    const Eigen::Matrix2Xi& ends = equalizer.original().edges();
    return list_out(edges, [&](int e) {
        const int a = ends(0, e), b = ends(1, e);
        val row = val::object();
        row.set("vertexA", a);
        row.set("vertexB", b);
        row.set("length", (equalizer.positions().col(a) - equalizer.positions().col(b)).norm());
        return row;
    });
}

val solve(Equalizer& equalizer, int iterations, double milliseconds) {
    const EqualizeReport report = equalizer.solve({iterations, milliseconds});
    val object = val::object();
    object.set("status", std::string(to_string(report.status)));
    object.set("method", std::string(to_string(report.way)));
    object.set("length", report.length);
    object.set("fittingLength", report.fitting_length);
    object.set("maxDeviation", report.max_deviation);
    object.set("iterations", report.iterations);
    object.set("milliseconds", report.milliseconds);
    object.set("before", spread_out(report.before));
    object.set("after", spread_out(report.after));
    object.set("distance", report.distance ? distance_out(*report.distance) : val::null());
    object.set("smallestAngle", report.smallest_angle);
    object.set("quadsBeyondLimit", report.quads_beyond_limit);
    object.set("foldsBefore", report.folds_before);
    object.set("folds", report.folds);
    object.set("meanMove", report.mean_move);
    object.set("maxMove", report.max_move);
    object.set("worstEdges", worst_edges_out(equalizer, report.worst_edges));
    object.set("unreachablePairs", pairs_out(report.unreachable_pairs));
    return object;
}

val positions(const Equalizer& equalizer) { return copy_out(equalizer.positions()); }
val surface_positions(const Equalizer& equalizer) {
    const std::optional<Positions> positions = equalizer.surface_positions();
    return positions ? copy_out(*positions) : val::null();
}

EMSCRIPTEN_BINDINGS(chebnet_equalize) {
    emscripten::function("equalizer", guarded<&equalizer>, emscripten::allow_raw_pointers());
    emscripten::class_<Equalizer>("Equalizer")
        .function("solve", guarded<&solve>)
        .function("positions", guarded<&positions>)
        .function("surfacePositions", guarded<&surface_positions>);
}

}  // namespace
}  // namespace chebnet
