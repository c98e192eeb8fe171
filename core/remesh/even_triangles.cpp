#include "remesh/even_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "base/error.h"

namespace chebnet {

namespace {

constexpr int k_rounds = 5;
// In lengths; between them lies what splitting and collapsing leave alone.
constexpr double k_longest = 4.0 / 3, k_shortest = 4.0 / 5;
// Edges that are shorter than the longest by less than this are split with it.
constexpr double k_step = 0.8;
// A triangle turns by less than this when an edge is collapsed or flipped: a cosine.
constexpr double k_least_cosine = 0.3;
// Twice the area of a triangle that has any, in lengths squared.
constexpr double k_least_area = 1e-6;
// An edge of the boundary is collapsed where the boundary turns by less: a cosine.
constexpr double k_straight_boundary = 0.9;
constexpr int k_inner_valence = 6, k_boundary_valence = 4;
// A surface long and thin enough to need more has hardly any area: cells are so small beside its edges.
constexpr std::size_t k_most_added_points = 500'000;

/// Triangles that are edited. Sides are numbered as in Surface; a triangle that is gone has vertices −1.
class Triangles {
public:
    Triangles(const Surface& surface, const SurfaceTree& tree, double length, const std::vector<bool>& creases)
        : m_tree(tree), m_length(length), m_is_crease(creases) {
        m_is_crease.resize(3 * static_cast<std::size_t>(surface.face_count()), false);
        m_from.assign(surface.triangles().reshaped().begin(), surface.triangles().reshaped().end());
        m_opposite.resize(m_from.size());
        m_first_side.resize(static_cast<std::size_t>(surface.vertex_count()));
        m_guess.resize(m_first_side.size());
        for (int s = 0; s < side_count(); ++s) {
            m_opposite[s] = surface.opposite(s);
            m_first_side[m_from[s]] = s;
            m_guess[m_from[s]] = Surface::face_of(s);
        }
        for (int v = 0; v < surface.vertex_count(); ++v) m_points.emplace_back(surface.positions().col(v));
        m_most_points = m_points.size() + k_most_added_points;
    }

    /// The longest first: shorter ones of thin triangles, split before, would leave edges as long as they were.
    void split_long_edges() {
        double longest = 0;
        for (int s = 0; s < side_count(); ++s)
            if (is_there(s)) longest = std::max(longest, edge(s).norm());
        while (longest > k_longest * m_length) {
            longest = std::max(longest * k_step, k_longest * m_length);
            const int sides = side_count();
            for (int s = 0; s < sides; ++s)
                if (is_there(s) && edge(s).norm() > longest) split(s);
        }
    }

    void collapse_short_edges() {
        for (int s = 0; s < side_count(); ++s)
            if (is_there(s) && edge(s).norm() < k_shortest * m_length && may_collapse(s)) collapse(s);
    }

    void flip_for_valence() {
        std::vector<int> valence(m_points.size(), 0);
        for (int s = 0; s < side_count(); ++s)
            if (is_there(s)) valence[m_from[s]] += m_opposite[previous(s)] < 0 ? 2 : 1;
        for (int s = 0; s < side_count(); ++s) {
            if (!is_there(s) || m_opposite[s] < 0) continue;
            const int t = m_opposite[s];
            const std::array<int, 4> ends{m_from[s], m_from[t], m_from[previous(s)], m_from[previous(t)]};
            int before = 0, after = 0;
            for (std::size_t k = 0; k < 4; ++k) {
                const int excess = valence[ends[k]] - (is_boundary(ends[k]) ? k_boundary_valence : k_inner_valence);
                const int next_excess = excess + (k < 2 ? -1 : 1);
                before += excess * excess;
                after += next_excess * next_excess;
            }
            if (after >= before || !may_flip(s)) continue;
            flip(s);
            for (std::size_t k = 0; k < 4; ++k) valence[ends[k]] += k < 2 ? -1 : 1;
        }
    }

