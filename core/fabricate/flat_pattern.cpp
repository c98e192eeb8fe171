#include "fabricate/flat_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "net/cell_sides.h"
#include "net/corner_edges.h"
#include "net/rods.h"

namespace chebnet {

namespace {

using Reason = PatternFault::Reason;
using Place = Eigen::Vector2d;  // column, row

constexpr double k_equal = 1e-6;  // of a whole edge
constexpr int k_apart = 2;        // squares between pieces

/// To the left, or with turn −1 to the right.
Place turned(const Place& direction, int turn) { return turn * Place(-direction.y(), direction.x()); }

/// The corners of all faces, one face behind the other, as Faces has them; corner k of a face modulo their number. The
/// side of a corner leads to the next. Lengths are in whole edges: those of all sides between two faces but of rods
/// that end, cut, on the boundary.
class Sides {
public:
    Sides(const Net& net, const Topology& topology)
        : m_net(net), m_edge(corner_edges(net, topology)), m_faces_of_edge(net.edge_count(), {-1, -1}) {
        for (int f = 0; f < net.face_count(); ++f)
            for (int k = 0; k < count(f); ++k) {
                std::array<int, 2>& both = m_faces_of_edge[edge(f, k)];
                both[both[0] == -1 ? 0 : 1] = f;
            }
        for (int e = 0; e < net.edge_count(); ++e) m_has_between = m_has_between || is_between(e);
        const double whole = whole_length(net), tolerance = whole_edge_tolerance(net, whole);
        m_cell_side = cell_sides(net, topology, whole);
        m_lengths = net.rest_lengths() / whole;
        for (double& length : m_lengths)
            if (std::abs(length - 1) <= tolerance) length = 1;
        even_out_strips(tolerance);
    }

    int count(int face) const { return static_cast<int>(m_net.faces()[face].size()); }
    int vertex(int face, int k) const { return m_net.faces()[face][k % count(face)]; }
    int edge(int face, int k) const { return m_edge[m_net.faces().start[face] + k % count(face)]; }
    double length(int face, int k) const { return m_lengths[edge(face, k)]; }
    double length(int edge) const { return m_lengths[edge]; }
    bool is_between(int edge) const { return m_faces_of_edge[edge][1] != -1; }
    bool has_between() const { return m_has_between; }
    /// −1: none.
    int beyond(int face, int k) const {
        const std::array<int, 2>& both = m_faces_of_edge[edge(face, k)];
        return both[both[0] == face ? 1 : 0];
    }
    int corner_at(int face, int edge) const {
        int k = 0;
        while (this->edge(face, k) != edge) ++k;
        return k;
    }
    /// Not a rim, which joins the ends of two rods across what is left of a cell.
    bool is_rod(int face, int k) const { return is_between(edge(face, k)) || cell_side(face, k) != k_rim; }
    /// Of its cell, on which the side lies; of a rod k_rim where nothing says so.
    int cell_side(int face, int k) const { return m_cell_side[m_net.faces().start[face] + k % count(face)]; }
    bool has_rods_only(int face) const {
        for (int k = 0; k < count(face); ++k)
            if (!is_rod(face, k)) return false;
        return true;
    }

private:
    /// Where a net is one cell wide, rods across it that were cut alike are of one length, also after an edit.
    void even_out_strips(double tolerance) {
        std::vector<bool> is_done(static_cast<std::size_t>(m_net.face_count()), false);
        for (int first = 0; first < m_net.face_count(); ++first) {
            if (is_done[first]) continue;
            is_done[first] = true;
            std::vector<int> faces{first};
            std::set<int> across;
            for (std::size_t i = 0; i < faces.size(); ++i)
                for (int k = 0; k < 4; ++k) {
                    if (!leads_along_strip(faces[i], k, tolerance)) continue;
                    for (const int side : {k + 1, k + 3}) {
                        across.insert(edge(faces[i], side));
                        const int next = beyond(faces[i], side);
                        if (next == -1 || is_done[next]) continue;
                        is_done[next] = true;
                        faces.push_back(next);
                    }
                }
            double least = 1, most = 0;
            for (const int e : across) least = std::min(least, m_lengths[e]), most = std::max(most, m_lengths[e]);
            if (most - least > 2 * tolerance) continue;
            for (const int e : across) m_lengths[e] = (least + most) / 2;
        }
    }

