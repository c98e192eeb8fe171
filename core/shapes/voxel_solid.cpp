#include "shapes/voxel_solid.h"

#include <array>
#include <map>
#include <utility>

namespace chebnet {

namespace {

using Point = Eigen::Vector3i;

/// The eight cells about a lattice point are its octants 0 … 7: bit `axis` is set in those above the point.
bool contains(unsigned octants, int octant) { return octants >> octant & 1; }

/// Whether a chain of octants, each sharing a square with the next, leads from one to the other.
bool are_joined(unsigned octants, int from, int to) {
    unsigned reached = 1u << from;
    for (unsigned before = 0; before != reached;) {
        before = reached;
        for (int octant = 0; octant < 8; ++octant)
            for (int axis = 0; contains(before, octant) && axis < 3; ++axis)
                reached |= octants & 1u << (octant ^ 1 << axis);
    }
    return contains(reached, to);
}

/// The corner at a lattice point of the square that closes `octant` along `axis`.
struct Corner {
    int octant, axis;
    int index() const { return 3 * octant + axis; }
};
constexpr int k_corner_count = 24;
constexpr int k_none = -1;

class BoundaryBuilder {
public:
    explicit BoundaryBuilder(const VoxelSolid& solid) : m_solid(solid) {}

    Mesh build() {
        for_each_face(m_solid, [this](const Point& cell, int axis, int side) { add_face(cell, axis, side); });
        return {Eigen::Map<const Positions>(m_coordinates.data(), 3, vertex_count()), std::move(m_faces)};
    }

private:
    using CornerVertices = std::array<int, k_corner_count>;

    void add_face(const Point& cell, int axis, int side) {
        const Point u = Point::Unit((axis + 1) % 3), v = Point::Unit((axis + 2) % 3);
        const Point origin = cell + side * Point::Unit(axis);
        const int a = vertex(origin, cell, axis), b = vertex(origin + u, cell, axis),
                  c = vertex(origin + u + v, cell, axis), d = vertex(origin + v, cell, axis);
        if (side == 1)
            m_faces.add({a, b, c, d});
        else
            m_faces.add({a, d, c, b});
    }

    /// The vertex at `point` of the square that closes `cell` along `axis`.
    int vertex(const Point& point, const Point& cell, int axis) {
        const auto [corners, is_new] = m_corners.try_emplace(place_of(point));
        if (is_new) corners->second = make_vertices(point);
        const Point above = cell - point + Point::Ones();
        return corners->second[Corner{above.x() | above.y() << 1 | above.z() << 2, axis}.index()];
    }

    /// One new vertex for each fan of squares about `point`.
    CornerVertices make_vertices(const Point& point) {
        CornerVertices vertices;
        vertices.fill(k_none);
        const unsigned octants = octants_about(point);
        for (int octant = 0; octant < 8; ++octant)
            for (int axis = 0; axis < 3; ++axis) {
                const Corner corner{octant, axis};
                const bool is_closed = contains(octants, octant) && !contains(octants, octant ^ 1 << axis);
                if (!is_closed || vertices[corner.index()] != k_none) continue;
                give_fan(corner, vertex_count(), point, octants, vertices);
                m_coordinates.insert(m_coordinates.end(), {1.0 * point.x(), 1.0 * point.y(), 1.0 * point.z()});
            }
        return vertices;
    }

    void give_fan(Corner corner, int new_vertex, const Point& point, unsigned octants, CornerVertices& vertices) const {
        if (vertices[corner.index()] == new_vertex) return;
        vertices[corner.index()] = new_vertex;
        for (const int turn : {1, 2})
            give_fan(next_in_fan(corner, (corner.axis + turn) % 3, point, octants), new_vertex, point, octants,
                     vertices);
    }

    /// The corner that follows where the square of `corner` ends towards `axis`.
    Corner next_in_fan(Corner corner, int axis, const Point& point, unsigned octants) const {
        const int beside = corner.octant ^ 1 << axis;
        const int across = beside ^ 1 << corner.axis;
        if (!contains(octants, across))
            return contains(octants, beside) ? Corner{beside, corner.axis} : Corner{corner.octant, axis};
        const bool goes_over =
            contains(octants, beside) || edge_joins(corner.octant, across, 3 - corner.axis - axis, point, octants);
        return goes_over ? Corner{across, axis} : Corner{corner.octant, axis};
    }

    /// Whether the edge that leaves `point` along `axis`, in which only the cubes a and b touch, joins them.
    bool edge_joins(int a, int b, int axis, const Point& point, unsigned octants) const {
        const int towards_end = contains(static_cast<unsigned>(a), axis) ? 1 : -1;
        const unsigned end_octants = octants_about(point + towards_end * Point::Unit(axis));
        return are_joined(octants, a, b) && are_joined(end_octants, a ^ 1 << axis, b ^ 1 << axis);
    }

    unsigned octants_about(const Point& point) const {
        unsigned octants = 0;
        for (int octant = 0; octant < 8; ++octant) {
            const Point above(octant & 1, octant >> 1 & 1, octant >> 2);
            if (m_solid.filled(point - Point::Ones() + above)) octants |= 1u << octant;
        }
        return octants;
    }

    int place_of(const Point& point) const {
        const Point place = point - m_solid.low(), extent = m_solid.high() - m_solid.low() + Point::Ones();
        return (place.z() * extent.y() + place.y()) * extent.x() + place.x();
    }
    int vertex_count() const { return static_cast<int>(m_coordinates.size() / 3); }

    const VoxelSolid& m_solid;
    std::map<int, CornerVertices> m_corners;  // at the lattice points of the boundary
    std::vector<double> m_coordinates;
    Faces m_faces;
};

}  // namespace

VoxelSolid::VoxelSolid(const Eigen::Vector3i& low, const Eigen::Vector3i& high)
    : m_low(low), m_high(high), m_filled((high - low).prod(), false) {}

bool VoxelSolid::filled(const Eigen::Vector3i& cell) const {
    const bool inside = (cell.array() >= m_low.array()).all() && (cell.array() < m_high.array()).all();
    return inside && m_filled[index(cell)];
}

void VoxelSolid::fill(const Eigen::Vector3i& low, const Eigen::Vector3i& high) {
    Point cell;
    for (cell.z() = low.z(); cell.z() < high.z(); ++cell.z())
        for (cell.y() = low.y(); cell.y() < high.y(); ++cell.y())
            for (cell.x() = low.x(); cell.x() < high.x(); ++cell.x()) m_filled[index(cell)] = true;
}

std::size_t VoxelSolid::index(const Eigen::Vector3i& cell) const {
    const Point place = cell - m_low, size = m_high - m_low;
    return (static_cast<std::size_t>(place.z()) * size.y() + place.y()) * size.x() + place.x();
}

Mesh boundary_surface(const VoxelSolid& solid) { return BoundaryBuilder(solid).build(); }

}  // namespace chebnet
