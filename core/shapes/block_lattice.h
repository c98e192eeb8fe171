#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapes/family.h"
#include "shapes/voxel_solid.h"

namespace chebnet {

/// A box of cells of the unit lattice; flat, between lattice points, if it stands for an opening.
struct CellBox {
    Eigen::Vector3i low, high;
};

VoxelSolid union_of(std::span<const CellBox> boxes);

/// A union of boxes on the uneven lattice of the planes in which boxes and openings begin and end: few oblong blocks,
/// however many cells they have. A face that lies in an opening is left out.
class BlockLattice {
public:
    explicit BlockLattice(std::span<const CellBox> boxes, std::span<const CellBox> openings = {});

    /// How many vertices the boundary has when it is cut into unit squares, but for a few, without making them.
    double vertex_count() const;
    /// The boundary, one oblong face for each face of a block.
    Mesh surface() const;

private:
    std::vector<CellBox> places_of(std::span<const CellBox> boxes) const;
    bool is_open(const Eigen::Vector3i& low, const Eigen::Vector3i& high) const;

    std::vector<int> m_planes[3];
    std::vector<CellBox> m_boxes, m_openings;  // by places in m_planes
};

}  // namespace chebnet
