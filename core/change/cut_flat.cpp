#include "change/cut_flat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "change/cut.h"
#include "net/cell_sides.h"
#include "net/corner_edges.h"
#include "net/rods.h"

namespace chebnet {

namespace {

constexpr int k_none = -1;

struct Cell {
    int column = 0, row = 0;
    bool operator<(const Cell& other) const { return std::tie(column, row) < std::tie(other.column, other.row); }
    bool operator==(const Cell& other) const { return column == other.column && row == other.row; }
    Cell operator+(const Cell& other) const { return {column + other.column, row + other.row}; }
    Cell operator-(const Cell& other) const { return {column - other.column, row - other.row}; }
    Cell operator*(int factor) const { return {factor * column, factor * row}; }
};

/// To the right, up, to the left, down: direction modulo 4.
int quarter(int direction) { return direction & 3; }
Cell unit(int direction) {
    constexpr std::array<Cell, 4> k_units = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    return k_units[quarter(direction)];
}

/// How a face lies on the grid.
struct Pose {
    Cell cell;
    int direction = 0;  ///< of its first side
    int turn = 1;       ///< 1: its corners are left turns, −1: right
    bool operator==(const Pose& other) const {
        return cell == other.cell && direction == other.direction && turn == other.turn;
    }
};

/// Turns, turns over and moves what lies on the grid.
class Motion {
public:
    Motion(const Pose& from, const Pose& to)
        : m_turn(from.turn * to.turn), m_direction(quarter(to.direction - m_turn * from.direction)) {
        m_shift = to.cell - moved(from.cell);
    }
    Pose operator()(const Pose& pose) const {
        return {moved(pose.cell), quarter(m_direction + m_turn * pose.direction), m_turn * pose.turn};
    }
    bool operator<(const Motion& other) const {
        return std::tie(m_turn, m_direction, m_shift) < std::tie(other.m_turn, other.m_direction, other.m_shift);
    }

private:
    Cell moved(const Cell& cell) const {
        return unit(m_direction) * cell.column + unit(m_direction + m_turn) * cell.row + m_shift;
    }

    int m_turn = 1, m_direction = 0;
    Cell m_shift;
};

/// The faces as cells of the grid, and what lies beyond their sides. At a border, where rods are cut, a face may have
/// less or more sides than a cell.
class Cells {
public:
    Cells(const Net& net, const Topology& topology, const std::vector<int>& edges)
        : m_faces(net.faces()),
          m_edges(edges),
          m_corners(static_cast<std::size_t>(net.edge_count()), {k_none, k_none}),
          m_face_of(edges.size()),
          m_side(cell_sides(net, topology, whole_length(net))) {
        for (int f = 0; f < m_faces.size(); ++f)
            for (int corner = m_faces.start[f]; corner < m_faces.start[f + 1]; ++corner) {
                m_face_of[corner] = f;
                std::array<int, 2>& both = m_corners[edges[corner]];
                both[both[0] == k_none ? 0 : 1] = corner;
            }
        for (int f = 0; f < m_faces.size(); ++f) refuse_unless_quad(f);
    }

