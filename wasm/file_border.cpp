// What is made of a net or becomes one, seen from JavaScript: reading and repairing meshes, laying nets flat.

#include <string>
#include <variant>
#include <vector>

#include "base/text.h"
#include "fabricate/flat_pattern.h"
#include "io/mesh_file.h"
#include "mesh_border.h"
#include "net/repair.h"

namespace chebnet {
namespace {

Defect defect_named(const std::string& name) {
    for (const Defect defect : k_all_defects)
        if (name == to_string(defect)) return defect;
    throw Error(ErrorCode::bad_option, "no defect is called " + quoted(name));
}

// ------------------------------------------------------------------------------------------------------------ meshes

val finding_out(const Finding& finding) {
    val object = val::object();
    object.set("defect", std::string(to_string(finding.defect)));
    object.set("repaired", finding.repaired);
    object.set("count", finding.count);
    object.set("examples", list_out(finding.examples));
    object.set("sentence", to_sentence(finding));
    return object;
}

/// `bytes`: a Uint8Array, which embind copies into the string as it is.
val read_mesh_file(std::string bytes, std::string name) {
    const Mesh mesh = read_mesh(bytes, name);
    return mesh_out(mesh.positions, mesh.faces);
}

/// `defects`: an array of their names.
val repair_mesh(val mesh, val defects, double merge_tolerance) {
    std::vector<Defect> chosen;
    for (const std::string& name : emscripten::vecFromJSArray<std::string>(defects))
        chosen.push_back(defect_named(name));
    const RepairedMesh repaired = repair(mesh_in(mesh), chosen, merge_tolerance);
    val object = val::object();
    object.set("mesh", mesh_out(repaired.mesh.positions, repaired.mesh.faces));
    object.set("newVertex", copy_out(repaired.new_vertex));
    object.set("findings", list_out(repaired.findings, finding_out));
    return object;
}

val defects() {
    return list_out(k_all_defects, [](Defect defect) { return std::string(to_string(defect)); });
}

val fault_out(const PatternFault& fault, const Topology& topology) {
    val object = val::object();
    object.set("reason", std::string(to_string(fault.reason)));
    if (fault.face != -1) object.set("face", fault.face);
    if (fault.vertex == -1) return object;
    object.set("vertex", fault.vertex);
    object.set("valence", topology.valence(fault.vertex));
    return object;
}

val piece_out(const PatternPiece& piece) {
    val box = val::object();
    box.set("column", piece.column);
    box.set("row", piece.row);
    box.set("columns", piece.columns);
    box.set("rows", piece.rows);
    return box;
}

}  // namespace

val flat_pattern_out(const Net& net, const Topology& topology) {
    const std::variant<FlatPattern, PatternFault> result = flat_pattern(net, topology);
    if (const auto* fault = std::get_if<PatternFault>(&result)) return fault_out(*fault, topology);
    const auto& pattern = std::get<FlatPattern>(result);
    val object = val::object();
    object.set("places", copy_out(pattern.places));
    object.set("columns", pattern.columns);
    object.set("rows", pattern.rows);
    object.set("pieces", list_out(pattern.pieces, piece_out));
    return object;
}

EMSCRIPTEN_BINDINGS(chebnet_meshes) {
    emscripten::constant("mergeTolerance", k_merge_tolerance);
    emscripten::function("defects", guarded<&defects>);
    emscripten::function("readMesh", guarded<&read_mesh_file>);
    emscripten::function("repairMesh", guarded<&repair_mesh>);
}

}  // namespace chebnet
