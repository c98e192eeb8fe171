#pragma once

#include <Eigen/Core>
#include <utility>

#include "net/net.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// A surface beside which nets are edited, with its tree. It stays where it is, so that others may refer to it.
class Guide {
public:
    explicit Guide(Surface surface) : m_surface(std::move(surface)), m_tree(m_surface) {}
    Guide(const Guide&) = delete;
    Guide& operator=(const Guide&) = delete;

    const Surface& surface() const { return m_surface; }
    const SurfaceTree& tree() const { return m_tree; }

private:
    Surface m_surface;
    SurfaceTree m_tree;
};

/// How far each of some points (3×N, finite) is from the surface, beyond its border from where it would go on as flat
/// as it is there; negative below it.
Eigen::VectorXd heights_over(const Surface& surface, const SurfaceTree& tree, const Positions& points);
inline Eigen::VectorXd heights_over(const Guide& guide, const Positions& points) {
    return heights_over(guide.surface(), guide.tree(), points);
}

/// The same without a sign, of all vertices of a net and the middles of its edges.
struct GuideDistance {
    double mean = 0, largest = 0;
};
GuideDistance distance_to(const Surface& surface, const SurfaceTree& tree, const Net& net, const Positions& positions);
inline GuideDistance distance_to(const Guide& guide, const Net& net, const Positions& positions) {
    return distance_to(guide.surface(), guide.tree(), net, positions);
}

}  // namespace chebnet