    const std::array<int, 2>& corners(int edge) const { return m_corners[edge]; }
    int face_of(int corner) const { return m_face_of[corner]; }
    int edge_of(int corner) const { return m_edges[corner]; }
    /// The corner whose side it is on the other side of the edge; none on the border.
    int beyond(int corner) const {
        const std::array<int, 2>& both = m_corners[m_edges[corner]];
        return both[both[0] == corner ? 1 : 0];
    }
    /// Whether both faces say how they lie at their side.
    bool lies_between_cells(int edge) const {
        const auto [a, b] = m_corners[edge];
        return b != k_none && m_side[a] != k_rim && m_side[b] != k_rim;
    }
    /// Throws Error impossible_change for a face without four sides and without neighbours, which lies in no way.
    void check_lone_faces() const {
        for (int f = 0; f < m_faces.size(); ++f)
            if (count(f) != 4 && between(f) == 0) refuse(f);
    }
    /// How the face beyond a corner's side lies, by how its own does.
    Pose across(int corner, const Pose& pose) const {
        const int other = beyond(corner);
        const int direction = pose.direction + pose.turn * m_side[corner];
        const bool same_way = m_faces.vertices[corner] == m_faces.vertices[other];
        const int turn = same_way ? -pose.turn : pose.turn;
        const int along = same_way ? direction : direction + 2;
        return {pose.cell + unit(direction - pose.turn), quarter(along - turn * m_side[other]), turn};
    }

private:
    [[noreturn]] static void refuse(int face) {
        throw Error(ErrorCode::impossible_change,
                    "face " + std::to_string(face) + " is no quad, so no piece with it lies flat as a square grid");
    }
    int count(int f) const { return m_faces.start[f + 1] - m_faces.start[f]; }
    /// Sides of a face that are between two.
    int between(int f) const {
        int sides = 0;
        for (int corner = m_faces.start[f]; corner < m_faces.start[f + 1]; ++corner) sides += beyond(corner) != k_none;
        return sides;
    }
    void refuse_unless_quad(int f) const {
        if (count(f) != 4 && between(f) == count(f)) refuse(f);
    }

    const Faces& m_faces;
    const std::vector<int>& m_edges;            // of each corner, that of its side
    std::vector<std::array<int, 2>> m_corners;  // of each edge
    std::vector<int> m_face_of;                 // of each corner
    std::vector<int> m_side;                    // of each corner, which of the cell's its side is
};

/// Edges that are cut, in lines.
class Cuts {
public:
    Cuts(const Net& net, const Topology& topology)
        : m_topology(topology),
          m_lines(topology.net_lines()),
          m_place(static_cast<std::size_t>(net.edge_count())),
          m_is_cut(m_place.size(), false),
          m_is_met(static_cast<std::size_t>(net.vertex_count())) {
        for (int l = 0; l < static_cast<int>(m_lines.size()); ++l)
            for (int k = 0; k + 1 < static_cast<int>(m_lines[l].size()); ++k) m_place[edge(l, k)] = {l, k};
        for (int v = 0; v < net.vertex_count(); ++v) m_is_met[v] = topology.is_boundary(v) || topology.is_singular(v);
    }

    bool is_cut(int edge) const { return m_is_cut[edge]; }
    void undo(int edge) { m_is_cut[edge] = false; }
    std::vector<int> edges() const {
        std::vector<int> cut;
        for (int e = 0; e < static_cast<int>(m_is_cut.size()); ++e)
            if (m_is_cut[e]) cut.push_back(e);
        return cut;
    }

    /// From all singular vertices inside, one edge at a time.
    void cut_from_singular() {
        std::vector<End> ends;
        for (int l = 0; l < static_cast<int>(m_lines.size()); ++l) {
            const int last = static_cast<int>(m_lines[l].size()) - 1;
            if (m_topology.is_singular(m_lines[l].front())) ends.push_back({l, 0, 1});
            if (m_topology.is_singular(m_lines[l].back())) ends.push_back({l, last, -1});
        }
        while (!ends.empty()) {
            std::vector<End> going;
            for (End end : ends)
                if (advance(end)) going.push_back(end);
            ends = going;
        }
    }

    /// How many edges would be cut on the line through this one, until that meets a border or a cut.
    int length_through(int edge) const {
        int length = 1;
        for (End end : ends_at(edge))
            for (; !has_ended(end); end.at += end.step) ++length;
        return length;
    }
    void cut_through(int edge) {
        m_is_cut[edge] = true;
        for (End end : ends_at(edge)) {
            const bool goes_on = !has_ended(end);
            m_is_met[vertex(end)] = true;
            while (goes_on && advance(end)) continue;
        }
    }

private:
    /// Where a cut has come on a line.
    struct End {
        int line, at, step;
    };

