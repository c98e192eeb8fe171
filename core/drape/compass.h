#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

#include "drape/draped_vertex.h"
#include "drape/slits.h"
#include "surface/height.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// Draws a net on a surface with edges of one length, vertex by vertex, as with a pair of compasses (Chebyshev 1878).
/// Where the surface ends it goes on as flat as it is there. Keeps references to surface and tree.
class Compass {
public:
    /// `length`: of all edges. `slits`: of the surface, for this length, to be kept to; they must outlive it.
    Compass(const Surface& surface, const SurfaceTree& tree, double length, const Slits* slits = nullptr)
        : m_surface(surface),
          m_tree(tree),
          m_length(length),
          m_rounding(16 * std::numeric_limits<double>::epsilon() * surface.positions().cwiseAbs().maxCoeff()),
          m_slits(slits) {}

    const Surface& surface() const { return m_surface; }
    const SurfaceTree& tree() const { return m_tree; }
    double length() const { return m_length; }
    /// Distances that differ by no more are equal, so far from the origin as the surface is.
    double tolerance() const { return k_exact * m_length + m_rounding; }

    /// Whether a vertex does not stand beyond the boundary.
    bool is_on_surface(const DrapedVertex& vertex) const { return vertex.overhang <= tolerance(); }

    /// As height_of, but as seen from a triangle near the point: on this side of slits.
    Height height(const Eigen::Vector3d& point, int from) const;

    /// Whether a slit runs between two vertices.
    bool is_slit_between(const DrapedVertex& a, const DrapedVertex& b) const {
        return m_slits != nullptr && m_slits->part(a, b);
    }

    DrapedVertex vertex_at(const Eigen::Vector3d& position, int guess) const;

    /// The vertex one edge away along a straightest geodesic, on whose way the direction is taken along. Nothing where
    /// the geodesic turns back before it is so far away, or a direction leads off the surface.
    std::optional<DrapedVertex> straight_on(const DrapedVertex& from, Eigen::Vector3d& direction) const;

    /// The vertex one edge away from both a and b, across from d, which is so too: where the circle of these points
    /// meets the surface, the first such place from the one in the plane of a, b and d. Nothing if a and b are two
    /// edges apart, or fall together, or the circle does not meet the surface on that side.
    std::optional<DrapedVertex> across(const DrapedVertex& d, const DrapedVertex& a, const DrapedVertex& b) const;

private:
    // In edge lengths: how far a vertex may be off the distance to its neighbours, and how far from the boundary it
    // still counts as standing on it.
    static constexpr double k_exact = 1e-9;

    class Circle;

    std::optional<DrapedVertex> vertex_beyond(const Eigen::Vector3d& position, int guess) const;

    const Surface& m_surface;
    const SurfaceTree& m_tree;
    double m_length, m_rounding;
    const Slits* m_slits;
};

}  // namespace chebnet
