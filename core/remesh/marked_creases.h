#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "net/net.h"
#include "surface/guide.h"
#include "surface/segment.h"

namespace chebnet {

/// A curve on a surface that net lines are to run along, however smooth it is there: points near it (3×N), joined by
/// shortest paths (see cut_line). Closed where the last is the first again.
using MarkedCrease = Positions;

inline constexpr int k_most_marked_creases = 100, k_most_marked_points = 10'000;  ///< and points of all together

/// Throws Error too_large, and as cut_line does; creases are numbered from 1.
void check_marked(const Guide& guide, const std::vector<MarkedCrease>& creases);

/// Which of the sides of a surface net lines are to follow.
struct Creases {
    std::shared_ptr<const Guide> guide;  ///< the surface, with its triangles split along marked creases
    std::vector<bool> sides;             ///< of each side of its; empty: none are followed
    std::vector<Positions> marked;       ///< the way of each marked crease

    std::vector<Segment> segments() const;
};

/// Edges that are sharper than `angle` (see creases_of; 0: none are) and marked creases. Throws Error as check_marked
/// and with_lines do.
Creases find_creases(const std::shared_ptr<const Guide>& guide, double angle, const std::vector<MarkedCrease>& marked);

/// How far net lines are from a marked crease: the mean over its way of the distance to the nearest edge that runs
/// along it, to within 30 degrees, but no more than one edge; in edges of the net.
double distance_along(const Net& net, const Positions& way);

inline constexpr double k_followed_distance = 0.15;
inline bool is_followed(double distance) { return distance < k_followed_distance; }

}  // namespace chebnet