    void relax() {
        const std::vector<Eigen::Vector3d> before = m_points;
        for (int v = 0; v < static_cast<int>(m_points.size()); ++v) {
            if (m_first_side[v] < 0 || is_boundary(v) || !creases_at(v).empty()) continue;
            Eigen::Vector3d sum = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
            int count = 0;
            for (const int s : sides_around(v)) {
                sum += before[to(s)];
                normal += (before[to(s)] - before[v]).cross(before[m_from[previous(s)]] - before[v]);
                ++count;
            }
            normal.stableNormalize();
            const Eigen::Vector3d move = sum / count - before[v];
            put_on_surface(v, before[v] + move - move.dot(normal) * normal);
        }
    }

    /// Of each side of mesh().
    std::vector<bool> creases() const {
        std::vector<bool> result;
        for (int s = 0; s < side_count(); ++s)
            if (is_there(s)) result.push_back(m_is_crease[s]);
        return result;
    }

    Mesh mesh() const {
        std::vector<int> number(m_points.size(), -1);
        Mesh mesh;
        std::vector<int> kept;
        for (std::size_t v = 0; v < m_points.size(); ++v) {
            if (m_first_side[v] < 0) continue;
            number[v] = static_cast<int>(kept.size());
            kept.push_back(static_cast<int>(v));
        }
        mesh.positions.resize(3, static_cast<Eigen::Index>(kept.size()));
        for (std::size_t k = 0; k < kept.size(); ++k)
            mesh.positions.col(static_cast<Eigen::Index>(k)) = m_points[kept[k]];
        for (int s = 0; s < side_count(); s += 3)
            if (is_there(s)) mesh.faces.add({number[m_from[s]], number[m_from[s + 1]], number[m_from[s + 2]]});
        return mesh;
    }

private:
    static int next(int side) { return Surface::next(side); }
    static int previous(int side) { return Surface::previous(side); }
    int side_count() const { return static_cast<int>(m_from.size()); }
    bool is_there(int side) const { return m_from[side] >= 0; }
    int to(int side) const { return m_from[next(side)]; }
    Eigen::Vector3d edge(int side) const { return m_points[to(side)] - m_points[m_from[side]]; }

    /// The sides that begin at a vertex, counterclockwise, from the boundary if it is there.
    std::vector<int> sides_around(int vertex) const {
        int first = m_first_side[vertex];
        while (m_opposite[first] >= 0) {
            first = next(m_opposite[first]);
            if (first == m_first_side[vertex]) break;
        }
        std::vector<int> sides;
        for (int s = first; s >= 0;) {
            sides.push_back(s);
            s = m_opposite[previous(s)];
            if (s == first) break;
        }
        return sides;
    }

    bool is_boundary(int vertex) const { return m_opposite[sides_around(vertex).front()] < 0; }

    /// The sides on creases that begin at a vertex.
    std::vector<int> creases_at(int vertex) const {
        std::vector<int> sides = sides_around(vertex);
        std::erase_if(sides, [this](int s) { return !m_is_crease[s]; });
        return sides;
    }

    std::vector<int> neighbours(int vertex) const {
        std::vector<int> vertices;
        for (const int s : sides_around(vertex)) {
            vertices.push_back(to(s));
            if (m_opposite[previous(s)] < 0) vertices.push_back(m_from[previous(s)]);
        }
        return vertices;
    }

    void join(int side, int other) {
        if (side >= 0) m_opposite[side] = other;
        if (other >= 0) m_opposite[other] = side;
    }

    int add_triangle(int a, int b, int c) {
        const int side = side_count();
        for (const int v : {a, b, c}) {
            m_from.push_back(v);
            m_opposite.push_back(-1);
            m_is_crease.push_back(false);
        }
        return side;
    }

    /// Triangle (a, b, c) of a side a–b becomes (a, m, c) and (m, b, c). Returns the latter's side m–b.
    int split_triangle(int side, int m) {
        const int beyond = m_opposite[next(side)];
        const int added = add_triangle(m, to(side), m_from[previous(side)]);
        m_from[next(side)] = m;
        m_is_crease[added] = m_is_crease[side];
        m_is_crease[next(added)] = m_is_crease[next(side)];
        m_is_crease[next(side)] = false;
        join(next(added), beyond);
        join(next(side), previous(added));
        m_first_side[m_from[next(added)]] = next(added);
        return added;
    }

