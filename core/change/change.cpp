#include "change/change.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/text.h"
#include "change/add_row.h"
#include "change/coarsen.h"
#include "change/cut.h"
#include "change/cut_flat.h"
#include "change/delete_faces.h"
#include "change/inner_row.h"
#include "change/join.h"
#include "change/refine.h"
#include "net/rods.h"
#include "net/topology.h"

namespace chebnet {

namespace {

void check(const std::vector<int>& numbers, int count, const char* what) {
    for (const int number : numbers)
        if (number < 0 || number >= count)
            throw Error(ErrorCode::index_out_of_range, "the net has no " + std::string(what) + " " +
                                                           std::to_string(number) + ", only 0 to " +
                                                           std::to_string(count - 1));
}

/// Rows go across edges of one length, or of lengths of their own, but not on from ends that were cut.
void refuse_cut(const Net& net) {
    if (is_cut(net, Topology(net)))
        throw Error(ErrorCode::impossible_change,
                    "faces at the border of this net have edges of other lengths, as where rods are cut, and a row "
                    "would leave them neither whole nor cut: of a surface lay a larger net, or give all edges one "
                    "length first");
}

/// `make` of a sound place.
template <ChangedMesh (*make)(const Net&, const ChangePlace&)>
ChangedMesh checked(const Net& net, const ChangePlace& place) {
    check(place.vertices, net.vertex_count(), "vertex");
    check(place.edges, net.edge_count(), "edge");
    return make(net, place);
}

template <ChangedMesh (*make)(const Net&, const ChangePlace&)>
ChangedMesh checked_uncut(const Net& net, const ChangePlace& place) {
    refuse_cut(net);
    return checked<make>(net, place);
}

}  // namespace

const std::vector<ChangeInfo>& change_table() {
    static const std::vector<ChangeInfo> table = {
        {"refine", "every quad becomes two by two, every triangle four, with half the edge length", PlacePart::nothing,
         checked<refined>},
        {"coarsen", "two by two quads become one, with twice the edge length; rows left over at the border go",
         PlacePart::nothing, checked<coarsened>},
        {"cut", "the edges of the line are cut: both sides have vertices of their own there", PlacePart::edges,
         checked<cut>},
        {"cut_flat", "the net is cut along lines, so that each piece lies flat as a square grid", PlacePart::nothing,
         checked<cut_flat>},
        {"keep_larger", "of the sides of the line only the largest stays", PlacePart::edges, checked<larger_side>},
        {"keep_smaller", "of the sides of the line the largest goes", PlacePart::edges, checked<smaller_side>},
        {"delete_rows", "the rows of faces beside the line go", PlacePart::edges, checked<without_rows>},
        {"delete_faces", "the faces at the vertices go", PlacePart::vertices, checked<without_faces_at>},
        {"keep_pieces", "of the pieces of the net only those with one of the vertices stay", PlacePart::vertices,
         checked<pieces_at>},
        {"delete_pieces", "the pieces of the net with one of the vertices go", PlacePart::vertices,
         checked<without_pieces_at>},
        {"add_row", "a row of quads is added along the line, which lies on the border", PlacePart::edges,
         checked_uncut<with_row>},
        {"insert_row", "a row of quads is put in along the line, which runs through the net", PlacePart::edges,
         checked_uncut<with_inner_row>},
        {"remove_line", "the line is taken out: the rows on its two sides become one", PlacePart::edges,
         checked_uncut<without_line>},
        {"join", "borders within half an edge of each other become one", PlacePart::nothing, checked<joined>}};
    return table;
}

const ChangeInfo& find_change(std::string_view name) {
    const std::vector<ChangeInfo>& table = change_table();
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const ChangeInfo& row) { return row.name == name; });
    if (found != table.end()) return *found;
    std::string known;
    for (const ChangeInfo& row : table) known += (known.empty() ? "" : ", ") + std::string(row.name);
    throw Error(ErrorCode::bad_option, "no change is called " + quoted(name) + "; known are " + known);
}

}  // namespace chebnet
