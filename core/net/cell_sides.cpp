#include "net/cell_sides.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "net/corner_edges.h"
#include "net/measures.h"

namespace chebnet {

namespace {

constexpr int k_none = -1;
// Of L, where a net was just laid.
constexpr double k_exact = 1e-9;
// Radians: what makes a rod turn by more, though there are fewer rims then, is no reading as long as there is another.
constexpr double k_much_bent = std::numbers::pi / 4;

/// Which sides of a face are rims: none, one or two.
struct Reading {
    std::array<int, 2> rims{k_none, k_none};
    int whole_rims = 0;  ///< as long as L, which only chance makes of what a border cuts
    double turn = 0;     ///< radians, by which one of its rods turns most
    double turns = 0;    ///< and all together: readings may share the rod that turns most
    double shear = 0;    ///< radians, of corners whose rods nothing is known to go on from

    bool is_rim(int side) const { return rims[0] == side || rims[1] == side; }
    int rim_count() const { return static_cast<int>(rims[0] != k_none) + static_cast<int>(rims[1] != k_none); }
    bool operator<(const Reading& other) const {
        const auto rank = [](const Reading& r) {
            return std::tuple(r.turn > k_much_bent, r.rim_count(), r.whole_rims, r.turn, r.turns, r.shear);
        };
        return rank(*this) < rank(other);
    }
};

class CellSides {
public:
    CellSides(const Net& net, const Topology& topology, double length)
        : m_net(net),
          m_length(length),
          m_tolerance(whole_edge_tolerance(net, length)),
          m_edge(corner_edges(net, topology)),
          m_corners_of_edge(static_cast<std::size_t>(net.edge_count()), {k_none, k_none}),
          m_is_corner(corners_of_cells(net)),
          m_is_end(m_is_corner.size()),
          m_side(net.faces().vertices.size(), k_rim) {
        m_face.reserve(m_side.size());
        for (int f = 0; f < net.face_count(); ++f)
            for (int k = 0; k < count(f); ++k) {
                m_face.push_back(f);
                std::array<int, 2>& both = m_corners_of_edge[edge(f, k)];
                both[both[0] == k_none ? 0 : 1] = place(f, k);
            }
        find_ends();
        while (find_more_corners()) find_ends();
    }

    std::vector<int> run() {
        for (int f = 0; f < m_net.face_count(); ++f) {
            const std::vector<Reading> readings = possible_readings(f);
            if (readings.empty())
                number_unread(f);
            else
                number(f, *std::min_element(readings.begin(), readings.end()));
        }
        return m_side;
    }

private:
    int count(int f) const { return m_net.faces().start[f + 1] - m_net.faces().start[f]; }
    /// Among the corners of all faces.
    int place(int f, int k) const { return m_net.faces().start[f] + (k + count(f)) % count(f); }
    int vertex(int f, int k) const { return m_net.faces().vertices[place(f, k)]; }
    int edge(int f, int k) const { return m_edge[place(f, k)]; }
    bool is_rim(int f, int k, const Reading& reading) const { return reading.is_rim((k + count(f)) % count(f)); }
    bool is_between(int edge) const { return m_net.edge_face_counts()[edge] == 2; }
    double step(int edge) const { return m_net.rest_lengths()[edge] / m_length - 1; }
    bool is_whole(int edge) const { return std::abs(step(edge)) <= m_tolerance; }
    bool is_longer(int edge) const { return step(edge) > m_tolerance; }

    /// Where what is between two faces is shorter than a whole edge, across from the corner of a cell.
    void find_ends() {
        for (int e = 0; e < m_net.edge_count(); ++e) {
            const int a = m_net.edges()(0, e), b = m_net.edges()(1, e);
            if (!is_between(e) || is_whole(e) || m_is_corner[a] == m_is_corner[b]) continue;
            m_is_end[m_is_corner[a] ? b : a] = true;
        }
    }

