#pragma once

#include <optional>
#include <string>
#include <vector>

#include "net/mesh.h"

namespace chebnet {

/// What can be wrong with a mesh, in the order in which it is looked for and repaired.
enum class Defect {
    duplicate_vertices,    ///< vertices at the place of an earlier one. Repair: merged into the earliest
    degenerate_faces,      ///< faces that name a vertex twice or have fewer than three. Repair: neighbouring corners at
                           ///< one vertex become one; the face is removed if that does not make it sound
    duplicate_faces,       ///< faces with the edges of an earlier one, in either direction. Repair: removed
    non_manifold_edges,    ///< faces that are the third or later at an edge. Repair: removed
    inconsistent_winding,  ///< faces that turn against most of their piece of the mesh. Repair: turned round. A piece
                           ///< with one side only, such as a Möbius strip, is fine as it is
    unused_vertices,       ///< vertices of no face. Repair: dropped
};

/// All of them, in order.
inline const std::vector<Defect> k_all_defects = {Defect::duplicate_vertices,   Defect::degenerate_faces,
                                                  Defect::duplicate_faces,      Defect::non_manifold_edges,
                                                  Defect::inconsistent_winding, Defect::unused_vertices};

/// The defect's name as text, e.g. "duplicate_vertices". Part of the public interface, as the names of ErrorCode.
const char* to_string(Defect defect);

/// One kind of defect that was found.
struct Finding {
    Defect defect;
    bool repaired;
    int count;                  ///< how many vertices or faces, at least 1
    std::vector<int> examples;  ///< the first few of them, ascending, as the mesh that was given numbers them, from 0
};

/// A line for a person, such as "2 vertices at the place of an earlier one, merged: 4, 7".
std::string to_sentence(const Finding& finding);

struct RepairedMesh {
    Mesh mesh;                      ///< vertices and faces that remain, in the order they had
    std::vector<int> new_vertex;    ///< for each vertex that was given where it is now, −1 if it was dropped
    std::vector<Finding> findings;  ///< in the order of Defect; empty if nothing was found
};

/// Vertices closer than this, as a fraction of the mean edge length, count as duplicates unless told otherwise: ten
/// times less than an edge of a finished net may be off its length, and more than coordinates lose as floats.
inline constexpr double k_merge_tolerance = 1e-4;

/// Looks for every defect in turn and repairs those of the `chosen` kinds; each is looked for in the mesh as the
/// repairs before it have left it. With all chosen, a Net refuses the result only if no face, or no edge with a length,
/// is left, or for its scale. A vertex is a duplicate if an earlier one that stays lies within `merge_tolerance` (> 0)
/// times the mean edge length. Throws Error index_out_of_range (a face names no vertex), non_finite (a coordinate, or
/// an edge too long to be measured), bad_option (merge_tolerance).
RepairedMesh repair(Mesh mesh, const std::vector<Defect>& chosen, double merge_tolerance = k_merge_tolerance);

/// The vertices that repair() would merge, without looking for anything else; nothing if there are none. Throws as
/// repair() does.
std::optional<Finding> find_duplicate_vertices(const Mesh& mesh, double merge_tolerance = k_merge_tolerance);

/// Whether a piece of it has one side only, as a Möbius strip has: its faces cannot all wind one way. Edges of more
/// than two faces do not count.
bool has_one_side(const Faces& faces);

}  // namespace chebnet
