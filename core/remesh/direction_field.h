#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "remesh/wish_placer.h"
#include "surface/surface.h"

namespace chebnet {

/// Four directions at right angles in each triangle, of which one stands for all: the others are its quarter turns.
struct DirectionField {
    Positions directions;  ///< 3×F, unit vectors in the planes of the triangles
    std::vector<int>
        turns;  ///< of each side: direction 0 here goes on as direction `turns` (0 … 3) beyond; 0 at the boundary
    std::vector<int>
        holonomy;  ///< V, quarter turns (0 … 3) of a walk around the vertex; 0 where it is regular or on the boundary
};

struct FieldOptions {
    int smoothing = 0;                      ///< rounds of it; see smoothest_field
    const PlacedWishes* wishes = nullptr;   ///< of singular vertices; null: none
    std::vector<bool> creases;              ///< of each side, whether it is one; empty: there are none
    std::vector<bool> border;               ///< of each side on the boundary, whether directions follow it; empty: all
    bool crosses_border = false;            ///< they are at 45° to it, not along it
    std::function<void()> go_on = nullptr;  ///< is called before each round of smoothing; whoever wants an end throws
};

/// The smoothest field (Knöppel, Crane, Pinkall & Schröder, Globally Optimal Direction Fields, 2013), along the
/// boundary as far as it follows that, or across it, and along creases. Directions go from vertex to vertex as the
/// normals turn, after so many rounds of smoothing these: the more there are, the less noise and small bumps make
/// singular vertices. Wishes, if there are any, say where these are to be, and turn the way of directions from vertex
/// to vertex for it; where these alone are to be and there are no creases, the field has no others, and the boundary
/// only says how it is turned as a whole.
DirectionField smoothest_field(const Surface& surface, const FieldOptions& options);

/// All directions turned by one angle, radians, which is as smooth, and has the same singular vertices.
DirectionField turned(const Surface& surface, DirectionField field, double angle);

/// The vertices whose holonomy is not 0.
int singular_count(const DirectionField& field);

}  // namespace chebnet
