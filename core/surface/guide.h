#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "net/net.h"
#include "surface/inside_out.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// A surface beside which nets are edited, with its tree. It stays where it is, so that others may refer to it.
class Guide {
public:
    explicit Guide(Surface surface)
        : m_surface(std::move(surface)), m_tree(m_surface), m_inside_out(faces_inside_out(m_surface)) {}
    Guide(const Guide&) = delete;
    Guide& operator=(const Guide&) = delete;

    const Surface& surface() const { return m_surface; }
    const SurfaceTree& tree() const { return m_tree; }
    /// Whether a triangle is of a closed piece whose normals point inwards (see faces_inside_out()): what they point to
    /// counts as below it.
    bool is_inside_out(int face) const { return !m_inside_out.empty() && m_inside_out[face]; }

private:
    Surface m_surface;
    SurfaceTree m_tree;
    std::vector<bool> m_inside_out;
};

/// How far each of some points (3×N, finite) is from the surface, beyond its border from where it would go on as flat
/// as it is there; negative below it, which is inside of a closed piece, whichever way it winds.
Eigen::VectorXd heights_over(const Guide& guide, const Positions& points);

/// The same without a sign, of all vertices of a net and the middles of its edges.
struct GuideDistance {
    double mean = 0, largest = 0;
};
GuideDistance distance_to(const Surface& surface, const SurfaceTree& tree, const Net& net, const Positions& positions);
inline GuideDistance distance_to(const Guide& guide, const Net& net, const Positions& positions) {
    return distance_to(guide.surface(), guide.tree(), net, positions);
}

}  // namespace chebnet
