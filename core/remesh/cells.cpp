#include "remesh/cells.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

#include "base/error.h"

namespace chebnet {

namespace {

// Sides are about as long as a cell. Where a map has them so much longer it follows nothing, and the cells would fill
// all memory there is.
constexpr std::int64_t k_most_lines_of_axis = 50;

/// A line of the grid: the coordinate of that axis has this value on it, the middle of a cell.
struct Line {
    int axis;
    std::int64_t level;

    bool operator<(const Line& other) const { return std::tie(axis, level) < std::tie(other.axis, other.level); }
};

/// Where a line passes an edge, seen from one of the two triangles.
struct Passage {
    int first_dart = -1;  // of the first crossing on the way into the triangle; −1: none
    int way_out = -1;     // if there is none: the passage by which the line leaves the triangle again
};

/// The lines that pass a side, from its beginning to its end, with the number of the first passage.
struct SideLines {
    std::vector<Line> lines;
    int first_passage = 0;
    bool is_reversed = false;  // against the order of the passages
};

class CellTracer {
public:
    CellTracer(const Surface& surface, const GridMap& map) : m_surface(surface), m_map(map) {}

    Cells run() {
        find_passages();
        for (int f = 0; f < m_surface.face_count(); ++f) cross_in(f);
        Cells cells;
        cells.centres.resize(3, static_cast<Eigen::Index>(m_centres.size()));
        cells.normals.resize(3, cells.centres.cols());
        const std::vector<int> pieces = m_surface.components();
        for (int k = 0; k < cells.size(); ++k) {
            cells.centres.col(k) = m_surface.position_at(m_centres[k]);
            cells.normals.col(k) = m_surface.face_normals().col(m_centres[k].face);
            cells.pieces.push_back(pieces[m_centres[k].face]);
        }
        cells.opposite.resize(4 * m_centres.size());
        // Side k of a cell goes from the corner between the darts k and k + 1 to the next, across dart k + 1.
        for (int dart = 0; dart < static_cast<int>(cells.opposite.size()); ++dart) {
            const int other = follow(dart);
            cells.opposite[side_across(dart)] = other < 0 ? -1 : side_across(other);
        }
        return cells;
    }

private:
    static int side_across(int dart) { return dart % 4 == 0 ? dart + 3 : dart - 1; }

    void find_passages() {
        const int sides = 3 * m_surface.face_count();
        m_sides.resize(static_cast<std::size_t>(sides));
        for (int s = 0; s < sides; ++s) {
            const int other = m_surface.opposite(s);
            if (other >= 0 && other < s) continue;
            m_sides[s].lines = lines_on(s);
            m_sides[s].first_passage = m_passages;
            m_passages += static_cast<int>(m_sides[s].lines.size());
            if (other < 0) continue;
            m_sides[other] = {{}, m_sides[s].first_passage, true};
            for (auto line = m_sides[s].lines.rbegin(); line != m_sides[s].lines.rend(); ++line)
                m_sides[other].lines.push_back(beyond(s, *line));
        }
        m_seen.assign(2 * static_cast<std::size_t>(m_passages), {});
        m_has_twin.assign(static_cast<std::size_t>(m_passages), false);
        for (int s = 0; s < sides; ++s)
            if (m_sides[s].is_reversed)
                for (std::size_t k = 0; k < m_sides[s].lines.size(); ++k)
                    m_has_twin[m_sides[s].first_passage + static_cast<int>(k)] = true;
    }

    std::vector<Line> lines_on(int side) const {
        const GridPoint &from = m_map.corners[side], &to = m_map.corners[Surface::next(side)];
        std::vector<std::tuple<double, Line>> lines;
        for (int axis = 0; axis < 2; ++axis) {
            const std::int64_t low = std::min(from[axis], to[axis]), high = std::max(from[axis], to[axis]);
            if (high - low > k_most_lines_of_axis * k_cell)
                throw Error(ErrorCode::bad_option,
                            "the grid would be stretched beyond measure where the surface has "
                            "hardly any area, or an edge far longer than others");
            std::int64_t cell = low / k_cell - 2;
            while (cell * k_cell + k_cell / 2 < low) ++cell;
            for (std::int64_t level = cell * k_cell + k_cell / 2; level < high; level += k_cell)
                lines.push_back({static_cast<double>(level - from[axis]) / static_cast<double>(to[axis] - from[axis]),
                                 {axis, level}});
        }
        std::sort(lines.begin(), lines.end());
        std::vector<Line> ordered;
        ordered.reserve(lines.size());
        for (const auto& [part, line] : lines) ordered.push_back(line);
        return ordered;
    }

    /// The line in the coordinates beyond a side.
    Line beyond(int side, const Line& line) const {
        GridPoint on_line{};
        on_line[line.axis] = line.level;
        const GridPoint there = turned(on_line, m_map.turns[side]);
        const int axis = m_map.turns[side] % 2 == 0 ? line.axis : 1 - line.axis;
        return {axis, there[axis] + m_map.shifts[side][axis]};
    }

    /// A line's way through a triangle: its ends by their places on the triangle's boundary.
    struct Chord {
        Line line;
        int begin, end;                              // begin < end
        std::vector<std::pair<int, int>> crossings;  // place of the crossing line's end between begin and end; cell
    };

