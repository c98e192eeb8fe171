#pragma once

#include <Eigen/Core>

#include "surface/surface_tree.h"

namespace chebnet {

/// Where a point is as seen from a surface that goes on beyond its boundary as flat as it is there.
struct Height {
    double height;           ///< above the surface, on the side of its normals; negative below it
    double overhang;         ///< how far beyond the boundary, along the surface; 0 if not
    Eigen::Vector3d normal;  ///< of the surface there: of its triangle, its edge or its vertex
    SurfacePoint at;         ///< the nearest point of the surface
};

/// The height changes continuously from 0 on the surface, so that its sign tells the sides apart near it (by normals of
/// edges and vertices, Bærentzen & Aanæs 2005). `guess`: a triangle near the point.
Height height_of(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& point, int guess);
/// The same, where the nearest point is known.
Height height_at(const Surface& surface, const SurfaceTree::Nearest& nearest, const Eigen::Vector3d& point);

/// The same as a vector, and how it changes with the point.
struct Offset {
    Eigen::Vector3d away;    ///< from the nearest point; beyond the boundary its part along the normal
    Eigen::Matrix3d change;  ///< the derivative of `away`: a projection, onto the normal above a triangle
    double along_normal;     ///< above the surface, on the side of its normals; negative below it
    int face;
};
Offset offset_of(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& point, int guess);

}  // namespace chebnet
