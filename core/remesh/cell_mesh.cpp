#include "remesh/cell_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace chebnet {

namespace {

constexpr int k_most_rounds = 100;
// Cells at a vertex of a regular grid.
constexpr int k_inner_cells = 4, k_boundary_cells = 2;
constexpr int k_least_inner_cells = 3;
// Cells in a row that hang by one side at the border, or by none. What is longer is a narrow part of the surface.
constexpr int k_longest_tail = 2;

class CellMesh {
public:
    explicit CellMesh(const Cells& cells)
        : m_opposite(cells.opposite), m_piece(cells.pieces), m_is_there(static_cast<std::size_t>(cells.size()), true) {
        place_corners(cells);
    }

    Mesh run() {
        number_vertices();
        for (int round = 0; round < k_most_rounds && tidy(); ++round) number_vertices();
        for (int q = 0; q < static_cast<int>(m_is_there.size()); ++q)
            if (m_is_there[q]) cut_tail(q);
        leave_out_scraps();
        number_vertices();
        return mesh();
    }

private:
    struct Vertex {
        int cells = 0;
        bool is_boundary = false, is_touched = false;
        std::vector<int> neighbours;
    };

    static int next(int side) { return side % 4 == 3 ? side - 3 : side + 1; }
    static int previous(int side) { return side % 4 == 0 ? side + 3 : side - 1; }
    static int cell_of(int side) { return side / 4; }
    int side_count() const { return static_cast<int>(m_opposite.size()); }

    /// Where each cell would have its corners, by the ways to the centres of its neighbours.
    void place_corners(const Cells& cells) {
        m_corners.resize(3, 4 * cells.size());
        for (int q = 0; q < cells.size(); ++q) {
            std::array<Eigen::Vector3d, 4> ways;
            ways.fill(Eigen::Vector3d::Zero());
            std::array<bool, 4> has_way{};
            const Eigen::Vector3d centre = cells.centres.col(q);
            for (int k = 0; k < 4; ++k) {
                has_way[k] = cells.opposite[4 * q + k] >= 0;
                if (has_way[k]) ways[k] = (cells.centres.col(cell_of(cells.opposite[4 * q + k])) - centre) / 2;
            }
            for (int k = 0; k < 4; ++k)
                if (!has_way[k] && has_way[(k + 2) % 4]) ways[k] = -ways[(k + 2) % 4];
            for (int k = 0; k < 4; ++k)
                if (!has_way[k] && !has_way[(k + 2) % 4]) ways[k] = ways[(k + 1) % 4].cross(cells.normals.col(q));
            for (int k = 0; k < 4; ++k) m_corners.col(4 * q + k) = centre + ways[(k + 3) % 4] + ways[k];
        }
    }

    /// Of each side the vertex at which it begins.
    void number_vertices() {
        m_vertex.assign(m_opposite.size(), -1);
        m_vertices.clear();
        for (int s = 0; s < side_count(); ++s)
            if (m_is_there[cell_of(s)] && m_vertex[s] < 0) number_vertex(s);
        for (int s = 0; s < side_count(); ++s) {
            if (!m_is_there[cell_of(s)]) continue;
            m_vertices[m_vertex[s]].neighbours.push_back(m_vertex[next(s)]);
            if (m_opposite[s] < 0) m_vertices[m_vertex[next(s)]].neighbours.push_back(m_vertex[s]);
        }
    }

    void number_vertex(int side) {
        int first = side;
        while (m_opposite[first] >= 0) {
            first = next(m_opposite[first]);
            if (first == side) break;
        }
        Vertex vertex;
        vertex.is_boundary = m_opposite[first] < 0;
        for (int s = first; s >= 0;) {
            m_vertex[s] = static_cast<int>(m_vertices.size());
            ++vertex.cells;
            s = m_opposite[previous(s)];
            if (s == first) break;
        }
        m_vertices.push_back(std::move(vertex));
    }

    /// False if nothing is left to collapse.
    bool tidy() {
        bool has_changed = false;
        for (int q = 0; q < static_cast<int>(m_is_there.size()); ++q) {
            if (!m_is_there[q] || is_touched(q)) continue;
            int best = -1, most = 0;
            for (int k = 0; k < 4; ++k) {
                const int gain = gain_of_collapse(4 * q + k);
                if (gain > most) best = 4 * q + k, most = gain;
            }
            if (best < 0) continue;
            for (int s = 4 * q; s < 4 * q + 4; ++s) m_vertices[m_vertex[s]].is_touched = true;
            collapse(best);
            has_changed = true;
        }
        return has_changed;
    }

    bool is_touched(int q) const {
        return std::any_of(m_vertex.begin() + 4 * q, m_vertex.begin() + 4 * q + 4,
                           [&](int v) { return m_vertices[v].is_touched; });
    }

    static int irregularity(int cells, bool is_boundary) {
        const int excess = cells - (is_boundary ? k_boundary_cells : k_inner_cells);
        return excess * excess;
    }

