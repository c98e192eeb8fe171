#include "surface/surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "net/triangulation.h"

namespace chebnet {

namespace {

std::string edge_text(int a, int b) { return "edge " + std::to_string(a) + "-" + std::to_string(b); }

void check_vertex(int face, int vertex, Eigen::Index count) {
    if (vertex < 0 || vertex >= count)
        throw Error(ErrorCode::index_out_of_range, "face " + std::to_string(face) + " names vertex " +
                                                       std::to_string(vertex) + ", but there are only " +
                                                       std::to_string(count));
}

void check_side(const Mesh& mesh, int face, int a, int b) {
    if (a == b)
        throw Error(ErrorCode::repeated_vertex,
                    "face " + std::to_string(face) + " names vertex " + std::to_string(a) + " twice");
    if (mesh.positions.col(a) == mesh.positions.col(b))
        throw Error(ErrorCode::zero_length_edge, "both ends of " + edge_text(a, b) + " are at the same place");
}

void check_size(const Positions& positions) {
    for (int v = 0; v < positions.cols(); ++v)
        if (!positions.col(v).allFinite())
            throw Error(ErrorCode::non_finite, "vertex " + std::to_string(v) + " has a coordinate that is not finite");
    const double size = (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).maxCoeff();
    if (!(positions.cwiseAbs().maxCoeff() <= k_largest_surface && size >= 1 / k_largest_surface))
        throw Error(ErrorCode::bad_scale, "the surface is too large or too small to be computed with: scale it");
}

Eigen::Vector3d unit_or_zero(const Eigen::Vector3d& vector) {
    const double norm = vector.stableNorm();
    return norm > 0 ? Eigen::Vector3d(vector / norm) : Eigen::Vector3d::Zero();
}

Faces faces_of(const Eigen::Matrix3Xi& triangles) {
    Faces faces;
    for (const auto& triangle : triangles.colwise()) faces.add({triangle[0], triangle[1], triangle[2]});
    return faces;
}

}  // namespace

Surface::Surface(const Mesh& mesh) : m_positions(mesh.positions) {
    check(mesh);
    cut(mesh);
    find_opposites();
    split_touching_pieces();
    measure();
}

void Surface::check(const Mesh& mesh) const {
    if (mesh.faces.size() == 0) throw Error(ErrorCode::no_faces, "the surface has no face");
    std::vector<bool> is_used(static_cast<std::size_t>(mesh.positions.cols()));
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const std::span<const int> face = mesh.faces[f];
        if (face.size() < 3)
            throw Error(ErrorCode::small_face, "face " + std::to_string(f) + " has fewer than three vertices");
        for (const int vertex : face) {
            check_vertex(f, vertex, mesh.positions.cols());
            is_used[vertex] = true;
        }
    }
    check_size(mesh.positions);
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const std::span<const int> face = mesh.faces[f];
        for (std::size_t k = 0; k < face.size(); ++k) check_side(mesh, f, face[k], face[(k + 1) % face.size()]);
    }
    const auto unused = std::find(is_used.begin(), is_used.end(), false);
    if (unused != is_used.end())
        throw Error(ErrorCode::unused_vertex,
                    "vertex " + std::to_string(unused - is_used.begin()) + " belongs to no face");
}

void Surface::cut(const Mesh& mesh) {
    const std::vector<Triangle> triangles = triangulated(mesh.positions, mesh.faces);
    m_triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    int t = 0;
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (std::size_t corner = 2; corner < mesh.faces[f].size(); ++corner, ++t) {
            const Triangle& triangle = triangles[t];
            for (int k = 0; k < 3; ++k) check_side(mesh, f, triangle[k], triangle[(k + 1) % 3]);
            m_triangles.col(t) << triangle[0], triangle[1], triangle[2];
        }
}

/// Sides of one edge are found among those whose lesser end is the same.
void Surface::find_opposites() {
    const int side_count = 3 * face_count();
    m_opposite.assign(static_cast<std::size_t>(side_count), -1);
    std::vector<int> start(static_cast<std::size_t>(vertex_count()) + 1), sides(m_opposite.size());
    const auto lesser = [this](int side) { return std::min(from(side), to(side)); };
    const auto greater = [this](int side) { return std::max(from(side), to(side)); };
    for (int side = 0; side < side_count; ++side) ++start[lesser(side) + 1];
    for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
    std::vector<int> end(start.begin(), start.end() - 1);
    for (int side = 0; side < side_count; ++side) sides[end[lesser(side)]++] = side;
    for (int v = 0; v < vertex_count(); ++v) {
        const auto first = sides.begin() + start[v], last = sides.begin() + start[v + 1];
        std::stable_sort(first, last, [&](int a, int b) { return greater(a) < greater(b); });
        for (auto side = first; side != last;) {
            const auto other = std::find_if(side, last, [&](int s) { return greater(s) != greater(*side); });
            if (other - side > 2)
                throw Error(ErrorCode::non_manifold_edge,
                            "more than two faces meet at " + edge_text(v, greater(*side)));
            if (other - side == 2 && from(side[0]) == from(side[1]))
                throw Error(ErrorCode::non_manifold_edge,
                            "the two faces at " + edge_text(v, greater(*side)) + " wind against each other, so that " +
                                (has_one_side(faces_of(m_triangles))
                                     ? "the surface has one side only, like a Möbius strip: cut it across"
                                     : "the surface has no outside there"));
            if (other - side == 2) m_opposite[side[0]] = side[1], m_opposite[side[1]] = side[0];
            side = other;
        }
    }
}