    int vertex(const End& end) const { return m_lines[end.line][end.at]; }
    int edge(int line, int k) const { return m_topology.edge_between(m_lines[line][k], m_lines[line][k + 1]); }
    std::array<End, 2> ends_at(int edge) const {
        const auto [line, k] = m_place[edge];
        return {{{line, k, -1}, {line, k + 1, 1}}};
    }
    bool is_last(const End& end) const {
        return end.at + end.step < 0 || end.at + end.step == static_cast<int>(m_lines[end.line].size());
    }
    bool has_ended(const End& end) const { return m_is_met[vertex(end)] || is_last(end); }
    /// Cuts the next edge. False: the cut ends there.
    bool advance(End& end) {
        m_is_cut[edge(end.line, std::min(end.at, end.at + end.step))] = true;
        end.at += end.step;
        const bool goes_on = !has_ended(end);
        m_is_met[vertex(end)] = true;
        return goes_on;
    }

    const Topology& m_topology;
    std::vector<std::vector<int>> m_lines;
    std::vector<std::pair<int, int>> m_place;  // of each edge, its line and where on it
    std::vector<bool> m_is_cut;                // of each edge
    std::vector<bool> m_is_met;                // of each vertex, whether a cut ends there
};

/// The parts between cuts, each laid on a grid of its own.
class FlatPieces {
public:
    FlatPieces(const Net& net, const Cells& cells, Cuts& cuts)
        : m_faces(net.faces()),
          m_cells(cells),
          m_cuts(cuts),
          m_pose(static_cast<std::size_t>(net.face_count())),
          m_piece(m_pose.size(), k_none) {}

    /// Cuts once more what does not lie flat.
    void lay() {
        for (int f = 0; f < m_faces.size(); ++f)
            while (m_piece[f] == k_none) lay_from(f);
    }
    /// And takes the cuts between them back.
    void join() {
        while (join_neighbours()) continue;
        for (const int e : m_cuts.edges())
            if (is_closed(e)) m_cuts.undo(e);
    }

private:
    /// Lays a piece. If it does not lie flat it is cut once more, and not laid.
    void lay_from(int first) {
        const int number = static_cast<int>(m_members.size());
        std::vector<int> laid{first};
        std::set<Cell> taken{{0, 0}};
        m_piece[first] = number;
        m_pose[first] = {};
        std::optional<int> best;
        for (std::size_t i = 0; i < laid.size(); ++i)
            for (int corner = m_faces.start[laid[i]]; corner < m_faces.start[laid[i] + 1]; ++corner) {
                const int e = m_cells.edge_of(corner);
                if (!m_cells.lies_between_cells(e) || m_cuts.is_cut(e)) continue;
                const int next = m_cells.face_of(m_cells.beyond(corner));
                const Pose pose = m_cells.across(corner, m_pose[laid[i]]);
                if (m_piece[next] == number ? m_pose[next] == pose : taken.insert(pose.cell).second) {
                    if (m_piece[next] == number) continue;
                    m_piece[next] = number;
                    m_pose[next] = pose;
                    laid.push_back(next);
                } else if (!best || m_cuts.length_through(e) < m_cuts.length_through(*best)) {
                    best = e;
                }
            }
        if (!best) {
            m_members.push_back(laid);
            m_taken.push_back(taken);
            return;
        }
        m_cuts.cut_through(*best);
        for (const int f : laid) m_piece[f] = k_none;
    }

    /// The two faces at a cut edge lie beside each other.
    bool is_closed(int edge) const {
        if (!m_cells.lies_between_cells(edge)) return false;
        const auto [a, b] = m_cells.corners(edge);
        const int f = m_cells.face_of(a), g = m_cells.face_of(b);
        return m_piece[f] == m_piece[g] && m_cells.across(a, m_pose[f]) == m_pose[g];
    }

