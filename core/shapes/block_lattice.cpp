#include "shapes/block_lattice.h"

#include <algorithm>
#include <utility>

namespace chebnet {

namespace {

using Point = Eigen::Vector3i;

/// Leaves out vertices without a face and numbers the others in the order of the faces.
Mesh tidied(const Positions& positions, Faces faces) {
    std::vector<int> number(static_cast<std::size_t>(positions.cols()), -1), kept;
    for (int& vertex : faces.vertices) {
        if (number[vertex] < 0) {
            number[vertex] = static_cast<int>(kept.size());
            kept.push_back(vertex);
        }
        vertex = number[vertex];
    }
    return {positions(Eigen::all, kept), std::move(faces)};
}

}  // namespace

VoxelSolid union_of(std::span<const CellBox> boxes) {
    Point low = boxes[0].low, high = boxes[0].high;
    for (const CellBox& box : boxes) {
        low = low.cwiseMin(box.low);
        high = high.cwiseMax(box.high);
    }
    VoxelSolid solid(low, high);
    for (const CellBox& box : boxes) solid.fill(box.low, box.high);
    return solid;
}

BlockLattice::BlockLattice(std::span<const CellBox> boxes, std::span<const CellBox> openings) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<int>& planes = m_planes[axis];
        for (const auto list : {boxes, openings})
            for (const CellBox& box : list) planes.insert(planes.end(), {box.low[axis], box.high[axis]});
        std::sort(planes.begin(), planes.end());
        planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    }
    m_boxes = places_of(boxes);
    m_openings = places_of(openings);
}

std::vector<CellBox> BlockLattice::places_of(std::span<const CellBox> boxes) const {
    const auto place = [this](const Point& point) {
        Point index;
        for (int axis = 0; axis < 3; ++axis) {
            const std::vector<int>& planes = m_planes[axis];
            index[axis] =
                static_cast<int>(std::lower_bound(planes.begin(), planes.end(), point[axis]) - planes.begin());
        }
        return index;
    };
    std::vector<CellBox> places;
    for (const CellBox& box : boxes) places.push_back({place(box.low), place(box.high)});
    return places;
}

bool BlockLattice::is_open(const Point& low, const Point& high) const {
    return std::any_of(m_openings.begin(), m_openings.end(), [&](const CellBox& opening) {
        return (low.array() >= opening.low.array()).all() && (high.array() <= opening.high.array()).all();
    });
}

/// A closed net of quads has as many vertices as faces, but for a few; the outline of an opening adds half its length.
double BlockLattice::vertex_count() const {
    double count = 0;
    for_each_face(union_of(m_boxes), [&](const Point& cell, int axis, int side) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const Point low = cell + side * Point::Unit(axis);
        if (is_open(low, low + Point::Unit(u) + Point::Unit(v))) return;
        const auto length = [&](int along) {
            return 1.0 * m_planes[along][cell[along] + 1] - m_planes[along][cell[along]];
        };
        count += length(u) * length(v);
    });
    for (const CellBox& opening : m_openings)
        for (int axis = 0; axis < 3; ++axis)
            count += m_planes[axis][opening.high[axis]] - m_planes[axis][opening.low[axis]];
    return count;
}

Mesh BlockLattice::surface() const {
    Mesh all = boundary_surface(union_of(m_boxes));
    const auto corner = [&all](int vertex) -> Point { return all.positions.col(vertex).cast<int>(); };
    Faces closed;
    for (int f = 0; f < all.faces.size(); ++f) {
        const auto face = all.faces[f];
        const Point a = corner(face[0]), b = corner(face[2]);
        if (!is_open(a.cwiseMin(b), a.cwiseMax(b))) closed.add(face);
    }
    for (int v = 0; v < all.positions.cols(); ++v) {
        const Point place = corner(v);
        for (int axis = 0; axis < 3; ++axis) all.positions(axis, v) = m_planes[axis][place[axis]];
    }
    return tidied(all.positions, std::move(closed));
}

}  // namespace chebnet