void Surface::split_touching_pieces() {
    m_first_side.assign(static_cast<std::size_t>(vertex_count()), -1);
    std::vector<bool> is_reached(m_opposite.size());
    std::vector<int> copied;  // the vertices that get another one, in order
    for (int side = 0; side < 3 * face_count(); ++side) {
        if (is_reached[side]) continue;
        int first = side;  // of all sides that can be reached from here around its vertex
        while (m_opposite[first] >= 0 && next(m_opposite[first]) != side) first = next(m_opposite[first]);
        if (m_opposite[first] >= 0) first = side;
        int vertex = from(side);
        if (m_first_side[vertex] >= 0) {
            copied.push_back(vertex);
            vertex = static_cast<int>(m_first_side.size());
            m_first_side.push_back(first);
        } else {
            m_first_side[vertex] = first;
        }
        for (int s = first; s >= 0 && !is_reached[s]; s = around(s)) {
            is_reached[s] = true;
            m_triangles.reshaped()[s] = vertex;
        }
    }
    const Eigen::Index count = m_positions.cols();
    m_positions.conservativeResize(3, count + static_cast<Eigen::Index>(copied.size()));
    for (std::size_t i = 0; i < copied.size(); ++i)
        m_positions.col(count + static_cast<Eigen::Index>(i)) = m_positions.col(copied[i]);
}

void Surface::measure() {
    m_face_normals.resize(3, face_count());
    m_vertex_normals.setZero(3, vertex_count());
    m_areas.resize(face_count());
    for (int f = 0; f < face_count(); ++f) {
        const Eigen::Vector3i t = m_triangles.col(f);
        const Eigen::Vector3d vector = area_vector(m_positions, {t[0], t[1], t[2]});
        m_face_normals.col(f) = unit_or_zero(vector);
        m_areas[f] = vector.stableNorm() / 2;
        Eigen::Vector3d squares;  // of the sides
        for (int k = 0; k < 3; ++k)
            squares[k] = (m_positions.col(t[(k + 1) % 3]) - m_positions.col(t[k])).squaredNorm();
        // Side × side / (squares of both), Max: Weights for computing vertex normals from facet normals, 1999.
        for (int k = 0; k < 3; ++k)
            m_vertex_normals.col(t[k]) += m_face_normals.col(f) * (m_areas[f] / squares[k] / squares[(k + 2) % 3]);
    }
    m_area = m_areas.sum();
    for (int v = 0; v < vertex_count(); ++v) m_vertex_normals.col(v) = unit_or_zero(m_vertex_normals.col(v));
}

std::vector<int> Surface::faces_around(int vertex) const {
    std::vector<int> faces;
    for (const int side : sides_around(vertex)) faces.push_back(face_of(side));
    return faces;
}

double Surface::length_of(int side) const { return (m_positions.col(to(side)) - m_positions.col(from(side))).norm(); }

double Surface::length_of(const std::vector<int>& sides) const {
    double length = 0;
    for (const int side : sides) length += length_of(side);
    return length;
}

std::vector<std::vector<int>> Surface::boundary_loops() const {
    std::vector<std::vector<int>> loops;
    std::vector<bool> is_reached(m_opposite.size());
    for (int first = 0; first < 3 * face_count(); ++first) {
        if (m_opposite[first] >= 0 || is_reached[first]) continue;
        std::vector<int>& loop = loops.emplace_back();
        for (int side = first; !is_reached[side]; side = m_first_side[to(side)]) {
            is_reached[side] = true;
            loop.push_back(side);
        }
    }
    return loops;
}

int Surface::euler_characteristic() const {
    int edges = 0;
    for (int s = 0; s < 3 * face_count(); ++s) edges += opposite(s) < s ? 1 : 0;
    return vertex_count() - edges + face_count();
}

std::vector<int> Surface::components() const {
    std::vector<int> component(static_cast<std::size_t>(face_count()), -1);
    int count = 0;
    for (int first = 0; first < face_count(); ++first) {
        if (component[first] >= 0) continue;
        std::vector<int> waiting{first};
        component[first] = count;
        while (!waiting.empty()) {
            const int f = waiting.back();
            waiting.pop_back();
            for (int side = 3 * f; side < 3 * f + 3; ++side) {
                if (m_opposite[side] < 0) continue;
                const int neighbour = face_of(m_opposite[side]);
                if (component[neighbour] >= 0) continue;
                component[neighbour] = count;
                waiting.push_back(neighbour);
            }
        }
        ++count;
    }
    return component;
}

Eigen::Vector3d Surface::position_at(const SurfacePoint& point) const {
    const Eigen::Vector3i t = m_triangles.col(point.face);
    return point.weights[0] * m_positions.col(t[0]) + point.weights[1] * m_positions.col(t[1]) +
           point.weights[2] * m_positions.col(t[2]);
}

Eigen::Vector3d Surface::normal_at(const SurfacePoint& point) const {
    const Eigen::Vector3i t = m_triangles.col(point.face);
    return unit_or_zero(point.weights[0] * m_vertex_normals.col(t[0]) + point.weights[1] * m_vertex_normals.col(t[1]) +
                        point.weights[2] * m_vertex_normals.col(t[2]));
}

Surface scaled(const Surface& surface, double factor) {
    Faces faces;
    for (const auto& t : surface.triangles().colwise()) faces.add({t[0], t[1], t[2]});
    return Surface({factor * surface.positions(), std::move(faces)});
}

RepairedSurface repaired_surface(Mesh mesh, const std::vector<Defect>& chosen) {
    RepairedMesh repaired = repair(std::move(mesh), chosen);
    return {Surface(repaired.mesh), std::move(repaired.findings)};
}

}  // namespace chebnet
