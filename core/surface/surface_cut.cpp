#include "surface/surface_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "base/error.h"
#include "surface/surface_path.h"
#include "surface/surface_point.h"

namespace chebnet {

namespace {

constexpr double k_far = 0.05;   // of the surface's size: a point that far off is not meant to be on it
constexpr double k_snap = 1e-3;  // of an edge: nearer to its end a cut goes through that

constexpr double k_at_border = 0.01;  // likewise: an end of a cut that near to the border is meant to be on it

using Corners = std::array<int, 3>;
using Edge = std::pair<int, int>;  // its lesser vertex first
using Edges = std::set<Edge>;

Edge edge_of(int a, int b) { return std::minmax(a, b); }

double extent(const Surface& surface) {
    return (surface.positions().rowwise().maxCoeff() - surface.positions().rowwise().minCoeff()).norm();
}

[[noreturn]] void refuse(const std::string& what) { throw Error(ErrorCode::bad_option, what); }

/// Of a point in the plane of a triangle with some normal, for its corners; those beyond a side are negative.
Eigen::Vector3d plane_weights(const Eigen::Matrix3d& corners, const Eigen::Vector3d& point,
                              const Eigen::Vector3d& normal) {
    Eigen::Vector3d weights;
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d a = corners.col((k + 1) % 3), b = corners.col((k + 2) % 3);
        weights[k] = (b - a).cross(point - a).dot(normal);
    }
    return weights / weights.sum();
}

/// A surface whose triangles are split while a cut goes through them. The parts of a triangle lie in its plane, and
/// wind as it does.
class Refined {
public:
    /// `name`: of the cut, for errors.
    Refined(const Surface& surface, std::string name) : m_surface(surface), m_name(std::move(name)) {
        for (const auto& position : surface.positions().colwise()) m_positions.emplace_back(position);
    }

    /// The vertex at a snapped point of the surface, set there if there is none.
    int vertex_at(const SurfacePoint& point) {
        std::vector<int> corners;
        for (int k = 0; k < 3; ++k)
            if (point.weights[k] > 0) corners.push_back(m_surface.triangles()(k, point.face));
        if (corners.size() == 1) return corners[0];
        if (corners.size() == 3) return vertex_inside(point.face, m_surface.position_at(point));
        int across = 0;
        point.weights.minCoeff(&across);
        const int side = Surface::next(3 * point.face + across);
        return vertex_on(side, point.weights[Surface::next(side) % 3]);
    }

    /// Cuts straight from one vertex to another in a triangle's plane, setting vertices where parts of it are crossed.
    void cut(int face, int from, int to) {
        while (from != to) {
            const int next = step_towards(face, from, to);
            if (!m_cut.insert(edge_of(from, next)).second) refuse_crossing();
            if (!m_passed.insert(next).second) refuse_crossing();
            from = next;
        }
    }

    bool has_cut() const { return !m_cut.empty(); }

    /// The edges of the cut, and what has become of those of cuts before it.
    Edges edges(const Edges& before) const {
        Edges edges = m_cut;
        for (const Edge& edge : before) {
            const auto split = m_on_edge.find(edge);
            if (split == m_on_edge.end()) {
                edges.insert(edge);
                continue;
            }
            for (auto vertex = split->second.begin(); std::next(vertex) != split->second.end(); ++vertex)
                edges.insert(edge_of(vertex->second, std::next(vertex)->second));
        }
        return edges;
    }

    Mesh mesh() const {
        Mesh mesh{Positions(3, std::ssize(m_positions)), {}};
        for (Eigen::Index v = 0; v < mesh.positions.cols(); ++v)
            mesh.positions.col(v) = m_positions[static_cast<std::size_t>(v)];
        for (int f = 0; f < m_surface.face_count(); ++f) {
            const auto parts = m_parts.find(f);
            if (parts == m_parts.end())
                mesh.faces.add(corners_of(f));
            else
                for (const Corners& part : parts->second) mesh.faces.add(part);
        }
        return mesh;
    }

