#include "net/corner_edges.h"

namespace chebnet {

std::vector<int> corner_edges(const Net& net, const Topology& topology) {
    const Faces& faces = net.faces();
    std::vector<int> edges(faces.vertices.size());
    for (int f = 0; f < faces.size(); ++f)
        for (int corner = faces.start[f]; corner < faces.start[f + 1]; ++corner)
            edges[corner] =
                topology.edge_between(faces.vertices[corner], faces.vertices[corner_after(faces, f, corner)]);
    return edges;
}

int corner_after(const Faces& faces, int face, int corner) {
    return corner + 1 == faces.start[face + 1] ? faces.start[face] : corner + 1;
}

int corner_before(const Faces& faces, int face, int corner) {
    return (corner == faces.start[face] ? faces.start[face + 1] : corner) - 1;
}

}  // namespace chebnet
