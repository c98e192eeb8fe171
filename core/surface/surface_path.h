#pragma once

#include <vector>

#include "surface/surface.h"

namespace chebnet {

/// A way over a surface from triangle to triangle, straight within each.
struct SurfacePath {
    std::vector<SurfacePoint> points;  ///< the first, where edges are crossed or vertices met, the last
    std::vector<int> faces;            ///< one less: the triangle that has a point and the next, inside or on its rim
    double length = 0;
};

/// A locally shortest path from `from` to `to`, both snapped: no other near it is shorter, nor any along edges. Begun
/// with the triangles on the shortest way over middles of edges, it is pulled taut within them (the funnel of Lee &
/// Preparata 1984), and where it bends around a vertex led along that one's other side if that is shorter, until no
/// such change is (Xin & Wang: Efficiently determining a locally exact shortest path on polyhedral surfaces, 2007).
/// Likewise with the triangles beside the shortest way along edges; the shorter of the two paths is taken. Where it
/// passes an edge nearer to a vertex than a thousandth of the edge, it goes through the vertex. Nothing if the two are
/// on different pieces of the surface: its `points` are empty.
SurfacePath shortest_path(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to);

}  // namespace chebnet
