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

val mesh_out(const Positions& positions, const Faces& faces) {
    val object = val::object();
    object.set("positions", copy_out(positions));
    object.set("faceStart", copy_out(faces.start));
    object.set("faceVertices", copy_out(faces.vertices));
    return object;
}

val pairs_out(const std::vector<UnreachablePair>& pairs) {
    return list_out(pairs, [](const UnreachablePair& pair) {
        val row = val::object();
        row.set("vertexA", pair.vertex_a);
        row.set("vertexB", pair.vertex_b);
        row.set("distance", pair.distance);
        row.set("reach", pair.reach);
        return row;
    });
}

val lists_out(const std::vector<std::vector<int>>& lists) {
    Faces flat;
    for (const std::vector<int>& list : lists) flat.add(list);
    val object = val::object();
    object.set("start", copy_out(flat.start));
    object.set("vertices", copy_out(flat.vertices));
    return object;
}

}  // namespace chebnet
