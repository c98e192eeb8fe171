#pragma once

#include <Eigen/Core>

#include "edit/handle_graph.h"

namespace chebnet {

/// A target this many times as far from that of another handle as the net between them is long is no more than a
/// direction: the net stretches towards it as it would towards one nearer by.
inline constexpr double k_most_strain = 8;
/// So is a target this many mean edge lengths from where its vertex rests: coordinates there have few digits left for
/// the lengths of edges.
inline constexpr double k_farthest_target = 1e9;

/// The point nearest to `point` that is no farther than `radius` from `centre`, all finite; `point` itself, bit for
/// bit, if that is.
Eigen::Vector3d drawn_near(const Eigen::Vector3d& point, const Eigen::Vector3d& centre, double radius);

/// Where solvers are to take the targets of exact handles to be: there, unless that is farther than k_most_strain and
/// k_farthest_target allow; then as far as they do, in that direction. So, whatever the targets, powers of the lengths
/// that they ask for stay in the range of numbers.
///
/// Handles are placed one after the other along the least strained bounds of the graph (a minimum spanning tree by
/// Prim's algorithm), beginning with the one that has moved least: those that are far give way to those that are not.
///
/// `targets` and `rest`: 3 × the graph's handles, in its order and unit; `mean_length`: of the net.
Eigen::Matrix3Xd near_targets(const HandleGraph& graph, double mean_length, const Eigen::Matrix3Xd& targets,
                              const Eigen::Matrix3Xd& rest);

}  // namespace chebnet