    void cross_in(int face) {
        std::vector<std::pair<Line, int>> ends;  // lines and their places counterclockwise
        std::vector<int> passage_at;             // doubled, + 1 for a triangle behind the twin
        for (int s = 3 * face; s < 3 * face + 3; ++s) {
            const SideLines& side = m_sides[s];
            const int count = static_cast<int>(side.lines.size());
            for (int k = 0; k < count; ++k) {
                ends.emplace_back(side.lines[k], static_cast<int>(passage_at.size()));
                const int passage = side.first_passage + (side.is_reversed ? count - 1 - k : k);
                passage_at.push_back(2 * passage + (side.is_reversed ? 1 : 0));
            }
        }
        std::sort(ends.begin(), ends.end());
        std::vector<Chord> chords;
        for (std::size_t k = 0; k + 1 < ends.size(); k += 2)
            chords.push_back({ends[k].first, ends[k].second, ends[k + 1].second, {}});
        for (Chord& a : chords)
            for (Chord& b : chords)
                if (a.line.axis == 0 && b.line.axis == 1 && is_within(b.begin, a) != is_within(b.end, a))
                    cross(face, a, b);
        for (Chord& chord : chords) connect(chord, passage_at);
    }

    static bool is_within(int place, const Chord& chord) { return place > chord.begin && place < chord.end; }

    void cross(int face, Chord& a, Chord& b) {
        const int cell = static_cast<int>(m_centres.size());
        m_centres.push_back(crossing_point(face, a.line.level, b.line.level));
        a.crossings.emplace_back(is_within(b.begin, a) ? b.begin : b.end, cell);
        b.crossings.emplace_back(is_within(a.begin, b) ? a.begin : a.end, cell);
        // Counterclockwise from the dart to the beginning of a.
        m_way.insert(m_way.end(), 4, -1);
        m_first_of_b.push_back(is_within(b.begin, a) ? 1 : 3);
    }

    /// Where the lines cross, or near there in a triangle without area in the plane.
    SurfacePoint crossing_point(int face, std::int64_t u, std::int64_t v) const {
        Eigen::Matrix2d edges;
        Eigen::Vector2d target;
        const GridPoint& origin = m_map.corners[3 * face];
        for (int axis = 0; axis < 2; ++axis) {
            edges(axis, 0) = static_cast<double>(m_map.corners[3 * face + 1][axis] - origin[axis]);
            edges(axis, 1) = static_cast<double>(m_map.corners[3 * face + 2][axis] - origin[axis]);
            target[axis] = static_cast<double>((axis == 0 ? u : v) - origin[axis]);
        }
        const double area = edges(0, 0) * edges(1, 1) - edges(0, 1) * edges(1, 0);
        Eigen::Vector3d weights = Eigen::Vector3d::Constant(1.0 / 3);
        if (area != 0) {
            const double second = (target[0] * edges(1, 1) - edges(0, 1) * target[1]) / area;
            const double third = (edges(0, 0) * target[1] - target[0] * edges(1, 0)) / area;
            weights = Eigen::Vector3d(1 - second - third, second, third).cwiseMax(0);
            weights /= weights.sum();
        }
        return {face, weights};
    }

    /// The dart of a crossing that points along a chord to its end, or to its beginning.
    int dart_along(const Chord& chord, int cell, bool to_end) const {
        if (chord.line.axis == 0) return 4 * cell + (to_end ? 2 : 0);
        const int to_begin = m_first_of_b[cell];
        return 4 * cell + (to_end ? 4 - to_begin : to_begin);
    }

    void connect(Chord& chord, const std::vector<int>& passage_at) {
        std::sort(chord.crossings.begin(), chord.crossings.end());
        const int in = passage_at[chord.begin], out = passage_at[chord.end];
        if (chord.crossings.empty()) {
            m_seen[in].way_out = out;
            m_seen[out].way_out = in;
            return;
        }
        for (std::size_t k = 0; k + 1 < chord.crossings.size(); ++k) {
            const int here = dart_along(chord, chord.crossings[k].second, true);
            const int there = dart_along(chord, chord.crossings[k + 1].second, false);
            m_way[here] = there;
            m_way[there] = here;
        }
        const int first = dart_along(chord, chord.crossings.front().second, false);
        const int last = dart_along(chord, chord.crossings.back().second, true);
        m_way[first] = -2 - in;
        m_way[last] = -2 - out;
        m_seen[in].first_dart = first;
        m_seen[out].first_dart = last;
    }

    /// The dart at the other end of a dart's way to the next crossing; −1 if that ends at the boundary.
    int follow(int dart) const {
        if (m_way[dart] >= 0) return m_way[dart];
        int port = -2 - m_way[dart];
        for (;;) {
            if (!m_has_twin[port / 2]) return -1;
            const Passage& entered = m_seen[port % 2 == 0 ? port + 1 : port - 1];
            if (entered.first_dart >= 0) return entered.first_dart;
            port = entered.way_out;
        }
    }

    const Surface& m_surface;
    const GridMap& m_map;
    std::vector<SideLines> m_sides;
    int m_passages = 0;
    std::vector<Passage> m_seen;  // two for each passage: from the triangle of the edge's first side, and its twin's
    std::vector<bool> m_has_twin;
    std::vector<SurfacePoint> m_centres;
    std::vector<int> m_way;         // of each dart: the one that it meets, or −2 less the port by which it leaves
    std::vector<int> m_first_of_b;  // of each cell: which dart points to the beginning of the line of axis 1
};

}  // namespace

Cells cells_of(const Surface& surface, const GridMap& map) { return CellTracer(surface, map).run(); }

}  // namespace chebnet