    /// Side k of a face, between rods that are cut alike.
    bool leads_along_strip(int face, int k, double tolerance) const {
        if (count(face) != 4 || is_between(edge(face, k)) || is_between(edge(face, k + 2))) return false;
        const double one = length(face, k + 1), other = length(face, k + 3);
        return length(face, k) == 1 && length(face, k + 2) == 1 && one < 1 && other < 1 &&
               std::abs(one - other) <= 2 * tolerance;
    }

    const Net& m_net;
    std::vector<int> m_edge;                          // of each side
    std::vector<std::array<int, 2>> m_faces_of_edge;  // the second is −1 on the boundary
    Eigen::VectorXd m_lengths;                        // of each edge
    std::vector<int> m_cell_side;                     // of each side
    bool m_has_between = false;
};

std::optional<PatternFault> find_unfit(const Net& net, const Topology& topology, const Sides& sides) {
    for (int f = 0; f < net.face_count(); ++f)
        if (sides.count(f) != 4 && sides.has_rods_only(f)) return PatternFault{.reason = Reason::not_quads, .face = f};
    for (int e = 0; e < net.edge_count(); ++e) {
        const bool is_cut = topology.is_boundary(net.edges()(0, e)) || topology.is_boundary(net.edges()(1, e));
        const bool may_differ = sides.has_between() && (is_cut || !sides.is_between(e));
        if (sides.length(e) != 1 && !may_differ) return PatternFault{.reason = Reason::unequal};
    }
    for (int f = 0; f < net.face_count(); ++f)
        for (int k = 0; k < sides.count(f); ++k)
            if (sides.is_rod(f, k) && !(sides.length(f, k) > k_equal && sides.length(f, k) <= 1 + k_equal))
                return PatternFault{.reason = Reason::unequal};
    for (int v = 0; v < net.vertex_count(); ++v)
        if (topology.is_singular(v)) return PatternFault{.reason = Reason::singular, .vertex = v};
    return std::nullopt;
}

class Layout {
public:
    Layout(const Net& net, const Sides& sides)
        : m_net(net),
          m_sides(sides),
          m_places(2, net.vertex_count()),
          m_piece(static_cast<std::size_t>(net.vertex_count()), k_nowhere),
          m_turn(static_cast<std::size_t>(net.face_count()), 0),
          m_square(m_turn.size()),
          m_is_found(m_turn.size(), false) {}

    std::variant<FlatPattern, PatternFault> spread() {
        for (int face = 0; face < m_net.face_count(); ++face)
            if (!is_laid(face))
                if (const auto fault = lay_piece(face)) return *fault;
        const std::vector<PatternPiece> pieces = set_in_lines(boxes());
        for (int v = 0; v < m_net.vertex_count(); ++v) {
            const PatternPiece& piece = pieces[m_piece[v]];
            m_places.col(v) += Place(piece.column, piece.row) - m_low[m_piece[v]];
        }
        FlatPattern pattern{.places = m_places, .pieces = pieces};
        for (const PatternPiece& piece : pieces) {
            pattern.columns = std::max(pattern.columns, piece.column + piece.columns);
            pattern.rows = std::max(pattern.rows, piece.row + piece.rows);
        }
        return pattern;
    }

private:
    bool is_laid(int face) const { return m_turn[face] != 0; }
    Place place(int face, int k) const { return m_places.col(m_sides.vertex(face, k)); }
    /// In the piece that is being laid.
    bool has_place(int face, int k) const { return m_piece[m_sides.vertex(face, k)] == m_piece_count - 1; }
    /// Whether a rod lies there.
    bool has_rod(int face, int k) const {
        return m_sides.is_rod(face, k) && has_place(face, k) && has_place(face, k + 1);
    }
    /// Of a rod that lies there.
    Place direction(int face, int k) const {
        return ((place(face, k + 1) - place(face, k)) / m_sides.length(face, k)).array().round();
    }