    /// Joins pieces that lie flat together, each with one other at most. False: no two do.
    bool join_neighbours() {
        // Of a piece, another, and how that is moved to lie beside it: the edges between them that are closed by that.
        std::map<std::tuple<int, int, Motion>, int> closed;
        for (const int e : m_cuts.edges()) {
            if (!m_cells.lies_between_cells(e)) continue;
            auto [a, b] = m_cells.corners(e);
            if (comes_first(m_piece[m_cells.face_of(b)], m_piece[m_cells.face_of(a)])) std::swap(a, b);
            const int f = m_cells.face_of(a), g = m_cells.face_of(b);
            if (m_piece[f] != m_piece[g])
                ++closed[{m_piece[f], m_piece[g], Motion(m_pose[g], m_cells.across(a, m_pose[f]))}];
        }
        std::vector<std::pair<std::tuple<int, int, Motion>, int>> ways(closed.begin(), closed.end());
        std::stable_sort(ways.begin(), ways.end(), [](const auto& x, const auto& y) { return x.second > y.second; });
        std::set<int> changed;
        for (const auto& [way, count] : ways) {
            const auto& [piece, other, motion] = way;
            if (changed.contains(piece) || changed.contains(other) || !fits(piece, other, motion)) continue;
            move_to(piece, other, motion);
            changed.insert({piece, other});
        }
        return !changed.empty();
    }

    /// Of two pieces, the one that stays where it is.
    bool comes_first(int piece, int other) const {
        const std::size_t size = m_members[piece].size(), other_size = m_members[other].size();
        return size > other_size || (size == other_size && piece < other);
    }

    bool fits(int piece, int other, const Motion& motion) const {
        const std::vector<int>& moved = m_members[other];
        return std::none_of(moved.begin(), moved.end(),
                            [&](int f) { return m_taken[piece].contains(motion(m_pose[f]).cell); });
    }

    void move_to(int piece, int other, const Motion& motion) {
        for (const int f : m_members[other]) {
            m_pose[f] = motion(m_pose[f]);
            m_piece[f] = piece;
            m_members[piece].push_back(f);
            m_taken[piece].insert(m_pose[f].cell);
        }
        m_members[other].clear();
        m_taken[other].clear();
    }

    const Faces& m_faces;
    const Cells& m_cells;
    Cuts& m_cuts;
    std::vector<Pose> m_pose;                 // of each face
    std::vector<int> m_piece;                 // of each face
    std::vector<std::vector<int>> m_members;  // of each piece, its faces
    std::vector<std::set<Cell>> m_taken;      // and where they lie
};

/// A square grid has one length; a border may have cut edges that end there.
void check_lengths(const Net& net, const Topology& topology) {
    if (net.is_chebyshev()) return;
    const double length = whole_length(net), tolerance = whole_edge_tolerance(net, length);
    const auto is_inside = [&](int vertex) { return !topology.is_boundary(vertex); };
    for (int e = 0; e < net.edge_count(); ++e)
        if (is_inside(net.edges()(0, e)) && is_inside(net.edges()(1, e)) &&
            std::abs(net.rest_lengths()[e] / length - 1) > tolerance)
            throw Error(ErrorCode::impossible_change,
                        "the edges of this net differ in length, so that no piece lies flat as a square grid: give "
                        "all edges one length first");
}

}  // namespace

ChangedMesh cut_flat(const Net& net, const ChangePlace& /*place*/) {
    const Topology topology(net);
    check_lengths(net, topology);
    const std::vector<int> edges = corner_edges(net, topology);
    const Cells cells(net, topology, edges);
    Cuts cuts(net, topology);
    cuts.cut_from_singular();
    FlatPieces pieces(net, cells, cuts);
    pieces.lay();
    pieces.join();
    std::vector<int> all_vertices(static_cast<std::size_t>(net.vertex_count()));
    std::iota(all_vertices.begin(), all_vertices.end(), 0);
    ChangedMesh flat = parted(net, {all_vertices, cuts.edges()});
    if (static_cast<int>(flat.origins.size()) > net.vertex_count()) return flat;
    cells.check_lone_faces();
    throw Error(ErrorCode::impossible_change, "the net lies flat as a square grid as it is: nothing is to be cut");
}

}  // namespace chebnet