    /// The triangle of the surface that each of the mesh is a part of.
    std::vector<int> parents() const {
        std::vector<int> parents;
        for (int f = 0; f < m_surface.face_count(); ++f) {
            const auto parts = m_parts.find(f);
            parents.insert(parents.end(), parts == m_parts.end() ? 1 : parts->second.size(), f);
        }
        return parents;
    }

private:
    Corners corners_of(int face) const {
        const Eigen::Vector3i corners = m_surface.triangles().col(face);
        return {corners[0], corners[1], corners[2]};
    }
    std::vector<Corners>& parts_of(int face) { return m_parts.try_emplace(face, 1, corners_of(face)).first->second; }

    int add(const Eigen::Vector3d& position) {
        m_positions.push_back(position);
        return static_cast<int>(m_positions.size()) - 1;
    }

    /// On a side of a triangle at a part of its length.
    int vertex_on(int side, double part) {
        const int a = m_surface.from(side), b = m_surface.to(side);
        std::map<double, int>& on_edge = m_on_edge[edge_of(a, b)];
        if (on_edge.empty()) on_edge = {{0, std::min(a, b)}, {1, std::max(a, b)}};
        const auto after = on_edge.upper_bound(a < b ? part : 1 - part);
        const auto before = std::prev(after);
        const double here = a < b ? part : 1 - part;
        for (const auto& near : {before, after})
            if (std::abs(near->first - here) < k_snap) return near->second;
        const int vertex = add((1 - here) * m_surface.positions().col(std::min(a, b)) +
                               here * m_surface.positions().col(std::max(a, b)));
        split(Surface::face_of(side), before->second, after->second, vertex);
        if (m_surface.opposite(side) >= 0)
            split(Surface::face_of(m_surface.opposite(side)), before->second, after->second, vertex);
        on_edge.emplace(here, vertex);
        return vertex;
    }

    /// The parts of a triangle at the edge a-b.
    void split(int face, int a, int b, int vertex) {
        if (m_cut.contains(edge_of(a, b))) refuse_crossing();
        std::vector<Corners> parts;
        for (const Corners& part : parts_of(face)) {
            const auto has = [&](int v) { return std::find(part.begin(), part.end(), v) != part.end(); };
            if (!has(a) || !has(b)) {
                parts.push_back(part);
                continue;
            }
            for (const int end : {a, b}) {
                Corners half = part;
                std::replace(half.begin(), half.end(), end, vertex);
                parts.push_back(half);
            }
        }
        m_parts[face] = parts;
    }

    int vertex_inside(int face, const Eigen::Vector3d& position) {
        std::vector<Corners>& parts = parts_of(face);
        std::size_t around = 0;
        Eigen::Vector3d weights = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());
        for (std::size_t p = 0; p < parts.size(); ++p) {
            Eigen::Matrix3d corners;
            for (int k = 0; k < 3; ++k) corners.col(k) = m_positions[parts[p][k]];
            const Eigen::Vector3d here = plane_weights(corners, position, m_surface.face_normals().col(face));
            if (here.minCoeff() > weights.minCoeff()) weights = here, around = p;
        }
        const Corners part = parts[around];
        const Eigen::Vector3d near = snapped({face, weights.cwiseMax(0)}).weights;
        const int zeros = static_cast<int>((near.array() == 0).count());
        int k = 0;
        if (zeros == 2) {
            near.maxCoeff(&k);
            return part[k];
        }
        const int vertex = add(position);
        if (zeros == 1) {
            near.minCoeff(&k);
            split(face, part[(k + 1) % 3], part[(k + 2) % 3], vertex);
            return vertex;
        }
        parts[around] = {part[0], part[1], vertex};
        parts.push_back({part[1], part[2], vertex});
        parts.push_back({part[2], part[0], vertex});
        return vertex;
    }