    void split(int side) {
        if (m_points.size() == m_most_points)
            throw Error(ErrorCode::bad_option,
                        "the surface is long and so thin that cells of this size would be too many along it");
        const int m = static_cast<int>(m_points.size());
        const Eigen::Vector3d middle = (m_points[m_from[side]] + m_points[to(side)]) / 2;
        const bool is_inside = m_opposite[side] >= 0;
        m_points.push_back(middle);
        m_guess.push_back(m_guess[m_from[side]]);
        const int other = m_opposite[side];
        const int added = split_triangle(side, m);
        m_first_side.push_back(added);
        if (is_inside) {
            const int beyond = split_triangle(other, m);
            join(side, beyond);
            join(added, other);
            put_on_surface(m, middle);
        }
    }

    void put_on_surface(int vertex, const Eigen::Vector3d& point) {
        const SurfaceTree::Nearest nearest = m_tree.nearest(point, m_guess[vertex]);
        m_points[vertex] = nearest.position;
        m_guess[vertex] = nearest.at.face;
    }

    /// Of the vertex where the side begins into the one where it ends: neither topology nor shape may suffer.
    bool may_collapse(int side) const {
        const int a = m_from[side], b = to(side);
        const bool is_rim = m_opposite[side] < 0;
        if (is_boundary(a) && !is_rim) return false;
        if (is_rim && !is_straight_at(a)) return false;
        if (!is_free_along(a, side)) return false;
        std::vector<int> around_a = neighbours(a), around_b = neighbours(b);
        int common = 0;
        for (const int v : around_a) common += static_cast<int>(std::count(around_b.begin(), around_b.end(), v));
        if (common != (is_rim ? 1 : 2) || around_a.size() <= 3 || around_b.size() <= 3) return false;
        for (const int v : {m_from[previous(side)], is_rim ? -1 : m_from[previous(m_opposite[side])]})
            if (v >= 0 && neighbours(v).size() <= (is_boundary(v) ? 2u : 3u)) return false;
        for (const int v : around_a)
            if ((m_points[v] - m_points[b]).norm() > k_longest * m_length) return false;
        for (const int s : sides_around(a)) {
            const int p = to(s), q = m_from[previous(s)];
            if (p == b || q == b) continue;
            const Eigen::Vector3d before = (m_points[p] - m_points[a]).cross(m_points[q] - m_points[a]);
            const Eigen::Vector3d after = (m_points[p] - m_points[b]).cross(m_points[q] - m_points[b]);
            if (!(before.dot(after) > k_least_cosine * before.norm() * after.norm())) return false;
            if (has_area(before) && !has_area(after)) return false;
        }
        return true;
    }

    /// A vertex of a crease goes along that, where it is straight.
    bool is_free_along(int vertex, int side) const {
        const std::vector<int> creases = creases_at(vertex);
        if (creases.empty()) return true;
        if (creases.size() != 2 || !m_is_crease[side]) return false;
        const Eigen::Vector3d out = edge(creases[0]), back = edge(creases[1]);
        return -out.dot(back) > k_straight_boundary * out.norm() * back.norm();
    }

    bool is_straight_at(int vertex) const {
        const std::vector<int> sides = sides_around(vertex);
        const Eigen::Vector3d out = edge(sides.front()), in = edge(previous(sides.back()));
        return out.dot(in) > k_straight_boundary * out.norm() * in.norm();
    }

    /// Three vertices on one crease have none but by rounding.
    bool has_area(const Eigen::Vector3d& twice) const { return twice.norm() > k_least_area * m_length * m_length; }

