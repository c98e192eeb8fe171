#include "shapes/box_figure.h"

#include <utility>
#include <vector>

#include "shapes/block_lattice.h"
#include "shapes/family.h"
#include "shapes/voxel_solid.h"

namespace chebnet {

Shape make_box_figure(std::span<const Box> boxes, double vertices, std::span<const Eigen::Vector3d> handles) {
    const Placement placement = place_for(boxes, {}, vertices);
    Mesh surface = boundary_surface(union_of(cells_of(boxes, placement)));
    const std::vector<int> handle_vertices = nearest_vertices(surface.positions, handles, placement);
    return {place_net(std::move(surface)), handle_vertices};
}

}  // namespace chebnet
