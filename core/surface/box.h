#pragma once

#include <Eigen/Core>

namespace chebnet {

/// Of a tree of boxes around numbered things, in a flat array: the box between two corners, around all below it.
struct BoxNode {
    Eigen::Vector3d low, high;
    int first;  ///< of a leaf: its first place in the tree's order of things; of another: its second child
    int count;  ///< of a leaf: its things; of another 0, and its first child follows it
};

/// Squared, of a point from the box; 0 within.
inline double squared_distance(const BoxNode& box, const Eigen::Vector3d& point) {
    return (box.low - point).cwiseMax(point - box.high).cwiseMax(0.0).squaredNorm();
}

}  // namespace chebnet