    /// By faces that can be read in one way alone. False: there are none.
    bool find_more_corners() {
        bool has_found = false;
        for (int f = 0; f < m_net.face_count(); ++f) {
            const std::vector<Reading> readings = possible_readings(f);
            if (readings.size() != 1) continue;
            for (int k = 0; k < count(f); ++k) {
                if (m_is_corner[vertex(f, k)] || !is_corner_of_cell(f, k, readings.front())) continue;
                m_is_corner[vertex(f, k)] = true;
                has_found = true;
            }
        }
        return has_found;
    }

    std::vector<Reading> possible_readings(int f) const {
        if (are_all_whole(f)) return {Reading{}};
        if (is_of_strip(f)) return {};
        std::vector<Reading> possible;
        const auto consider = [&](int rim, int other) {
            Reading reading{.rims = {rim, other}};
            if (!is_possible(f, reading)) return;
            for (const int k : {rim, other}) reading.whole_rims += k != k_none && is_whole(edge(f, k)) ? 1 : 0;
            add_turns(f, reading);
            possible.push_back(reading);
        };
        for (int k = 0; k < count(f); ++k) {
            if (is_between(edge(f, k))) continue;
            consider(k, k_none);
            for (int i = 0; i < k; ++i)
                if (!is_between(edge(f, i))) consider(i, k);
        }
        return possible;
    }

    // ------------------------------------------------------------------------------------- what a face may be

    bool is_possible(int f, const Reading& reading) const {
        const int n = count(f), rims = reading.rim_count();
        if (n < 3 || n > 4 + rims) return false;
        for (int k = 0; k < n; ++k)
            if (!reading.is_rim(k) && !may_be_rod(f, k, reading)) return false;
        return rims == 1 || are_at_opposite_corners(f, reading);
    }

    bool are_all_whole(int f) const {
        for (int k = 0; k < count(f); ++k)
            if (!is_whole(edge(f, k))) return false;
        return true;
    }

    /// A quad of a net that is one cell wide, whole along its border.
    bool is_of_strip(int f) const {
        if (count(f) != 4) return false;
        for (int k = 0; k < 2; ++k) {
            const int side = edge(f, k), across = edge(f, k + 2);
            const bool is_along = is_whole(side) && is_whole(across) && !is_between(side) && !is_between(across);
            const double cut = step(edge(f, k + 1)), other = step(edge(f, k + 3));
            if (is_along && cut < 0 && other < 0 && std::abs(cut - other) <= 2 * m_tolerance) return true;
        }
        return false;
    }

    /// Rods that follow each other meet at a corner of the cell; one between two others is whole, and one that is not
    /// has an end that is no corner.
    bool may_be_rod(int f, int k, const Reading& reading) const {
        const int e = edge(f, k);
        const bool goes_on_before = !is_rim(f, k - 1, reading), goes_on_behind = !is_rim(f, k + 1, reading);
        if (is_longer(e) || (goes_on_before && m_is_end[vertex(f, k)]) ||
            (goes_on_behind && m_is_end[vertex(f, k + 1)]))
            return false;
        if (is_whole(e) && reading.rim_count() == 1) return true;
        const bool is_corner_before = goes_on_before || m_is_corner[vertex(f, k)],
                   is_corner_behind = goes_on_behind || m_is_corner[vertex(f, k + 1)];
        return !is_corner_before || !is_corner_behind;
    }

    /// Two rims leave two opposite corners of a cell, each with two rods at most.
    bool are_at_opposite_corners(int f, const Reading& reading) const {
        const auto [first, second] = reading.rims;
        const int between = second - first - 1, others = count(f) - 2 - between;
        if (between > 2 || others > 2 || is_whole(edge(f, first)) || is_whole(edge(f, second))) return false;
        for (const auto& [rim, rods] : {std::pair(first, between), {second, others}}) {
            if (rods == 0 && m_is_end[vertex(f, rim + 1)]) return false;
            if (rods == 1 && !is_between(edge(f, rim + 1)) && corner_of_lone(f, rim + 1, reading) == k_none)
                return false;
        }
        return true;
    }

