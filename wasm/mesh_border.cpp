// Meshes across the border.

#include "mesh_border.h"

namespace chebnet {

Mesh mesh_in(const val& object) {
    const auto coordinates = emscripten::convertJSArrayToNumberVector<double>(object["positions"]);
    Mesh mesh;
    mesh.positions =
        Eigen::Map<const Positions>(coordinates.data(), 3, static_cast<Eigen::Index>(coordinates.size() / 3));
    mesh.faces.start = emscripten::convertJSArrayToNumberVector<int>(object["faceStart"]);
    mesh.faces.vertices = emscripten::convertJSArrayToNumberVector<int>(object["faceVertices"]);
    return mesh;
}

val mesh_out(const Mesh& mesh) {
    val object = val::object();
    object.set("positions", copy_out(mesh.positions));
    object.set("faceStart", copy_out(mesh.faces.start));
    object.set("faceVertices", copy_out(mesh.faces.vertices));
    return object;
}

val pairs_out(const std::vector<UnreachablePair>& pairs) {
    val rows = val::array();
    for (const UnreachablePair& pair : pairs) {
        val row = val::object();
        row.set("vertexA", pair.vertex_a);
        row.set("vertexB", pair.vertex_b);
        row.set("distance", pair.distance);
        row.set("reach", pair.reach);
        rows.call<void>("push", row);
    }
    return rows;
}

val lists_out(const std::vector<std::vector<int>>& lists) {
    Faces flat;
    for (const std::vector<int>& list : lists) flat.add(list);
    val object = val::object();
    object.set("start", copy_out(flat.start));
    object.set("vertices", copy_out(flat.vertices));
    return object;
}

RestLengths rest_lengths_named(std::string_view name) {
    static const Names<RestLengths> names = {
        {"automatic", RestLengths::automatic}, {"equal", RestLengths::equal}, {"own", RestLengths::own}};
    return named(names, name, "choice of rest lengths");
}

}  // namespace chebnet