    /// One step on: to a vertex that is joined to `from`, or set on the edge between two such.
    int step_towards(int face, int from, int to) {
        const Eigen::Vector3d normal = m_surface.face_normals().col(face);
        const Eigen::Vector3d way = m_positions[to] - m_positions[from];
        const auto beside = [&](int v) { return way.cross(m_positions[v] - m_positions[from]).dot(normal); };
        int right = to, left = to;
        double clearest = -std::numeric_limits<double>::infinity();
        for (const Corners& part : parts_of(face)) {
            const auto here = std::find(part.begin(), part.end(), from);
            if (here == part.end()) continue;
            const auto k = static_cast<std::size_t>(here - part.begin());
            const int a = part[(k + 1) % 3], b = part[(k + 2) % 3];
            if (a == to || b == to) return to;
            // The way leads between a and b if a is on its right, b on its left.
            const double clear = std::min(-beside(a), beside(b));
            if (clear > clearest) clearest = clear, right = a, left = b;
        }
        const double part = std::clamp(beside(right) / (beside(right) - beside(left)), 0.0, 1.0);
        if (!(part > k_snap)) return right;
        if (part > 1 - k_snap) return left;
        const int vertex = add((1 - part) * m_positions[right] + part * m_positions[left]);
        split(face, right, left, vertex);
        return vertex;
    }

    [[noreturn]] void refuse_crossing() const {
        refuse(m_name + " crosses or touches itself: draw it in several parts");
    }

    const Surface& m_surface;
    std::string m_name;
    std::vector<Eigen::Vector3d> m_positions;
    std::map<int, std::vector<Corners>> m_parts;      // of triangles that are split
    std::map<Edge, std::map<double, int>> m_on_edge;  // of edges that are split: vertices by parts of the length
    Edges m_cut;
    std::set<int> m_passed;  // vertices of the cut but for its first, which it may end at
};

// ------------------------------------------------------------------------------------------------- the way of a cut

void check_points(const Surface& surface, const CutLine& line, const std::string& name) {
    if (line.size() < 2) refuse(name + " needs at least two points");
    for (std::size_t k = 0; k < line.size(); ++k)
        if (line[k].face < 0 || line[k].face >= surface.face_count() || !(line[k].weights.minCoeff() >= 0) ||
            !(std::abs(line[k].weights.sum() - 1) < 1e-9))
            refuse("point " + std::to_string(k + 1) + " of " + name + " is not on the surface");
}

/// All paths of a cut, one behind the other.
SurfacePath path_of(const Surface& surface, const CutLine& line, const std::string& name) {
    SurfacePath path{{snapped(line[0])}, {}, 0};
    for (std::size_t k = 1; k < line.size(); ++k) {
        const SurfacePath next = shortest_path(surface, line[k - 1], line[k]);
        if (next.points.empty())
            refuse("points " + std::to_string(k) + " and " + std::to_string(k + 1) + " of " + name +
                   " are on different pieces of the surface");
        path.points.insert(path.points.end(), next.points.begin() + 1, next.points.end());
        path.faces.insert(path.faces.end(), next.faces.begin(), next.faces.end());
        path.length += next.length;
    }
    return path;
}

/// A path within one triangle gets a point in its middle: an edge between two inner vertices cannot be opened.
void halve_if_single(const Surface& surface, SurfacePath& path) {
    if (path.points.size() != 2) return;
    const int face = path.faces[0];
    const Eigen::Vector3d weights =
        *weights_in(surface, path.points[0], face) + *weights_in(surface, path.points[1], face);
    path.points.insert(path.points.begin() + 1, {face, weights / 2});
    path.faces.push_back(face);
}

void cut_along(Refined& refined, const SurfacePath& path) {
    int here = refined.vertex_at(path.points[0]);
    for (std::size_t k = 0; k < path.faces.size(); ++k) {
        const int next = refined.vertex_at(path.points[k + 1]);
        refined.cut(path.faces[k], here, next);
        here = next;
    }
}