    bool is_lone(int f, int k, const Reading& reading) const {
        return is_rim(f, k - 1, reading) && !is_rim(f, k, reading) && is_rim(f, k + 1, reading);
    }

    /// Of a rod between two rims the corner of the face that is one of its cell; none where nothing says which.
    int corner_of_lone(int f, int k, const Reading& reading) const {
        if (m_is_corner[vertex(f, k)] || m_is_end[vertex(f, k + 1)]) return k;
        if (m_is_corner[vertex(f, k + 1)] || m_is_end[vertex(f, k)]) return k + 1;
        // By the rod at the opposite corner that runs against it.
        for (int i = k + 3; i < k + count(f); ++i)
            if (!is_rim(f, i - 1, reading) && !is_rim(f, i, reading))
                return direction(f, k).dot(direction(f, i)) < direction(f, k).dot(direction(f, i - 1)) ? k : k + 1;
        return k_none;
    }

    /// Whether the face has a corner of its cell there; false where that is not known, as at the end of a line of rods.
    bool is_corner_of_cell(int f, int k, const Reading& reading) const {
        if (is_rim(f, k - 1, reading) == is_rim(f, k, reading)) return true;
        const int rod = is_rim(f, k, reading) ? k - 1 : k;
        if (!is_lone(f, rod, reading)) return false;
        const int corner = corner_of_lone(f, rod, reading);
        return corner != k_none && place(f, corner) == place(f, k);
    }

    // ----------------------------------------------------------------------------------------- how it goes on

    /// Of the sides on the boundary that are taken for rods.
    void add_turns(int f, Reading& reading) const {
        const auto add = [&](int corner, int side) {
            const std::optional<double> turn = turn_at(f, corner, side, reading);
            reading.turn = std::max(reading.turn, turn.value_or(0));
            reading.turns += turn.value_or(0);
            if (!turn) reading.shear += std::abs(std::numbers::pi / 2 - corner_angle(f, corner));
        };
        for (int k = 0; k < count(f); ++k) {
            if (reading.is_rim(k) || is_between(edge(f, k))) continue;
            if (!is_rim(f, k - 1, reading)) add(k, k - 1);
            if (!is_rim(f, k + 1, reading)) add(k + 1, k + 1);
        }
    }

    /// At a corner between two rods: by how much it differs from what the face beyond one of them lets expect, so that
    /// the rods of both faces go on straight there, or as they do at the other end of that side; or from what the next
    /// corner of the cell does. Nothing where that is not known.
    std::optional<double> turn_at(int f, int corner, int side, const Reading& reading) const {
        const double angle = corner_angle(f, corner);
        if (const std::optional<double> expected = corner_beside(f, corner, side)) return std::abs(angle - *expected);
        if (!is_rim(f, corner + 1, reading)) return std::abs(std::numbers::pi - angle - corner_angle(f, corner + 1));
        if (!is_rim(f, corner - 2, reading)) return std::abs(std::numbers::pi - angle - corner_angle(f, corner - 1));
        return std::nullopt;
    }

    /// What the face beyond a side that ends at a corner lets expect there; nothing where its own rods are not certain.
    std::optional<double> corner_beside(int f, int corner, int side) const {
        if (!is_between(edge(f, side))) return std::nullopt;
        const std::array<int, 2>& both = m_corners_of_edge[edge(f, side)];
        const int beyond = both[both[0] == place(f, side) ? 1 : 0], g = m_face[beyond],
                  k = beyond - m_net.faces().start[g];
        const bool begins = vertex(g, k) == vertex(f, corner);
        const int here = begins ? k : k + 1, there = begins ? k + 1 : k;
        if (is_rod_for_certain(edge(g, begins ? k - 1 : k + 1))) return std::numbers::pi - corner_angle(g, here);
        if (is_rod_for_certain(edge(g, begins ? k + 1 : k - 1))) return corner_angle(g, there);
        return std::nullopt;
    }
    bool is_rod_for_certain(int edge) const { return is_between(edge) || is_whole(edge); }