    void collapse(int side) {
        const int a = m_from[side], b = to(side), other = m_opposite[side];
        for (const int s : sides_around(a)) m_from[s] = b;
        m_first_side[a] = -1;
        for (const int gone : {side, other}) {
            if (gone < 0) continue;
            const int left = m_opposite[next(gone)], right = m_opposite[previous(gone)];
            const int c = m_from[previous(gone)];
            const bool is_crease = m_is_crease[next(gone)] || m_is_crease[previous(gone)];
            join(left, right);
            for (const int s : {left, right})
                if (s >= 0) m_is_crease[s] = is_crease && left >= 0 && right >= 0;
            for (const int s : {gone, next(gone), previous(gone)}) m_from[s] = -1;
            // One of the two triangles at c's merged edge is there: a vertex keeps at least one.
            m_first_side[c] = left >= 0 ? left : next(right);
            m_first_side[b] = left >= 0 ? next(left) : right;
        }
    }

    bool may_flip(int side) const {
        const int other = m_opposite[side];
        if (m_is_crease[side]) return false;
        const int a = m_from[side], b = m_from[other], c = m_from[previous(side)], d = m_from[previous(other)];
        const std::vector<int> around = neighbours(c);
        if (c == d || std::find(around.begin(), around.end(), d) != around.end()) return false;
        if (neighbours(a).size() <= 3 || neighbours(b).size() <= 3) return false;
        const Eigen::Vector3d first = (m_points[b] - m_points[a]).cross(m_points[c] - m_points[a]);
        const Eigen::Vector3d second = (m_points[a] - m_points[b]).cross(m_points[d] - m_points[b]);
        const Eigen::Vector3d normal = first.stableNormalized() + second.stableNormalized();
        for (const auto& [p, q, r] : {std::array{c, a, d}, std::array{d, b, c}}) {
            const Eigen::Vector3d area = (m_points[q] - m_points[p]).cross(m_points[r] - m_points[p]);
            if (!(area.dot(normal) > 2 * k_least_cosine * area.norm())) return false;
            if (has_area(first) && has_area(second) && !has_area(area)) return false;
        }
        return true;
    }

    /// (a, b, c) and (b, a, d) become (c, a, d) and (d, b, c).
    void flip(int side) {
        const int other = m_opposite[side];
        const int a = m_from[side], b = m_from[other], c = m_from[previous(side)], d = m_from[previous(other)];
        const int bc = m_opposite[next(side)], ca = m_opposite[previous(side)];
        const int ad = m_opposite[next(other)], db = m_opposite[previous(other)];
        const bool is_bc = m_is_crease[next(side)], is_ca = m_is_crease[previous(side)];
        const bool is_ad = m_is_crease[next(other)], is_db = m_is_crease[previous(other)];
        m_is_crease[next(side)] = is_ca, m_is_crease[previous(side)] = is_ad;
        m_is_crease[next(other)] = is_db, m_is_crease[previous(other)] = is_bc;
        m_from[side] = d, m_from[next(side)] = c, m_from[previous(side)] = a;
        m_from[other] = c, m_from[next(other)] = d, m_from[previous(other)] = b;
        join(next(side), ca);
        join(previous(side), ad);
        join(next(other), db);
        join(previous(other), bc);
        m_first_side[a] = previous(side), m_first_side[c] = next(side);
        m_first_side[b] = previous(other), m_first_side[d] = next(other);
    }

    const SurfaceTree& m_tree;
    double m_length;
    std::size_t m_most_points;
    std::vector<Eigen::Vector3d> m_points;
    std::vector<int> m_from, m_opposite;  // of each side
    std::vector<bool> m_is_crease;        // of each side
    std::vector<int> m_first_side;        // of each vertex one that begins there; −1: the vertex is gone
    std::vector<int> m_guess;             // of each vertex a triangle of the surface near it
};

}  // namespace

EvenTriangles even_triangles(const Surface& surface, const SurfaceTree& tree, double length,
                             const std::vector<bool>& creases) {
    Triangles triangles(surface, tree, length, creases);
    for (int round = 0; round < k_rounds; ++round) {
        triangles.split_long_edges();
        triangles.collapse_short_edges();
        triangles.flip_for_valence();
        triangles.relax();
    }
    return {Surface(triangles.mesh()), triangles.creases()};
}

}  // namespace chebnet
