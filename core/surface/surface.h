#pragma once

#include <Eigen/Core>
#include <iterator>
#include <vector>

#include "net/mesh.h"
#include "net/net.h"
#include "net/repair.h"

namespace chebnet {

/// A place on a surface: in which triangle, and where there.
struct SurfacePoint {
    int face = -1;
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< barycentric: of the triangle's corners, ≥ 0, their sum 1
};

class SidesAround;

/// The largest coordinate: fourth powers of lengths stay finite, for which that of nets is too large.
inline constexpr double k_largest_surface = 1e50;

/// A surface of triangles, a manifold with or without boundary, on which nets are made. Immutable and sound: the
/// constructor refuses everything else.
///
/// Triangle f has the sides 3 f, 3 f + 1 and 3 f + 2; side 3 f + k goes from its corner k to the next, and all of them
/// run counterclockwise as seen from where the normals point to.
class Surface {
public:
    /// Polygons are cut (see triangulated). Vertices keep their numbers; where pieces touch at a vertex only, all but
    /// the first of them get a vertex of their own at its place, with a number behind those of the mesh.
    /// Throws Error: no_faces, small_face, index_out_of_range, repeated_vertex, non_finite, zero_length_edge, bad_scale
    /// (a size beyond k_largest_surface, or below its inverse), unused_vertex, non_manifold_edge (more than two faces
    /// at an edge, or two that wind against each other, as somewhere on every surface with one side only). Each message
    /// names face, vertex or edge of the mesh, from 0.
    explicit Surface(const Mesh& mesh);

    int vertex_count() const { return static_cast<int>(m_positions.cols()); }
    int face_count() const { return static_cast<int>(m_triangles.cols()); }
    const Positions& positions() const { return m_positions; }
    /// 3×F, the vertices of each triangle.
    const Eigen::Matrix3Xi& triangles() const { return m_triangles; }

    static int face_of(int side) { return side / 3; }
    static int next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
    static int previous(int side) { return side % 3 == 0 ? side + 2 : side - 1; }
    int from(int side) const { return m_triangles.reshaped()[side]; }
    int to(int side) const { return from(next(side)); }
    double length_of(int side) const;
    double length_of(const std::vector<int>& sides) const;  ///< together
    /// The corner from which a side goes.
    static SurfacePoint start_of(int side) { return {face_of(side), Eigen::Vector3d::Unit(side % 3)}; }
    /// The side of the neighbouring triangle that runs along the same edge the other way; −1 at the boundary.
    int opposite(int side) const { return m_opposite[side]; }
    /// A side that begins at a vertex: the first one counterclockwise, if the vertex is on the boundary.
    int first_side(int vertex) const { return m_first_side[vertex]; }
    /// The next side counterclockwise that begins where this one does; −1 behind the last at the boundary.
    int around(int side) const { return m_opposite[previous(side)]; }
    /// All that begin at a vertex, counterclockwise from its first_side(): `for (const int side : sides_around(v))`.
    SidesAround sides_around(int vertex) const;
    /// Those that begin where this one does, counterclockwise from it, once around or up to the boundary.
    SidesAround sides_from(int side) const;
    /// The triangles at a vertex, counterclockwise, from that of its first_side() on.
    std::vector<int> faces_around(int vertex) const;
    bool is_boundary(int vertex) const { return m_opposite[m_first_side[vertex]] < 0; }

    /// 3×F, unit vectors; zero where a triangle has no area.
    const Positions& face_normals() const { return m_face_normals; }
    /// 3×V, unit vectors by the weights of Max (1999), exact where the neighbours lie on a sphere; zero if no triangle
    /// at the vertex has area.
    const Positions& vertex_normals() const { return m_vertex_normals; }
    /// F, of each triangle.
    const Eigen::VectorXd& areas() const { return m_areas; }
    double area() const { return m_area; }

    /// Closed walks along the boundary, each the sides in their order; the surface is on their left.
    std::vector<std::vector<int>> boundary_loops() const;
    /// V − E + F: 2 for a sphere, 1 for a disc, 0 for a torus or a tube; of pieces the sum.
    int euler_characteristic() const;
    /// F, the number of the piece in which each triangle is: pieces count from 0, by their first triangles.
    std::vector<int> components() const;

    Eigen::Vector3d position_at(const SurfacePoint& point) const;
    /// The vertex normals, interpolated; of length 1, or zero.
    Eigen::Vector3d normal_at(const SurfacePoint& point) const;

private:
    void check(const Mesh& mesh) const;
    void cut(const Mesh& mesh);
    void find_opposites();
    void split_touching_pieces();
    void measure();

    Positions m_positions;
    Eigen::Matrix3Xi m_triangles;
    std::vector<int> m_opposite;    // of each side
    std::vector<int> m_first_side;  // of each vertex
    Positions m_face_normals, m_vertex_normals;
    Eigen::VectorXd m_areas;
    double m_area = 0;
};

/// See Surface::sides_around(). Refers to the surface, which must outlive it.
class SidesAround {
public:
    SidesAround(const Surface& surface, int first) : m_surface(surface), m_first(first) {}

    class Iterator {
    public:
        Iterator(const Surface& surface, int first) : m_surface(&surface), m_first(first), m_side(first) {}
        int operator*() const { return m_side; }
        Iterator& operator++() {
            m_side = m_surface->around(m_side);
            if (m_side == m_first) m_side = -1;
            return *this;
        }
        bool operator==(std::default_sentinel_t) const { return m_side < 0; }

    private:
        const Surface* m_surface;
        int m_first, m_side;  // −1: at the end
    };
    Iterator begin() const { return {m_surface, m_first}; }
    std::default_sentinel_t end() const { return {}; }

private:
    const Surface& m_surface;
    int m_first;
};

inline SidesAround Surface::sides_around(int vertex) const { return {*this, m_first_side[vertex]}; }
inline SidesAround Surface::sides_from(int side) const { return {*this, side}; }

/// The same in another unit: all lengths times `factor`. Throws Error bad_scale.
Surface scaled(const Surface& surface, double factor);

/// A surface from a file's mesh, and what was repaired for it.
struct RepairedSurface {
    Surface surface;
    std::vector<Finding> findings;
};

/// The mesh with its defects of the `chosen` kinds repaired (see repair) as a surface. No hole is filled. Throws Error
/// as both do.
RepairedSurface repaired_surface(Mesh mesh, const std::vector<Defect>& chosen);

}  // namespace chebnet