    /// All faces that edges join with this one. Seen from its front is the first of them with a whole rod, which is
    /// laid first, so that whole squares lie on the grid.
    std::optional<PatternFault> lay_piece(int first) {
        ++m_piece_count;
        m_taken.clear();
        const std::vector<int> faces = faces_joined_to(first);
        const auto [seed, k] = whole_rod_of(faces);
        if (k < 0) return misfit(first);
        if (!put(m_sides.vertex(seed, k), {0, 0})) return misplaced(m_sides.vertex(seed, k));
        if (!put(m_sides.vertex(seed, k + 1), {1, 0})) return misplaced(m_sides.vertex(seed, k + 1));
        if (const auto fault = lay_from(seed, k)) return fault;
        for (const int face : faces)
            if (is_laid(face))
                if (const auto fault = put_across(face)) return fault;
        for (const int face : faces) {
            if (!is_laid(face) || !is_complete(face)) return misfit(face);
            if (const auto fault = find_gape(face)) return fault;
        }
        return std::nullopt;
    }

    std::vector<int> faces_joined_to(int first) {
        std::vector<int> faces{first};
        m_is_found[first] = true;
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (int k = 0; k < m_sides.count(faces[i]); ++k) {
                const int next = m_sides.beyond(faces[i], k);
                if (next == -1 || m_is_found[next]) continue;
                m_is_found[next] = true;
                faces.push_back(next);
            }
        return faces;
    }

    /// A face and the corner at its rod; corner −1: there is none.
    std::pair<int, int> whole_rod_of(const std::vector<int>& faces) const {
        for (const int face : faces)
            for (int k = 0; k < m_sides.count(face); ++k)
                if (m_sides.is_rod(face, k) && m_sides.length(face, k) == 1) return {face, k};
        return {-1, -1};
    }

    /// This face and those that follow from it, each beside one before it.
    std::optional<PatternFault> lay_from(int seed, int corner) {
        std::vector<int> laid{seed};
        if (const auto fault = lay(seed, corner, 1)) return fault;
        for (std::size_t i = 0; i < laid.size(); ++i)
            for (int k = 0; k < m_sides.count(laid[i]); ++k) {
                const int face = laid[i], next = m_sides.beyond(face, k);
                if (next == -1 || is_laid(next) || !has_rod(face, k)) continue;
                const int at = m_sides.corner_at(next, m_sides.edge(face, k));
                const Place outwards = turned(direction(face, k), -m_turn[face]);
                const int turn = turned(direction(next, at), 1).dot(outwards) > 0 ? 1 : -1;
                if (const auto fault = lay(next, at, turn)) return fault;
                laid.push_back(next);
            }
        return std::nullopt;
    }

    /// Lays the rods of a face that follow each other around the one at corner k, which has its place, each at right
    /// angles to the one before.
    std::optional<PatternFault> lay(int face, int k, int turn) {
        m_turn[face] = turn;
        const int count = m_sides.count(face);
        const Place inwards = turned(direction(face, k), turn);
        Place step = direction(face, k);
        int i = k + 1;
        for (; i < k + count && m_sides.is_rod(face, i); ++i) {
            step = turned(step, turn);
            if (!put(m_sides.vertex(face, i + 1), place(face, i) + m_sides.length(face, i) * step))
                return misplaced(m_sides.vertex(face, i + 1));
        }
        step = direction(face, k);
        for (int j = k + count; j > i && m_sides.is_rod(face, j - 1); --j) {
            step = turned(step, -turn);
            if (!put(m_sides.vertex(face, j - 1), place(face, j) - m_sides.length(face, j - 1) * step))
                return misplaced(m_sides.vertex(face, j - 1));
        }
        const Place within = (place(face, k) + place(face, k + 1)) / 2 + k_inside * inwards;
        m_square[face] = within.array().floor();
        if (!m_taken.emplace(m_square[face].x(), m_square[face].y()).second)
            return PatternFault{.reason = Reason::overlap, .face = face};
        return put_across(face);
    }

