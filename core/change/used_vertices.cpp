#include "change/used_vertices.h"

namespace chebnet {

ChangedMesh with_vertices_of(const Faces& faces, const Net& net) {
    std::vector<int> new_vertex(static_cast<std::size_t>(net.vertex_count()), -1);
    for (const int v : faces.vertices) new_vertex[v] = 0;
    ChangedMesh rest{.mesh = {{}, faces}, .origins = {}};
    for (int v = 0; v < net.vertex_count(); ++v) {
        if (new_vertex[v] < 0) continue;
        new_vertex[v] = static_cast<int>(rest.origins.size());
        rest.origins.push_back(v);
    }
    for (int& v : rest.mesh.faces.vertices) v = new_vertex[v];
    rest.mesh.positions = net.rest_positions()(Eigen::all, rest.origins);
    return rest;
}

}  // namespace chebnet
