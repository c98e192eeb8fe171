// Nets with other faces than before, seen from JavaScript.

#include <string>
#include <utility>

#include "change/change.h"
#include "edit/exact_change.h"
#include "mesh_border.h"

namespace chebnet {
namespace {

/// `vertices` and `edges`: Int32Arrays.
val change(val given, std::string name, val vertices, val edges) {
    Mesh mesh = mesh_in(given);
    const Net net(std::move(mesh.positions), std::move(mesh.faces));
    const ChangedMesh changed = find_change(name).make(net, {emscripten::convertJSArrayToNumberVector<int>(vertices),
                                                             emscripten::convertJSArrayToNumberVector<int>(edges)});
    val object = val::object();
    object.set("mesh", mesh_out(changed.mesh.positions, changed.mesh.faces));
    object.set("origins", copy_out(changed.origins));
    object.set("lengthFactor", changed.length_factor);
    object.set("keepsEdges", changed.keeps_edges);
    return object;
}

/// `changed`: an object as `change` returns it, its origins an Int32Array. `options`: an object of `length`, a number
/// or null, `held` (an Int32Array) and `shearLimit`.
ExactChange* exact_change(val changed, val given) {
    ExactChangeOptions options;
    if (const val length = given["length"]; !length.isNull()) options.length = length.as<double>();
    options.held = emscripten::convertJSArrayToNumberVector<int>(given["held"]);
    options.shear_limit = given["shearLimit"].as<double>();
    return new ExactChange({mesh_in(changed["mesh"]), emscripten::convertJSArrayToNumberVector<int>(changed["origins"]),
                            changed["lengthFactor"].as<double>(), changed["keepsEdges"].as<bool>()},
                           std::move(options));
}

val solve(ExactChange& exact, int iterations, double milliseconds) {
    const ExactChangeReport report = exact.solve({iterations, milliseconds});
    val object = val::object();
    object.set("status", std::string(to_string(report.status)));
    object.set("iterations", report.iterations);
    return object;
}

val positions(const ExactChange& exact) { return copy_out(exact.positions()); }

EMSCRIPTEN_BINDINGS(chebnet_change) {
    emscripten::function("change", guarded<&change>);
    emscripten::function("exactChange", guarded<&exact_change>, emscripten::allow_raw_pointers());
    emscripten::class_<ExactChange>("ExactChange")
        .function("solve", guarded<&solve>)
        .function("positions", guarded<&positions>);
}

}  // namespace
}  // namespace chebnet
