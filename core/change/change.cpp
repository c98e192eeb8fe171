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

namespace chebnet {

namespace {

void check(const std::vector<int>& numbers, int count, const char* what) {
    for (const int number : numbers)
        if (number < 0 || number >= count)
            throw Error(ErrorCode::index_out_of_range, "the net has no " + std::string(what) + " " +
                                                           std::to_string(number) + ", only " + std::to_string(count));
}

/// `make` of a sound place.
template <ChangedMesh (*make)(const Net&, const ChangePlace&)>
ChangedMesh checked(const Net& net, const ChangePlace& place) {
    check(place.vertices, net.vertex_count(), "vertex");
    check(place.edges, net.edge_count(), "edge");
    return make(net, place);
}

}  // namespace

const std::vector<ChangeInfo>& change_table() {
    static const std::vector<ChangeInfo> table = {
        {"refine", "every quad becomes two by two, with half the edge length", PlacePart::nothing, checked<refined>},
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
         checked<with_row>},
        {"insert_row", "a row of quads is put in along the line, which runs through the net", PlacePart::edges,
         checked<with_inner_row>},
        {"remove_line", "the line is taken out: the rows on its two sides become one", PlacePart::edges,
         checked<without_line>},
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
