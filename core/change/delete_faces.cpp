#include "change/delete_faces.h"

#include <algorithm>
#include <map>
#include <span>

#include "base/error.h"
#include "base/sets.h"
#include "change/marked.h"
#include "change/used_vertices.h"
#include "net/corner_edges.h"

namespace chebnet {

namespace {

ChangedMesh without(const Net& net, const std::vector<bool>& goes) {
    const auto gone = std::count(goes.begin(), goes.end(), true);
    if (gone == 0)
        throw Error(ErrorCode::impossible_change, "no face lies there: choose vertices or a line of the net");
    if (gone == net.face_count())
        throw Error(ErrorCode::impossible_change, "no face of the net would be left: choose fewer vertices");

    Faces left;
    for (int f = 0; f < net.face_count(); ++f)
        if (!goes[f]) left.add(net.faces()[f]);
    ChangedMesh rest = with_vertices_of(left, net);
    rest.keeps_edges = true;
    return rest;
}

/// Of each face whether one of its corners, or the edge from there to the next, is among these.
std::vector<bool> faces_with(const Net& net, const std::vector<int>& of_corners, const std::vector<bool>& chosen) {
    std::vector<bool> found(static_cast<std::size_t>(net.face_count()), false);
    for (int f = 0; f < net.face_count(); ++f)
        for (int corner = net.faces().start[f]; corner < net.faces().start[f + 1]; ++corner)
            if (chosen[of_corners[corner]]) found[f] = true;
    return found;
}

/// Of each face a number of the part of the net that it would lie in if these edges were cut.
std::vector<int> parts(const Net& net, const std::vector<int>& edges, const std::vector<bool>& is_cut) {
    Sets joined(net.face_count());
    std::vector<int> first(static_cast<std::size_t>(net.edge_count()), -1);
    for (int f = 0; f < net.face_count(); ++f)
        for (int corner = net.faces().start[f]; corner < net.faces().start[f + 1]; ++corner) {
            int& other = first[edges[corner]];
            if (other >= 0 && !is_cut[edges[corner]]) joined.join(other, f);
            other = f;
        }
    std::vector<int> part(static_cast<std::size_t>(net.face_count()));
    for (int f = 0; f < net.face_count(); ++f) part[f] = joined.of(f);
    return part;
}

ChangedMesh one_side(const Net& net, const ChangePlace& place, bool larger) {
    const std::vector<int> edges = corner_edges(net, Topology(net));
    const std::vector<bool> is_cut = marked(place.edges, net.edge_count());
    const std::vector<int> part = parts(net, edges, is_cut);
    const std::vector<bool> at_line = faces_with(net, edges, is_cut);

    std::map<int, int> sizes;  // of the parts at the line, in faces
    for (int f = 0; f < net.face_count(); ++f)
        if (at_line[f]) sizes[part[f]] = 0;
    if (sizes.size() < 2)
        throw Error(ErrorCode::impossible_change,
                    "this line does not part the net: choose one that leads from border to border, or all round");
    for (const int p : part)
        if (const auto found = sizes.find(p); found != sizes.end()) ++found->second;
    const int largest = std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) {
                            return a.second < b.second;
                        })->first;

    std::vector<bool> goes(part.size());
    for (std::size_t f = 0; f < part.size(); ++f)
        goes[f] = larger ? part[f] != largest && sizes.contains(part[f]) : part[f] == largest;
    return without(net, goes);
}

/// V, whether a vertex is on a piece with one of these.
std::vector<bool> on_pieces_of(const Net& net, const std::vector<int>& vertices) {
    const std::vector<std::vector<int>> pieces = Topology(net).components();
    if (pieces.size() < 2) throw Error(ErrorCode::impossible_change, "the net is in one piece");
    if (vertices.empty()) throw Error(ErrorCode::impossible_change, "no piece is chosen: choose a vertex of one");
    const std::vector<bool> is_chosen = marked(vertices, net.vertex_count());
    std::vector<bool> found(is_chosen.size(), false);
    for (const std::vector<int>& piece : pieces)
        if (std::any_of(piece.begin(), piece.end(), [&](int v) { return is_chosen[v]; }))
            for (const int v : piece) found[v] = true;
    if (std::find(found.begin(), found.end(), false) == found.end())
        throw Error(ErrorCode::impossible_change, "every piece of the net is chosen: choose fewer vertices");
    return found;
}

}  // namespace

ChangedMesh without_faces_at(const Net& net, const ChangePlace& place) {
    return without(net, faces_with(net, net.faces().vertices, marked(place.vertices, net.vertex_count())));
}

ChangedMesh without_rows(const Net& net, const ChangePlace& place) {
    return without(net, faces_with(net, corner_edges(net, Topology(net)), marked(place.edges, net.edge_count())));
}

ChangedMesh without_pieces_at(const Net& net, const ChangePlace& place) {
    return without(net, faces_with(net, net.faces().vertices, on_pieces_of(net, place.vertices)));
}

ChangedMesh pieces_at(const Net& net, const ChangePlace& place) {
    std::vector<bool> goes = on_pieces_of(net, place.vertices);
    goes.flip();
    return without(net, faces_with(net, net.faces().vertices, goes));
}

ChangedMesh larger_side(const Net& net, const ChangePlace& place) { return one_side(net, place, true); }
ChangedMesh smaller_side(const Net& net, const ChangePlace& place) { return one_side(net, place, false); }

}  // namespace chebnet