    /// Of a face with two rims, what is at the opposite corner of its cell.
    std::optional<PatternFault> put_across(int face) {
        const int count = m_sides.count(face);
        if (laid_side_of(face) < 0) return std::nullopt;
        for (int k = count; k < 2 * count; ++k) {
            if (has_place(face, k)) continue;
            const std::optional<Place> corner = corner_of_cell(face, k);
            if (corner && !put(m_sides.vertex(face, k), *corner)) return misplaced(m_sides.vertex(face, k));
        }
        for (int k = 0; k < count; ++k) {
            if (m_sides.cell_side(face, k) == k_rim || has_place(face, k) == has_place(face, k + 1)) continue;
            const Place step = m_sides.length(face, k) * direction_of_cell_side(face, k);
            const bool put_next = has_place(face, k);
            const int v = m_sides.vertex(face, put_next ? k + 1 : k);
            if (!put(v, put_next ? Place(place(face, k) + step) : Place(place(face, k + 1) - step)))
                return misplaced(v);
        }
        return std::nullopt;
    }

    /// If two rods meet there, or if it lies across from such a corner.
    std::optional<Place> corner_of_cell(int face, int k) const {
        const int count = m_sides.count(face);
        const auto has_rod_side = [&](int side) { return m_sides.cell_side(face, side) != k_rim; };
        const auto is_corner = [&](int corner) { return has_rod_side(corner - 1) && has_rod_side(corner); };
        if (is_corner(k)) return end_of_cell_side(face, k - 1);
        for (int other = k + 2; other < k + count - 1; ++other) {
            if (!is_corner(other)) continue;
            const Place across = 2 * middle_of(face) - end_of_cell_side(face, other - 1);
            const auto ends_there = [&](int side) { return (end_of_cell_side(face, side) - across).norm() < k_equal; };
            if (has_rod_side(k - 1) && !ends_there(k - 1)) return std::nullopt;
            if (has_rod_side(k) && ends_there(k)) return std::nullopt;
            return across;
        }
        return std::nullopt;
    }
    Place middle_of(int face) const { return m_square[face] + Place(0.5, 0.5); }

    /// A rod of the face that lies, where it is known on which side of the cell; −1: there is none.
    int laid_side_of(int face) const {
        for (int k = 0; k < m_sides.count(face); ++k)
            if (m_sides.cell_side(face, k) != k_rim && has_rod(face, k)) return k;
        return -1;
    }

    /// By that.
    Place direction_of_cell_side(int face, int k) const {
        const int laid = laid_side_of(face);
        Place step = direction(face, laid);
        const int turns = m_sides.cell_side(face, k) - m_sides.cell_side(face, laid);
        for (int i = 0; i < (turns + 4) % 4; ++i) step = turned(step, m_turn[face]);
        return step;
    }
    Place end_of_cell_side(int face, int k) const {
        const Place along = direction_of_cell_side(face, k);
        return middle_of(face) + (along + turned(along, -m_turn[face])) / 2;
    }

    bool is_complete(int face) const {
        for (int k = 0; k < m_sides.count(face); ++k)
            if (!has_place(face, k)) return false;
        return true;
    }

    /// A face has its place by the rod over which it was come to; others of it may have come round to another. Its rods
    /// lie level and upright, and it within a square.
    std::optional<PatternFault> find_gape(int face) const {
        Place low = place(face, 0), high = low;
        for (int k = 0; k < m_sides.count(face); ++k) {
            const Place step = (place(face, k + 1) - place(face, k)).cwiseAbs();
            const bool is_straight =
                step.minCoeff() <= k_equal && std::abs(step.maxCoeff() - m_sides.length(face, k)) <= k_equal;
            low = low.cwiseMin(place(face, k));
            high = high.cwiseMax(place(face, k));
            if ((m_sides.is_rod(face, k) && !is_straight) || (high - low).maxCoeff() > 1 + k_equal)
                return PatternFault{.reason = Reason::closed, .vertex = m_sides.vertex(face, k)};
        }
        return std::nullopt;
    }