/// A surface split along cuts, not yet opened.
struct Split {
    Surface surface;
    std::vector<int> parents;  // of each triangle, that of the surface that was given; never falling
    Edges edges;               // to be opened
};

/// Where a point of the surface that was given is now.
SurfacePoint found_in(const Split& split, const Surface& surface, const SurfacePoint& point) {
    const auto [first, last] = std::equal_range(split.parents.begin(), split.parents.end(), point.face);
    const Eigen::Vector3d position = surface.position_at(point), normal = surface.face_normals().col(point.face);
    SurfacePoint best{-1, Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity())};
    for (auto parent = first; parent != last; ++parent) {
        const int face = static_cast<int>(parent - split.parents.begin());
        const Eigen::Vector3d weights =
            plane_weights(split.surface.positions()(Eigen::all, split.surface.triangles().col(face)), position, normal);
        if (best.face < 0 || weights.minCoeff() > best.weights.minCoeff()) best = {face, weights};
    }
    if (last - first == 1) return {best.face, point.weights};
    best.weights = best.weights.cwiseMax(0);
    best.weights /= best.weights.sum();
    return best;
}

/// Each cut goes over what those before it have split, but not opened: so cuts can cross.
Split split_along(const Split& split, const Surface& surface, const CutLine& line, const std::string& name) {
    check_points(surface, line, name);
    CutLine here;
    for (const SurfacePoint& point : line) here.push_back(found_in(split, surface, point));
    SurfacePath path = path_of(split.surface, here, name);
    halve_if_single(split.surface, path);
    Refined refined(split.surface, name);
    cut_along(refined, path);
    if (!refined.has_cut()) refuse(name + " has no length");
    std::vector<int> parents = refined.parents();
    for (int& parent : parents) parent = split.parents[parent];
    return {Surface(refined.mesh()), parents, refined.edges(split.edges)};
}

Split split_along(const Surface& surface, std::span<const CutLine> lines, const std::string& name) {
    std::vector<int> parents(static_cast<std::size_t>(surface.face_count()));
    std::iota(parents.begin(), parents.end(), 0);
    Split split{surface, parents, {}};
    for (std::size_t k = 0; k < lines.size(); ++k)
        split = split_along(split, surface, lines[k], name + " " + std::to_string(k + 1));
    return split;
}

// --------------------------------------------------------------------------------------------------------- opening

/// Doubles the vertices of a mesh along edges: around each vertex, the corners between two of them share one.
Mesh opened(const Surface& surface, const Edges& edges) {
    Mesh mesh{surface.positions(), {}};
    std::vector<Eigen::Vector3d> added;
    Eigen::Matrix3Xi triangles = surface.triangles();
    const auto is_cut = [&](int side) { return edges.contains(edge_of(surface.from(side), surface.to(side))); };
    std::set<int> vertices;
    for (const auto& [a, b] : edges) vertices.insert({a, b});
    for (const int vertex : vertices) {
        int first = surface.first_side(vertex);
        if (!surface.is_boundary(vertex))
            while (!is_cut(first)) first = surface.around(first);
        int number = vertex;
        for (const int side : surface.sides_from(first)) {
            if (side != first && is_cut(side)) {
                number = static_cast<int>(mesh.positions.cols() + std::ssize(added));
                added.emplace_back(mesh.positions.col(vertex));
            }
            triangles.reshaped()[side] = number;
        }
    }
    const Eigen::Index count = mesh.positions.cols();
    mesh.positions.conservativeResize(3, count + std::ssize(added));
    for (std::size_t k = 0; k < added.size(); ++k) mesh.positions.col(count + static_cast<Eigen::Index>(k)) = added[k];
    for (const auto& triangle : triangles.colwise()) mesh.faces.add({triangle[0], triangle[1], triangle[2]});
    return mesh;
}

