// Files and meshes that are no nets yet, seen from JavaScript: reading and repairing them.

#include <string>
#include <vector>

#include "io/mesh_file.h"
#include "mesh_border.h"
#include "net/repair.h"

namespace chebnet {
namespace {

Defect defect_named(std::string_view name) {
    Names<Defect> names;
    for (const Defect defect : k_all_defects) names.emplace_back(to_string(defect), defect);
    return named(names, name, "defect");
}

// ------------------------------------------------------------------------------------------------------------ meshes

val mesh_out(const Mesh& mesh) {
    val object = val::object();
    object.set("positions", copy_out(mesh.positions));
    object.set("faceStart", copy_out(mesh.faces.start));
    object.set("faceVertices", copy_out(mesh.faces.vertices));
    return object;
}

val finding_out(const Finding& finding) {
    val examples = val::array();
    for (const int example : finding.examples) examples.call<void>("push", example);
    val object = val::object();
    object.set("defect", std::string(to_string(finding.defect)));
    object.set("repaired", finding.repaired);
    object.set("count", finding.count);
    object.set("examples", examples);
    object.set("sentence", to_sentence(finding));
    return object;
}

/// `bytes`: a Uint8Array, which embind copies into the string as it is.
val read_mesh_file(std::string bytes, std::string name) { return mesh_out(read_mesh(bytes, name)); }

/// `defects`: an array of their names.
val repair_mesh(val mesh, val defects, double merge_tolerance) {
    std::vector<Defect> chosen;
    for (const std::string& name : emscripten::vecFromJSArray<std::string>(defects))
        chosen.push_back(defect_named(name));
    const RepairedMesh repaired = repair(mesh_in(mesh), chosen, merge_tolerance);
    val findings = val::array();
    for (const Finding& finding : repaired.findings) findings.call<void>("push", finding_out(finding));
    val object = val::object();
    object.set("mesh", mesh_out(repaired.mesh));
    object.set("newVertex", copy_out(repaired.new_vertex));
    object.set("findings", findings);
    return object;
}

val defects() {
    val names = val::array();
    for (const Defect defect : k_all_defects) names.call<void>("push", std::string(to_string(defect)));
    return names;
}

EMSCRIPTEN_BINDINGS(chebnet_meshes) {
    emscripten::constant("mergeTolerance", k_merge_tolerance);
    emscripten::function("defects", guarded<&defects>);
    emscripten::function("readMesh", guarded<&read_mesh_file>);
    emscripten::function("repairMesh", guarded<&repair_mesh>);
}

}  // namespace
}  // namespace chebnet
