#include "change/cut.h"

#include <array>
#include <numeric>

#include "base/error.h"
#include "base/sets.h"
#include "change/marked.h"
#include "net/corner_edges.h"

namespace chebnet {

namespace {

/// Corners of one vertex that edges other than those that are cut still join.
Sets joined_corners(const Net& net, const std::vector<int>& edges, const std::vector<bool>& is_cut) {
    const Faces& faces = net.faces();
    Sets joined(static_cast<int>(faces.vertices.size()));
    // Of each edge the corners at its two ends, in the first face that was met.
    std::vector<std::array<int, 2>> first(static_cast<std::size_t>(net.edge_count()), {-1, -1});
    for (int f = 0; f < faces.size(); ++f)
        for (int corner = faces.start[f]; corner < faces.start[f + 1]; ++corner) {
            const int e = edges[corner], next = corner_after(faces, f, corner);
            if (is_cut[e]) continue;
            const bool forwards = faces.vertices[corner] == net.edges()(0, e);
            const std::array<int, 2> ends = {forwards ? corner : next, forwards ? next : corner};
            if (first[e][0] < 0) {
                first[e] = ends;
                continue;
            }
            for (int side = 0; side < 2; ++side) joined.join(first[e][side], ends[side]);
        }
    return joined;
}

}  // namespace

ChangedMesh parted(const Net& net, const ChangePlace& place) {
    const Faces& faces = net.faces();
    const std::vector<bool> is_cut = marked(place.edges, net.edge_count());
    Sets joined = joined_corners(net, corner_edges(net, Topology(net)), is_cut);

    std::vector<bool> may_part = marked(place.vertices, net.vertex_count());
    for (const int e : place.edges)
        for (const int v : net.edges().col(e)) may_part[v] = true;

    ChangedMesh changed{.mesh = {{}, faces},
                        .origins = std::vector<int>(static_cast<std::size_t>(net.vertex_count())),
                        .keeps_edges = true};
    std::iota(changed.origins.begin(), changed.origins.end(), 0);
    std::vector<int> keeper(static_cast<std::size_t>(net.vertex_count()), -1);  // the set that keeps its vertex
    std::vector<int> new_vertex(faces.vertices.size(), -1);                     // of other sets
    for (std::size_t corner = 0; corner < faces.vertices.size(); ++corner) {
        const int v = faces.vertices[corner];
        if (!may_part[v]) continue;
        const int set = joined.of(static_cast<int>(corner));
        if (keeper[v] < 0) keeper[v] = set;
        if (keeper[v] == set) continue;
        if (new_vertex[set] < 0) {
            new_vertex[set] = static_cast<int>(changed.origins.size());
            changed.origins.push_back(v);
        }
        changed.mesh.faces.vertices[corner] = new_vertex[set];
    }
    changed.mesh.positions = net.rest_positions()(Eigen::all, changed.origins);
    return changed;
}

ChangedMesh cut(const Net& net, const ChangePlace& place) {
    ChangedMesh changed = parted(net, {{}, place.edges});
    if (static_cast<int>(changed.origins.size()) == net.vertex_count())
        throw Error(ErrorCode::impossible_change,
                    "this cut parts nothing: it has to cross the net, or at least two edges inside of it");
    return changed;
}

}  // namespace chebnet
