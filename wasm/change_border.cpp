// Nets with other faces than before, seen from JavaScript.

#include <string>
#include <utility>

#include "change/change.h"
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
    object.set("mesh", mesh_out(changed.mesh));
    object.set("origins", copy_out(changed.origins));
    object.set("lengthFactor", changed.length_factor);
    object.set("keepsEdges", changed.keeps_edges);
    return object;
}

EMSCRIPTEN_BINDINGS(chebnet_change) { emscripten::function("change", guarded<&change>); }

}  // namespace
}  // namespace chebnet
