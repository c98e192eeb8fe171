#pragma once

#include <Eigen/Core>
#include <vector>

#include "drape/draped_vertex.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// Where a surface is cut open (see cut_open): boundary runs along boundary, and what is near in space on the other
/// side of a slit is not so on the surface; or it was cut from another there, which may be so small that an edge would
/// go across it. A bank is one side of a slit. Keeps references to surface and tree.
class Slits {
public:
    /// `reach`: the length of a net's edges; what is asked for is no farther apart than four of them. `seam`: of each
    /// side, whether the surface was cut from another there (see DrapeOptions); empty where it was nowhere.
    Slits(const Surface& surface, const SurfaceTree& tree, double reach, const std::vector<bool>& seam = {});

    bool none() const { return m_bank_of.empty(); }

    /// The point of the surface nearest to `point`, as seen from a triangle near it: on this side of slits.
    SurfaceTree::Nearest nearest(const Eigen::Vector3d& point, int from) const;

    /// Whether a point of the surface lies on a bank, but for the ends of slits.
    bool is_on_bank(const SurfacePoint& point) const { return !none() && bank_of(point) > 0; }

    /// Whether a slit runs between two vertices of a net: none sees the other, or they stand on different banks, or
    /// beyond them.
    bool part(const DrapedVertex& a, const DrapedVertex& b) const;

private:
    void find_banks(const std::vector<bool>& seam);
    void find_near();
    int bank_of(const SurfacePoint& point) const;
    SurfaceTree::Nearest descended(const Eigen::Vector3d& point, int from) const;
    bool runs_into_bank(const DrapedVertex& from, const DrapedVertex& to) const;
    bool reaches_bank(const DrapedVertex& from, const DrapedVertex& banked) const;

    const Surface& m_surface;
    const SurfaceTree& m_tree;
    double m_reach;
    std::vector<int> m_bank_of;     // of each vertex, from 1; 0 elsewhere, also where a slit ends; empty without slits
    std::vector<int> m_bank_along;  // of each side, likewise
    std::vector<bool> m_is_near;    // of each triangle
};

}  // namespace chebnet
