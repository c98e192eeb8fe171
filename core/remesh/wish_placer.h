#pragma once

#include <Eigen/Core>
#include <vector>

#include "remesh/singular_wishes.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// The wishes on one of the surfaces of triangles: by its numbers.
struct PlacedWishes {
    struct Pin {
        int vertex, index;  ///< inside; quarter turns
    };
    std::vector<Pin> pins;
    std::vector<bool> is_forbidden;  ///< of each triangle
    bool only = false;
};

/// Places wishes on one surface, again and again.
class WishPlacer {
public:
    /// `cell`: the length of the cells to be. The surface has to outlive it.
    WishPlacer(const Surface& surface, double cell);

    /// Each vertex wished for goes to the inner vertex nearest to it, on its piece and its side of the surface, that
    /// has triangles enough for its index, and forbids its surroundings to others. `tree` is of the surface that was
    /// wished for. Throws Error bad_option where two go to the same vertex, or there is none inside.
    PlacedWishes placed(const SingularWishes& wishes, const SurfaceTree& tree) const;
    /// Likewise for vertices of this surface, which stay where they are but for those that others are too near to, and
    /// no others.
    PlacedWishes placed_alone(const std::vector<PlacedWishes::Pin>& pins, const SurfaceTree& tree) const;

private:
    struct Place;
    class Taken;

    Place place_of(const Eigen::Vector3d& wished, const SurfaceTree& tree) const;
    bool may_pin(const Taken& taken, int vertex, int index) const;
    int nearest_vertex(const Taken& taken, const Place& place, int index) const;
    PlacedWishes::Pin pin(Taken& taken, const Place& place, int index, const Eigen::Vector3d& wished) const;
    PlacedWishes::Pin pin(Taken& taken, int vertex, int index) const;
    void forbid(const std::vector<ForbiddenRegion>& regions, PlacedWishes& wishes) const;

    const Surface& m_surface;
    SurfaceTree m_tree;
    std::vector<int> m_pieces;  // of each triangle
    double m_cell;
};

}  // namespace chebnet
