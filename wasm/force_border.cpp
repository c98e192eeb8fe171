// What holds a net at rest, seen from JavaScript.

#include <optional>

#include "border.h"
#include "edit/net_forces.h"
#include "session.h"

namespace chebnet {
namespace {

val corners_out(const std::vector<CornerForce>& corners) {
    return list_out(corners, [](const CornerForce& force) {
        const auto& [a, b, push] = force;
        val corner = val::object();
        corner.set("vertexA", a);
        corner.set("vertexB", b);
        corner.set("push", push);
        return corner;
    });
}

val energies_out(const std::vector<TermEnergy>& energies) {
    val object = val::object();
    for (const auto& [name, energy] : energies) object.set(name, energy);
    return object;
}

/// null: not known. Of handles 3 numbers each.
val forces(const Session& session) {
    const std::optional<NetForces> forces = net_forces(session.editor);
    if (!forces) return val::null();
    val object = val::object();
    object.set("edges", copy_out(forces->edges));
    object.set("corners", corners_out(forces->corners));
    object.set("handles", copy_out(forces->handles));
    object.set("energies", energies_out(forces->energies));
    return object;
}

EMSCRIPTEN_BINDINGS(chebnet_forces) { emscripten::function("forces", guarded<&forces>); }

}  // namespace
}  // namespace chebnet