    /// False if the vertex has another place.
    bool put(int v, const Place& place) {
        if (m_piece[v] != k_nowhere)
            return m_piece[v] == m_piece_count - 1 && (m_places.col(v) - place).cwiseAbs().maxCoeff() <= k_equal;
        m_piece[v] = m_piece_count - 1;
        m_places.col(v) = place;
        return true;
    }

    /// Of a vertex that has another place.
    PatternFault misplaced(int v) const {
        const bool is_of_another = m_piece[v] != m_piece_count - 1;
        return {.reason = is_of_another ? Reason::touching : Reason::closed, .vertex = v};
    }

    /// Of a face whose place does not follow from those beside it.
    PatternFault misfit(int face) const {
        if (m_sides.has_between()) return {.reason = Reason::loose, .face = face};
        if (m_sides.count(face) == 4) return {.reason = Reason::unequal};
        return {.reason = Reason::not_quads, .face = face};
    }

    /// The sizes of the pieces, in whole squares; leaves where their lowest columns and rows are.
    std::vector<PatternPiece> boxes() {
        constexpr double k_far = std::numeric_limits<double>::infinity();
        m_low.assign(static_cast<std::size_t>(m_piece_count), {k_far, k_far});
        std::vector<Place> high(m_low.size(), {-k_far, -k_far});
        for (int v = 0; v < m_net.vertex_count(); ++v) {
            Place& low = m_low[m_piece[v]];
            low = low.cwiseMin(m_places.col(v).array().floor().matrix());
            high[m_piece[v]] = high[m_piece[v]].cwiseMax(m_places.col(v).array().ceil().matrix());
        }
        std::vector<PatternPiece> sizes;
        for (std::size_t p = 0; p < high.size(); ++p) {
            const Eigen::Vector2i size = (high[p] - m_low[p]).cast<int>();
            sizes.push_back({.columns = size.x(), .rows = size.y()});
        }
        return sizes;
    }

    /// From the left to the right and from the top downwards.
    static std::vector<PatternPiece> set_in_lines(std::vector<PatternPiece> pieces) {
        double area = 0;
        int widest = 0;
        for (const PatternPiece& piece : pieces) {
            area += static_cast<double>(piece.columns + k_apart) * (piece.rows + k_apart);
            widest = std::max(widest, piece.columns);
        }
        const int width = std::max(widest, static_cast<int>(std::sqrt(area)));
        int column = 0, top = 0, bottom = 0;
        for (PatternPiece& piece : pieces) {
            if (column + piece.columns > width) {
                column = 0;
                top = bottom - k_apart;
            }
            piece.column = column;
            piece.row = top - piece.rows;
            column += piece.columns + k_apart;
            bottom = std::min(bottom, piece.row);
        }
        for (PatternPiece& piece : pieces) piece.row -= bottom;
        return pieces;
    }

    static constexpr int k_nowhere = -1;
    static constexpr double k_inside = 0.01;

    const Net& m_net;
    const Sides& m_sides;
    Eigen::Matrix2Xd m_places;
    std::vector<int> m_piece;  // of each vertex
    int m_piece_count = 0;
    std::vector<Place> m_low;      // of each piece, as it was laid
    std::vector<int> m_turn;       // of each face: 1 if its corners are left turns, −1 if right; 0: not laid yet
    std::vector<Place> m_square;   // of each face that is laid: the low corner of the square on which it lies
    std::vector<bool> m_is_found;  // of each face: it is known in which piece it is
    std::set<std::pair<int, int>> m_taken;  // squares on which a face of the piece lies
};

}  // namespace

const char* to_string(PatternFault::Reason reason) {
    switch (reason) {
        case Reason::not_quads:
            return "not_quads";
        case Reason::unequal:
            return "unequal";
        case Reason::loose:
            return "loose";
        case Reason::singular:
            return "singular";
        case Reason::closed:
            return "closed";
        case Reason::overlap:
            return "overlap";
        case Reason::touching:
            return "touching";
    }
    return "";
}

std::variant<FlatPattern, PatternFault> flat_pattern(const Net& net, const Topology& topology) {
    const Sides sides(net, topology);
    if (const auto fault = find_unfit(net, topology, sides)) return *fault;
    return Layout(net, sides).spread();
}

}  // namespace chebnet