    double corner_angle(int f, int k) const {
        const Eigen::Vector3d a = direction(f, k), b = -direction(f, k - 1);
        return std::atan2(a.cross(b).norm(), a.dot(b));
    }
    Eigen::Vector3d direction(int f, int k) const {
        const Positions& x = m_net.rest_positions();
        return (x.col(vertex(f, k + 1)) - x.col(vertex(f, k))).normalized();
    }

    // ------------------------------------------------------------------------------------------------ numbers

    void number(int f, const Reading& reading) {
        const int n = count(f), first = reading.rim_count() == 0 ? first_to_number(f) : reading.rims[0] + 1;
        int next = 0;
        for (int k = first; k < first + n; ++k) {
            if (!is_rim(f, k, reading)) {
                const bool is_unknown = is_lone(f, k, reading) && corner_of_lone(f, k, reading) == k_none;
                m_side[place(f, k)] = is_unknown ? k_rim : next++;
            } else if (reading.rim_count() == 2) {
                // A corner of the cell at either end of a rim is one at which a rod stops short.
                next += is_corner_of_cell(f, k, reading) + is_corner_of_cell(f, k + 1, reading);
            }
        }
    }

    /// A quad, or what is between faces as far as it goes, and what is as long on the boundary.
    void number_unread(int f) {
        const int first = first_to_number(f);
        const auto is_rod = [&](int k) { return is_rod_for_certain(edge(f, k)); };
        for (int k = first, next = 0; next < count(f) && (count(f) == 4 || is_rod(k)); ++k, ++next)
            if (is_rod(k)) m_side[place(f, k)] = next;
    }

    /// The first side between faces behind one that is not; else 0.
    int first_to_number(int f) const {
        for (int k = 0; k < count(f); ++k)
            if (is_between(edge(f, k)) && !is_between(edge(f, k - 1))) return k;
        return 0;
    }

    const Net& m_net;
    double m_length, m_tolerance;
    std::vector<int> m_edge, m_face;                    // of each corner of a face, and the side from there
    std::vector<std::array<int, 2>> m_corners_of_edge;  // the second is none on the boundary
    std::vector<bool> m_is_corner, m_is_end;            // of each vertex, for certain
    std::vector<int> m_side;                            // of each corner of a face
};

}  // namespace

std::vector<int> cell_sides(const Net& net, const Topology& topology, double length) {
    return CellSides(net, topology, length).run();
}

std::vector<bool> corners_of_cells(const Net& net) {
    std::vector<int> between(static_cast<std::size_t>(net.vertex_count()));
    for (int e = 0; e < net.edge_count(); ++e)
        if (net.edge_face_counts()[e] == 2)
            for (int side = 0; side < 2; ++side) ++between[net.edges()(side, e)];
    std::vector<bool> is_corner(between.size());
    for (std::size_t v = 0; v < between.size(); ++v) is_corner[v] = between[v] > 1;
    return is_corner;
}

double whole_edge_tolerance(const Net& net, double length) {
    // Those that end at the border may be farther off.
    constexpr double k_farther = 10;
    const std::vector<bool> is_corner = corners_of_cells(net);
    double spread = 0, nearly = 0;
    bool has_uncut = false;
    for (int e = 0; e < net.edge_count(); ++e) {
        const double step = std::abs(net.rest_lengths()[e] - length) / length;
        if (step <= k_whole_edge) nearly = std::max(nearly, step);
        if (net.edge_face_counts()[e] != 2 || !is_corner[net.edges()(0, e)] || !is_corner[net.edges()(1, e)]) continue;
        has_uncut = true;
        spread = std::max(spread, step);
    }
    return std::clamp(k_farther * (has_uncut ? spread : nearly), k_exact, k_whole_edge);
}

}  // namespace chebnet
