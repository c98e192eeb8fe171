#pragma once

#include <string_view>
#include <vector>

#include "net/mesh.h"
#include "net/net.h"

namespace chebnet {

/// Where a net is to change: some of its vertices and edges (by their numbers in Net::edges()).
struct ChangePlace {
    std::vector<int> vertices{};
    std::vector<int> edges{};
};

/// A net with other faces than before, not yet exact, and what became of its vertices.
struct ChangedMesh {
    Mesh mesh;
    std::vector<int> origins;  ///< of each vertex the one of the net that it was; −1: it is new
    double length_factor = 1;  ///< all edges are to be so many times as long as the net's
    /// Every edge is one of the net's, or part of one, and as long as it is to be: nothing is to be found but lost
    /// digits.
    bool keeps_edges = false;
};

/// What a change reads of its place.
enum class PlacePart { nothing, vertices, edges };

/// A way to change a net. What stays keeps its order, vertices as well as faces, and its place. `make` throws Error
/// impossible_change where the net, or the place, does not allow it, index_out_of_range for a place that it does not
/// have, and too_large.
struct ChangeInfo {
    const char* name;
    const char* sentence;
    PlacePart place_part;
    ChangedMesh (*make)(const Net& net, const ChangePlace& place);
};

/// All of them.
const std::vector<ChangeInfo>& change_table();
/// Throws Error bad_option for a name that is not in the table.
const ChangeInfo& find_change(std::string_view name);

}  // namespace chebnet