    /// By how much vertices become more regular if the vertex where the side begins falls together with the one across.
    int gain_of_collapse(int side) const {
        constexpr int k_necessary = 1000;
        const std::array<int, 4> corners{m_vertex[side], m_vertex[next(side)], m_vertex[next(next(side))],
                                         m_vertex[previous(side)]};
        const Vertex &a = m_vertices[corners[0]], &b = m_vertices[corners[1]], &c = m_vertices[corners[2]],
                     &d = m_vertices[corners[3]];
        if (corners[0] == corners[2] || corners[1] == corners[3]) return 0;
        if (a.is_boundary && c.is_boundary) return 0;
        if (!a.is_boundary && a.cells < k_least_inner_cells) return k_necessary;
        for (const Vertex* v : {&b, &d})
            if (v->cells <= (v->is_boundary ? 1 : k_least_inner_cells)) return 0;
        for (const int v : a.neighbours)
            if (v == corners[2] || (v != corners[1] && v != corners[3] &&
                                    std::find(c.neighbours.begin(), c.neighbours.end(), v) != c.neighbours.end()))
                return 0;
        int gain = -irregularity(a.cells + c.cells - 2, a.is_boundary || c.is_boundary);
        for (const Vertex* v : {&a, &b, &c, &d}) gain += irregularity(v->cells, v->is_boundary);
        for (const Vertex* v : {&b, &d}) gain -= irregularity(v->cells - 1, v->is_boundary);
        return gain;
    }

    /// Joins what lies beyond the two sides on either hand of the diagonal.
    void collapse(int side) {
        const int q = cell_of(side);
        const auto mate = [&](int s) { return (s - side) % 2 == 0 ? next(s) : previous(s); };
        std::vector<std::pair<int, int>> joined;
        for (int s = 4 * q; s < 4 * q + 4; ++s) {
            if (m_opposite[s] < 0 || cell_of(m_opposite[s]) == q) continue;
            int other = m_opposite[mate(s)];
            while (other >= 0 && cell_of(other) == q) other = m_opposite[mate(other)];
            joined.emplace_back(m_opposite[s], other);
        }
        for (const auto& [s, other] : joined) m_opposite[s] = other;
        m_is_there[q] = false;
    }

    /// A row of few cells, one beyond the other, that ends with this one. Nothing would hold them where they are. A
    /// piece that is no more than such a row stays.
    void cut_tail(int q) {
        std::vector<int> tail;
        for (std::vector<int> beyond = beside(q, -1); beyond.size() < 2; beyond = beside(q, tail.back())) {
            if (beyond.empty() || std::ssize(tail) == k_longest_tail) return;
            tail.push_back(q);
            q = beyond.front();
        }
        for (const int cell : tail) {
            for (int s = 4 * cell; s < 4 * cell + 4; ++s)
                if (m_opposite[s] >= 0) m_opposite[m_opposite[s]] = -1;
            m_is_there[cell] = false;
        }
    }

    /// Where the border of the surface turns within a cell, one may lie beyond it that has no side with others: of each
    /// piece of the surface what hangs together most stays.
    void leave_out_scraps() {
        const std::vector<std::vector<int>> parts = parts_of_mesh();
        std::map<int, std::size_t> most;
        for (const std::vector<int>& part : parts) {
            std::size_t& count = most[m_piece[part.front()]];
            count = std::max(count, part.size());
        }
        for (const std::vector<int>& part : parts)
            if (part.size() <= k_longest_tail && part.size() < most[m_piece[part.front()]])
                for (const int q : part) m_is_there[q] = false;
    }

    /// Cells that hang together by sides.
    std::vector<std::vector<int>> parts_of_mesh() const {
        std::vector<std::vector<int>> parts;
        std::vector<bool> is_found(m_is_there.size(), false);
        for (int first = 0; first < static_cast<int>(m_is_there.size()); ++first) {
            if (!m_is_there[first] || is_found[first]) continue;
            is_found[first] = true;
            std::vector<int> part{first};
            for (std::size_t k = 0; k < part.size(); ++k)
                for (const int q : beside(part[k], -1))
                    if (!is_found[q]) is_found[q] = true, part.push_back(q);
            parts.push_back(std::move(part));
        }
        return parts;
    }

    /// The cells beyond its sides but for one of them, once for each side.
    std::vector<int> beside(int q, int but) const {
        std::vector<int> cells;
        for (int s = 4 * q; s < 4 * q + 4; ++s)
            if (m_opposite[s] >= 0 && cell_of(m_opposite[s]) != but) cells.push_back(cell_of(m_opposite[s]));
        return cells;
    }

    Mesh mesh() const {
        Mesh mesh;
        mesh.positions.setZero(3, static_cast<Eigen::Index>(m_vertices.size()));
        for (int q = 0; q < static_cast<int>(m_is_there.size()); ++q) {
            if (!m_is_there[q]) continue;
            const std::array<int, 4> corners{m_vertex[4 * q], m_vertex[4 * q + 1], m_vertex[4 * q + 2],
                                             m_vertex[4 * q + 3]};
            mesh.faces.add(corners);
            for (int s = 4 * q; s < 4 * q + 4; ++s)
                mesh.positions.col(m_vertex[s]) += m_corners.col(s) / m_vertices[m_vertex[s]].cells;
        }
        return mesh;
    }

    Positions m_corners;  // of each side where it begins
    std::vector<int> m_opposite, m_piece;
    std::vector<bool> m_is_there;
    std::vector<int> m_vertex;
    std::vector<Vertex> m_vertices;
};

}  // namespace

Mesh mesh_of(const Cells& cells) { return CellMesh(cells).run(); }

}  // namespace chebnet