/// The point nearest to another on the border of one piece, as Surface::components() counts them; a number below 0 as
/// its face if that has no border.
SurfacePoint nearest_on_border(const Surface& surface, const std::vector<int>& pieces, int piece,
                               const Eigen::Vector3d& point) {
    SurfacePoint best;
    double least = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 3 * surface.face_count(); ++side) {
        if (surface.opposite(side) >= 0 || pieces[Surface::face_of(side)] != piece) continue;
        const Eigen::Vector3d from = surface.positions().col(surface.from(side)),
                              along = surface.positions().col(surface.to(side)) - from;
        const double part = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
        const double distance = (from + part * along - point).norm();
        if (distance >= least) continue;
        least = distance;
        best = {Surface::face_of(side), Eigen::Vector3d::Zero()};
        best.weights[side % 3] = 1 - part;
        best.weights[Surface::next(side) % 3] = part;
    }
    return best;
}

}  // namespace

SurfacePoint point_meant(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& point,
                         const std::string& name) {
    if (!point.allFinite()) throw Error(ErrorCode::non_finite, name + " has a coordinate that is not finite");
    const SurfaceTree::Nearest nearest = tree.nearest(point);
    if (nearest.distance > k_far * extent(surface))
        refuse(name + " is " + std::to_string(nearest.distance) + " away from the surface");
    return nearest.at;
}

CutLine cut_line(const Surface& surface, const SurfaceTree& tree, const Positions& points, const std::string& name) {
    const double near = k_at_border * extent(surface);
    const std::vector<int> pieces = surface.components();
    CutLine line;
    for (Eigen::Index k = 0; k < points.cols(); ++k) {
        line.push_back(point_meant(surface, tree, points.col(k), "point " + std::to_string(k + 1) + " of " + name));
        if (k > 0 && k + 1 < points.cols()) continue;
        const Eigen::Vector3d here = surface.position_at(line.back());
        const SurfacePoint border = nearest_on_border(surface, pieces, pieces[line.back().face], here);
        if (border.face >= 0 && (surface.position_at(border) - here).norm() < near) line.back() = border;
    }
    return line;
}

Positions points_of(const Surface& surface, const CutLine& line) {
    Positions points(3, std::ssize(line));
    for (std::size_t k = 0; k < line.size(); ++k)
        points.col(static_cast<Eigen::Index>(k)) = surface.position_at(line[k]);
    return points;
}

Positions cut_path(const Surface& surface, const CutLine& line, const std::string& name) {
    check_points(surface, line, name);
    return points_of(surface, path_of(surface, line, name).points);
}

Surface cut_open(const Surface& surface, std::span<const CutLine> cuts) {
    const Split split = split_along(surface, cuts, "cut");
    return Surface(opened(split.surface, split.edges));
}

SurfaceWithLines with_lines(const Surface& surface, std::span<const CutLine> lines, const std::string& name) {
    const Split split = split_along(surface, lines, name);
    std::vector<bool> is_on_line;
    for (int s = 0; s < 3 * split.surface.face_count(); ++s)
        is_on_line.push_back(split.edges.contains(edge_of(split.surface.from(s), split.surface.to(s))));
    return {split.surface, is_on_line};
}

std::vector<int> facing_sides(const Surface& surface) {
    using Ends = std::array<double, 6>;
    const auto ends = [&](int from, int to) {
        const Eigen::Vector3d a = surface.positions().col(from), b = surface.positions().col(to);
        return Ends{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    };
    std::map<Ends, int> side_at;
    for (const std::vector<int>& loop : surface.boundary_loops())
        for (const int side : loop) side_at.emplace(ends(surface.from(side), surface.to(side)), side);
    std::vector<int> facing(3 * static_cast<std::size_t>(surface.face_count()), -1);
    for (const auto& [places, side] : side_at) {
        const auto found = side_at.find(ends(surface.to(side), surface.from(side)));
        if (found != side_at.end()) facing[side] = found->second;
    }
    return facing;
}

}  // namespace chebnet
