#pragma once

#include <Eigen/Core>
#include <optional>

#include "surface/height.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// A vertex of a net that is made on a surface.
struct DrapedVertex {
    Eigen::Vector3d position;
    SurfacePoint at;         ///< the nearest point of the surface, which is the position unless there is an overhang
    Eigen::Vector3d normal;  ///< of the surface there
    double overhang = 0;     ///< how far beyond the boundary
};

/// Draws a net on a surface with edges of one length, vertex by vertex, as with a pair of compasses (Chebyshev 1878).
/// Where the surface ends it goes on as flat as it is there. Keeps references to surface and tree.
class Compass {
public:
    /// `length`: of all edges.
    Compass(const Surface& surface, const SurfaceTree& tree, double length)
        : m_surface(surface), m_tree(tree), m_length(length) {}

    const Surface& surface() const { return m_surface; }
    const SurfaceTree& tree() const { return m_tree; }
    double length() const { return m_length; }

    DrapedVertex vertex_at(const Eigen::Vector3d& position, int guess) const;

    /// The vertex one edge away along a straightest geodesic, on whose way the direction is taken along. Nothing where
    /// the geodesic turns back before it is so far away, or a direction leads off the surface.
    std::optional<DrapedVertex> straight_on(const DrapedVertex& from, Eigen::Vector3d& direction) const;

    /// The vertex one edge away from both a and b, across from d, which is so too: where the circle of these points
    /// meets the surface, the first such place from the one in the plane of a, b and d. Nothing if a and b are two
    /// edges apart, or fall together, or the circle does not meet the surface on that side.
    std::optional<DrapedVertex> across(const DrapedVertex& d, const DrapedVertex& a, const DrapedVertex& b) const;

private:
    class Circle;

    const Surface& m_surface;
    const SurfaceTree& m_tree;
    double m_length;
};

}  // namespace chebnet
