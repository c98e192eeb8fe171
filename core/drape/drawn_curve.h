#pragma once

#include <Eigen/Core>
#include <optional>

#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// A curve on a surface that a net line is to follow: a chain of segments, each within a triangle.
class DrawnCurve {
public:
    /// Through `points` (3×N), joined by shortest paths; see cut_line and cut_path. Closed where the last is the first
    /// again. Throws Error bad_option, non_finite as these do, and bad_option where all points are one.
    DrawnCurve(const Surface& surface, const SurfaceTree& tree, const Positions& points);

    /// A place on it.
    struct Place {
        Eigen::Index segment;
        Eigen::Vector3d position;
    };
    Place nearest(const Eigen::Vector3d& point) const;

    /// The first place behind another one, in the order of the points or against it, that is so far from it. Nothing
    /// where the curve ends before.
    std::optional<Place> after(const Place& from, double distance, bool forwards) const;

private:
    Eigen::Index segments() const { return m_chain.cols() - 1; }

    Positions m_chain;
    bool m_is_closed;
};

}  // namespace chebnet
