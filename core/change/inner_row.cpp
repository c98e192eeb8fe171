#include "change/inner_row.h"

#include <array>
#include <utility>

#include "base/error.h"
#include "change/cut.h"
#include "change/folded.h"
#include "change/marked.h"
#include "change/used_vertices.h"
#include "net/corner_edges.h"

namespace chebnet {

namespace {

[[noreturn]] void refuse(const char* reason) { throw Error(ErrorCode::impossible_change, reason); }

/// The corners from which its faces go along an edge.
struct EdgeCorners {
    std::array<int, 2> corners{-1, -1};
    std::array<int, 2> faces{-1, -1};
    bool same_way = false;  ///< both go along it in one direction, as somewhere on every surface with one side
};

/// Of each of the place's edges, which have a face on either side.
std::vector<EdgeCorners> corners_at(const Net& net, const ChangePlace& place, const std::vector<int>& edges) {
    if (place.edges.empty()) refuse("no line of the net is chosen there");
    for (const int e : place.edges)
        if (net.edge_face_counts()[e] != 2)
            refuse("the line lies on the border: there rows are added and deleted, not put in or taken out");
    std::vector<EdgeCorners> found(static_cast<std::size_t>(net.edge_count()));
    for (int f = 0; f < net.face_count(); ++f)
        for (int corner = net.faces().start[f]; corner < net.faces().start[f + 1]; ++corner) {
            EdgeCorners& at = found[edges[corner]];
            const int side = at.corners[0] < 0 ? 0 : 1;
            at.corners[side] = corner;
            at.faces[side] = f;
        }
    std::vector<EdgeCorners> chosen;
    const std::vector<bool> is_chosen = marked(place.edges, net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e) {
        if (!is_chosen[e]) continue;
        EdgeCorners& at = chosen.emplace_back(found[e]);
        at.same_way = net.faces().vertices[at.corners[0]] == net.faces().vertices[at.corners[1]];
    }
    return chosen;
}

/// Moves the vertices that were made of one half way towards their neighbours on their own side.
void spread(const std::vector<bool>& is_doubled, const Faces& faces, Positions& positions) {
    const Positions before = positions;
    std::vector<Eigen::Vector3d> sum(is_doubled.size(), Eigen::Vector3d::Zero());
    std::vector<int> count(is_doubled.size(), 0);
    const auto look = [&](int v, int neighbour) {
        if (!is_doubled[v] || is_doubled[neighbour]) return;
        sum[v] += before.col(neighbour) - before.col(v);
        ++count[v];
    };
    for (int f = 0; f < faces.size(); ++f)
        for (int corner = faces.start[f]; corner < faces.start[f + 1]; ++corner) {
            const int v = faces.vertices[corner], next = faces.vertices[corner_after(faces, f, corner)];
            look(v, next);
            look(next, v);
        }
    for (std::size_t v = 0; v < is_doubled.size(); ++v)
        if (count[v] > 0) positions.col(static_cast<Eigen::Index>(v)) += sum[v] / (2 * count[v]);
}

/// How many of these edges meet at each vertex.
std::vector<int> chosen_at(const Net& net, const std::vector<int>& edges) {
    std::vector<int> count(static_cast<std::size_t>(net.vertex_count()), 0);
    const std::vector<bool> is_chosen = marked(edges, net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e)
        if (is_chosen[e])
            for (const int v : net.edges().col(e)) ++count[v];
    return count;
}

/// Whether these edges, so many of which meet at each vertex, run through the net without meeting others.
void check_run(const Net& net, const Topology& topology, const std::vector<int>& count) {
    for (int v = 0; v < net.vertex_count(); ++v) {
        if (count[v] > 2) refuse("lines cross there: choose one of them");
        if (count[v] == 1 && !topology.is_boundary(v))
            refuse("the line ends inside of the net: choose one from border to border, or all round");
    }
}

}  // namespace

ChangedMesh with_inner_row(const Net& net, const ChangePlace& place) {
    const Topology topology(net);
    const std::vector<EdgeCorners> along = corners_at(net, place, corner_edges(net, topology));
    const std::vector<int> count = chosen_at(net, place.edges);
    check_run(net, topology, count);

    ChangedMesh wider = cut(net, place);
    wider.keeps_edges = false;
    std::vector<bool> is_doubled(wider.origins.size());
    for (std::size_t v = 0; v < wider.origins.size(); ++v) is_doubled[v] = count[wider.origins[v]] > 0;
    spread(is_doubled, wider.mesh.faces, wider.mesh.positions);

    const std::vector<int> vertices = wider.mesh.faces.vertices;
    for (const auto& [corners, faces, same_way] : along) {
        const int a = vertices[corners[0]], b = vertices[corner_after(net.faces(), faces[0], corners[0])];
        int c = vertices[corners[1]], d = vertices[corner_after(net.faces(), faces[1], corners[1])];
        if (same_way) std::swap(c, d);
        wider.mesh.faces.add({b, a, d, c});
    }
    return wider;
}

ChangedMesh without_line(const Net& net, const ChangePlace& place) {
    const Topology topology(net);
    const std::vector<EdgeCorners> along = corners_at(net, place, corner_edges(net, topology));
    const std::vector<int> count = chosen_at(net, place.edges);
    check_run(net, topology, count);
    for (int v = 0; v < net.vertex_count(); ++v)
        if (count[v] > 0 && topology.valence(v) != (topology.is_boundary(v) ? 3 : 4))
            refuse("the line passes a singular vertex, where rows cannot be taken out");

    // Of each face beside the line the quad that it becomes, and whether it goes.
    std::vector<std::array<int, 4>> wide(static_cast<std::size_t>(net.face_count()), {-1, -1, -1, -1});
    std::vector<bool> goes(wide.size(), false), is_beside(wide.size(), false);
    for (const auto& [corners, faces, same_way] : along) {
        std::array<std::array<int, 2>, 2> opposite{};  // the edge of each face on its other side
        for (int side = 0; side < 2; ++side) {
            const int f = faces[side];
            if (net.faces()[f].size() != 4) refuse("the faces beside the line are not all quads");
            if (is_beside[f]) refuse("the line turns, or runs beside itself: choose one that goes straight on");
            is_beside[f] = true;
            const int far = corner_after(net.faces(), f, corner_after(net.faces(), f, corners[side]));
            opposite[side] = {net.faces().vertices[far], net.faces().vertices[corner_after(net.faces(), f, far)]};
        }
        if (same_way) std::swap(opposite[1][0], opposite[1][1]);
        wide[faces[0]] = {opposite[0][0], opposite[0][1], opposite[1][0], opposite[1][1]};
        goes[faces[1]] = true;
    }
    Faces left;
    for (int f = 0; f < net.face_count(); ++f) {
        if (goes[f]) continue;
        if (!is_beside[f]) {
            left.add(net.faces()[f]);
            continue;
        }
        const std::array<int, 4>& quad = wide[f];
        for (const int v : quad)
            if (count[v] > 0) refuse("the line turns, or runs beside itself: choose one that goes straight on");
        if (quad[0] == quad[3] || quad[1] == quad[2])
            refuse("the net is but two rows wide there: nothing would be left between its lines");
        left.add(quad);
    }
    check_not_folded(left);
    return with_vertices_of(left, net);
}

}  // namespace chebnet
