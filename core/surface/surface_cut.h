#pragma once

#include <span>
#include <string>
#include <vector>

#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// Points on a surface along which to cut it, at least two. Each is joined to the next by a locally shortest path (see
/// shortest_path); where the last is the first again, the cut is closed.
using CutLine = std::vector<SurfacePoint>;

/// The point of a surface nearest to one in space that is meant to be on it. Throws Error bad_option if it is farther
/// from it than a twentieth of the surface's size, non_finite; in their words it is called `name`.
SurfacePoint point_meant(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& point,
                         const std::string& name);

/// Such points for several (3×N), of which the first and the last go on to the border where that is nearer than a
/// hundredth of the surface's size: a hand does not meet it. Throws Error as point_meant does, naming the first that is
/// at fault as a point of `name`.
CutLine cut_line(const Surface& surface, const SurfaceTree& tree, const Positions& points,
                 const std::string& name = "a cut");

/// Where points of a surface are in space: 3×N.
Positions points_of(const Surface& surface, const CutLine& line);

/// How a cut runs over a surface, to be drawn: 3×N. Throws Error as cut_open does.
Positions cut_path(const Surface& surface, const CutLine& line, const std::string& name = "the cut");

/// The surface, cut open: triangles that a cut crosses are split along it, and the vertices on it doubled, so that both
/// sides are boundary. A cut that ends inside leaves a slit; one from border to border, or closed, may separate pieces.
/// Where it has been, the surface stays as it is: shape and area remain, nothing is taken off. Vertices keep their
/// numbers; points are snapped to vertices and edges within a thousandth of a triangle (see snapped). Cuts may meet and
/// cross each other. Throws Error bad_option naming the cut and the point, counted from 1: fewer than two points, no
/// triangle of that number, no way between two points, no length, a cut that crosses or touches itself.
Surface cut_open(const Surface& surface, std::span<const CutLine> cuts);

/// A surface and lines on it that sides of its triangles run along.
struct SurfaceWithLines {
    Surface surface;
    std::vector<bool> is_on_line;  ///< of each side
};
/// The surface with its triangles split as for cuts, but not opened. Throws Error as cut_open does, where lines are
/// called `name` and their number.
SurfaceWithLines with_lines(const Surface& surface, std::span<const CutLine> lines, const std::string& name);

/// Where boundary runs along boundary, as on both sides of a cut: of each side of a triangle the one that runs the
/// other way between the same two places in space; −1 for all others.
std::vector<int> facing_sides(const Surface& surface);

}  // namespace chebnet
