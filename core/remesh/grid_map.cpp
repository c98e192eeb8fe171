#include "remesh/grid_map.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "remesh/integers.h"

namespace chebnet {

namespace {

// Added to the diagonal, relative to a side: fixes where a piece without singular vertices lies.
constexpr double k_grid_shift = 1e-8;
// The weights of sides are cotangents, but no less than this.
constexpr double k_least_weight = 0.1;

// To choose them takes time by the third power of their number, and memory by the second.
constexpr int k_most_integers = 2000;
// What is to be on a line of the grid is so if the field's direction is nearer to it than this: a sine.
constexpr double k_on_line = 0.3;

/// A component ± variable of one coordinate.
struct Component {
    int axis, sign;
};

/// The component of v that stands at `axis` after so many quarter turns.
Component turned_component(int axis, int quarter_turns) {
    constexpr Component k_components[4][2] = {
        {{0, 1}, {1, 1}}, {{1, -1}, {0, 1}}, {{0, -1}, {1, -1}}, {{1, 1}, {0, -1}}};
    return k_components[quarter_turns][axis];
}

/// ± J^turns T of a branch's translation T.
struct ShiftTerm {
    int branch, turns, sign;
};

/// Coordinates of a corner: J^turns of its vertex, and shifts.
struct Place {
    int turns = 0;
    std::vector<ShiftTerm> shifts;

    void turn(int by) {
        turns = (turns + by) % 4;
        for (ShiftTerm& term : shifts) term.turns = (term.turns + by) % 4;
    }
};

/// The surface cut open along edges, so that the field has no turns but across the cut. A branch is a walk of cut edges
/// with the same transition.
class Cut {
public:
    Cut(const Surface& surface, const DirectionField& field) : m_surface(surface), m_field(field) {
        comb();
        prune();
        find_branches();
    }

    int turns(int side) const { return m_turns[side]; }
    bool is_cut(int side) const { return m_is_cut[side]; }
    int branch_count() const { return m_branches; }
    const std::vector<int>& face_turns() const { return m_face_turns; }
    /// What is added beyond a side after the turn.
    std::vector<ShiftTerm> shift(int side) const {
        if (m_branch[side] < 0) return {};
        if (m_is_along[side]) return {{m_branch[side], 0, 1}};
        return {{m_branch[side], m_turns[side], -1}};
    }

private:
    void comb() {
        const int faces = m_surface.face_count();
        m_face_turns.assign(static_cast<std::size_t>(faces), -1);
        m_is_cut.assign(3 * static_cast<std::size_t>(faces), true);
        std::vector<int> queue;
        for (int seed = 0; seed < faces; ++seed) {
            if (m_face_turns[seed] >= 0) continue;
            m_face_turns[seed] = 0;
            queue.assign(1, seed);
            for (std::size_t k = 0; k < queue.size(); ++k)
                for (int s = 3 * queue[k]; s < 3 * queue[k] + 3; ++s) {
                    const int other = m_surface.opposite(s);
                    if (other < 0 || m_face_turns[Surface::face_of(other)] >= 0) continue;
                    m_face_turns[Surface::face_of(other)] = (m_face_turns[queue[k]] + m_field.turns[s]) % 4;
                    m_is_cut[s] = m_is_cut[other] = false;
                    queue.push_back(Surface::face_of(other));
                }
        }
        m_turns.resize(m_is_cut.size());
        for (int s = 0; s < static_cast<int>(m_turns.size()); ++s) {
            const int other = m_surface.opposite(s);
            if (other < 0) continue;
            const int here = m_face_turns[Surface::face_of(s)], there = m_face_turns[Surface::face_of(other)];
            m_turns[s] = (m_field.turns[s] + here - there + 4) % 4;
        }
    }

    /// Cuts that end at a regular vertex are closed again.
    void prune() {
        m_degree.assign(static_cast<std::size_t>(m_surface.vertex_count()), 0);
        for (int s = 0; s < static_cast<int>(m_is_cut.size()); ++s)
            if (m_is_cut[s] && m_surface.opposite(s) >= 0) ++m_degree[m_surface.from(s)];
        std::vector<int> ends;
        for (int v = 0; v < m_surface.vertex_count(); ++v)
            if (is_loose(v)) ends.push_back(v);
        while (!ends.empty()) {
            const int v = ends.back();
            ends.pop_back();
            if (!is_loose(v)) continue;
            for (int s = m_surface.first_side(v);;) {
                if (m_is_cut[s]) {
                    m_is_cut[s] = m_is_cut[m_surface.opposite(s)] = false;
                    --m_degree[v];
                    --m_degree[m_surface.to(s)];
                    if (is_loose(m_surface.to(s))) ends.push_back(m_surface.to(s));
                    break;
                }
                s = m_surface.around(s);
            }
        }
    }

    bool is_loose(int v) const { return m_degree[v] == 1 && m_field.holonomy[v] == 0 && !m_surface.is_boundary(v); }

    bool is_node(int v) const { return m_degree[v] != 2 || m_field.holonomy[v] != 0 || m_surface.is_boundary(v); }

    void find_branches() {
        m_branch.assign(m_is_cut.size(), -1);
        m_is_along.assign(m_is_cut.size(), false);
        for (const bool from_nodes : {true, false})
            for (int s = 0; s < static_cast<int>(m_branch.size()); ++s)
                if (m_is_cut[s] && m_surface.opposite(s) >= 0 && m_branch[s] < 0 &&
                    is_node(m_surface.from(s)) == from_nodes)
                    follow(s);
    }

    void follow(int side) {
        for (int s = side; s >= 0 && m_branch[s] < 0;) {
            m_branch[s] = m_branch[m_surface.opposite(s)] = m_branches;
            m_is_along[s] = true;
            if (is_node(m_surface.to(s))) break;
            const int back = m_surface.opposite(s);
            int next = m_surface.around(back);
            while (!m_is_cut[next]) next = m_surface.around(next);
            s = next;
        }
        ++m_branches;
    }

    const Surface& m_surface;
    const DirectionField& m_field;
    std::vector<int> m_face_turns;  // of each triangle's direction, to comb it
    std::vector<int> m_turns;
    std::vector<bool> m_is_cut;
    std::vector<int> m_degree;  // of each vertex: cut edges inside of the surface
    std::vector<int> m_branch;  // of each side
    std::vector<bool> m_is_along;
    int m_branches = 0;
};

/// Unknowns: two coordinates of each regular vertex, and integers: two of each branch and two of each singular vertex.
class Fit {
public:
    Fit(const Surface& surface, const DirectionField& field, double length, const std::vector<bool>& on_lines)
        : m_surface(surface), m_field(field), m_length(length), m_cut(surface, field) {
        number_unknowns();
        place_corners();
        if (!on_lines.empty()) hold(on_lines);
        check_integers();
    }

    GridMap run() {
        assemble();
        const Eigen::MatrixXi basis = integer_null_space(m_integers, m_conditions);
        const Eigen::SparseMatrix<double> N = basis.cast<double>().sparseView();
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(m_A);
        const Eigen::VectorXd free = factor.solve(m_b);
        Eigen::VectorXd integers = Eigen::VectorXd::Zero(m_integers);
        if (basis.cols() > 0) {
            // The energy at the best real coordinates for given integers N y (Schur complement).
            const Eigen::SparseMatrix<double> coupling = m_C * N;
            Eigen::MatrixXd S = N.transpose() * Eigen::MatrixXd(m_D * N) -
                                coupling.transpose() * factor.solve(Eigen::MatrixXd(coupling));
            S = (S + S.transpose().eval()) / 2;
            S.diagonal().array() += k_grid_shift * (1 + S.diagonal().maxCoeff());
            integers = N * nearest_integers(S, coupling.transpose() * free - N.transpose() * m_d).cast<double>();
        }
        const Eigen::VectorXd rest = m_C * integers;
        const Eigen::VectorXd reals = factor.solve(m_b - rest);
        return map(reals, integers);
    }

private:
    /// Coordinate of a corner in unknowns: those below m_reals are real, the others integers.
    struct Entry {
        int unknown;
        double coefficient;
    };

    void number_unknowns() {
        m_unknown.resize(static_cast<std::size_t>(m_surface.vertex_count()));
        m_integers = 2 * m_cut.branch_count();
        for (int v = 0; v < m_surface.vertex_count(); ++v)
            if (m_field.holonomy[v] == 0) m_unknown[v] = m_reals, m_reals += 2;
        for (int v = 0; v < m_surface.vertex_count(); ++v)
            if (m_field.holonomy[v] != 0) m_unknown[v] = m_reals + m_integers, m_integers += 2;
    }

    /// Around each vertex from its first side on, and what must hold where that comes round.
    void place_corners() {
        m_places.resize(3 * static_cast<std::size_t>(m_surface.face_count()));
        for (int v = 0; v < m_surface.vertex_count(); ++v) {
            Place place;
            int s = m_surface.first_side(v);
            const int first = s;
            while (s >= 0) {
                m_places[s] = place;
                s = m_surface.around(s);
                if (s < 0) break;
                const int before = m_surface.opposite(s);
                place.turn(m_cut.turns(before));
                for (const ShiftTerm& term : m_cut.shift(before)) place.shifts.push_back(term);
                if (s == first) break;
            }
            if (s >= 0) close(v, place);
        }
    }

    /// `place` is the vertex's own, after a walk around it.
    void close(int v, const Place& place) {
        for (int axis = 0; axis < 2; ++axis) {
            std::vector<int> coefficients(static_cast<std::size_t>(m_integers), 0);
            for (const ShiftTerm& term : place.shifts) {
                const Component component = turned_component(axis, term.turns);
                coefficients[2 * term.branch + component.axis] += term.sign * component.sign;
            }
            if (place.turns != 0) {
                const Component component = turned_component(axis, place.turns);
                coefficients[m_unknown[v] - m_reals + component.axis] += component.sign;
                coefficients[m_unknown[v] - m_reals + axis] -= 1;
            }
            IntegerCondition condition;
            for (int k = 0; k < m_integers; ++k)
                if (coefficients[k] != 0) condition.entries.push_back({k, coefficients[k]});
            if (!condition.entries.empty()) m_conditions.push_back(condition);
        }
    }

    std::vector<Entry> corner(int side, int axis) const {
        const int own = own_coordinate(side, axis);
        const int sign = turned_component(axis, m_places[side].turns).sign;
        if (own < std::ssize(m_held) && !m_held[own].empty()) return sum(m_held[own], sign, shifts_of(side, axis), 1);
        return sum({{m_unknown[m_surface.from(side)] + own % 2, 1}}, sign, shifts_of(side, axis), 1);
    }

    /// Of the vertex where a side begins: 2 · vertex + axis, of what is that axis of the side's triangle.
    int own_coordinate(int side, int axis) const {
        return 2 * m_surface.from(side) + turned_component(axis, m_places[side].turns).axis;
    }

    std::vector<Entry> shifts_of(int side, int axis) const {
        std::vector<Entry> entries;
        for (const ShiftTerm& term : m_places[side].shifts) {
            const Component component = turned_component(axis, term.turns);
            entries.push_back(
                {m_reals + 2 * term.branch + component.axis, static_cast<double>(term.sign * component.sign)});
        }
        return entries;
    }

    static std::vector<Entry> sum(const std::vector<Entry>& x, int by_x, const std::vector<Entry>& y, int by_y) {
        std::vector<Entry> entries;
        const auto add = [&](const Entry& added, int by) {
            const auto same = std::find_if(entries.begin(), entries.end(),
                                           [&](const Entry& entry) { return entry.unknown == added.unknown; });
            if (same == entries.end())
                entries.push_back({added.unknown, by * added.coefficient});
            else
                same->coefficient += by * added.coefficient;
        };
        for (const Entry& entry : x) add(entry, by_x);
        for (const Entry& entry : y) add(entry, by_y);
        std::erase_if(entries, [](const Entry& entry) { return entry.coefficient == 0; });
        return entries;
    }

    /// The axis of whose coordinate there is hardly any change along a side; −1: neither.
    int constant_axis(int side) const {
        const int f = Surface::face_of(side);
        const Eigen::Vector3d edge =
            m_surface.positions().col(m_surface.to(side)) - m_surface.positions().col(m_surface.from(side));
        const Eigen::Vector3d x = m_field.directions.col(f), y = m_surface.face_normals().col(f).cross(x);
        const double along[2] = {edge.dot(x), edge.dot(y)};
        for (int axis = 0; axis < 2; ++axis) {
            const Component component = turned_component(axis, (4 - m_cut.face_turns()[f]) % 4);
            if (std::abs(along[component.axis]) < k_on_line * edge.norm()) return axis;
        }
        return -1;
    }

    void check_integers() const {
        if (m_integers > k_most_integers)
            throw Error(ErrorCode::too_large, "creases, borders and singular vertices leave " +
                                                  std::to_string(m_integers) + " whole numbers to choose, more than " +
                                                  std::to_string(k_most_integers) +
                                                  ": larger cells or fewer creases leave fewer");
    }

    /// Along a crease or border that the field follows one coordinate is a whole number of cells. It is that of a
    /// singular vertex or an integer of its own, and goes over from vertex to vertex.
    void hold(const std::vector<bool>& on_lines) {
        m_held.assign(2 * static_cast<std::size_t>(m_surface.vertex_count()), {});
        LineLinks links(m_held.size());
        for (int s = 0; s < 3 * m_surface.face_count(); ++s) {
            const int axis = on_lines[s] && m_surface.opposite(s) < s ? constant_axis(s) : -1;
            if (axis < 0) continue;
            for (const int corner_side : {s, Surface::next(s)}) links[own_coordinate(corner_side, axis)].push_back(s);
        }
        std::vector<bool> is_done(on_lines.size(), false);
        for (const bool is_singular : {true, false})
            for (int own = 0; own < std::ssize(links); ++own) {
                if (links[own].empty() || !m_held[own].empty() || (m_field.holonomy[own / 2] != 0) != is_singular)
                    continue;
                m_held[own] = {{is_singular ? m_unknown[own / 2] + own % 2 : m_reals + m_integers++, 1}};
                carry_on(own, links, is_done);
            }
    }

    using LineLinks = std::vector<std::vector<int>>;  // of each coordinate of a vertex the sides along which it is one

    void carry_on(int first, const LineLinks& links, std::vector<bool>& is_done) {
        std::vector<int> queue{first};
        for (std::size_t k = 0; k < queue.size(); ++k)
            for (const int s : links[queue[k]]) {
                if (is_done[s]) continue;
                is_done[s] = true;
                const int axis = constant_axis(s);
                const bool is_forth = own_coordinate(s, axis) == queue[k];
                const int here = is_forth ? s : Surface::next(s), there = is_forth ? Surface::next(s) : s;
                const int sign = turned_component(axis, m_places[there].turns).sign;
                const std::vector<Entry> value = sum(corner(here, axis), sign, shifts_of(there, axis), -sign);
                const int other = own_coordinate(there, axis);
                const bool is_new = m_held[other].empty();
                if (is_new) queue.push_back(other);
                if (is_new && m_field.holonomy[other / 2] == 0) {
                    m_held[other] = value;
                    continue;
                }
                if (is_new) m_held[other] = {{m_unknown[other / 2] + other % 2, 1}};
                demand(sum(value, 1, m_held[other], -1));
            }
    }

    /// That a sum of integers is 0.
    void demand(const std::vector<Entry>& entries) {
        IntegerCondition condition;
        for (const Entry& entry : entries)
            condition.entries.push_back({entry.unknown - m_reals, static_cast<int>(entry.coefficient)});
        m_conditions.push_back(condition);
    }

    double weight(int side) const {
        const auto at = [&](int s) { return m_surface.positions().col(m_surface.from(s)); };
        const Eigen::Vector3d a = at(side) - at(Surface::previous(side)),
                              b = at(Surface::next(side)) - at(Surface::previous(side));
        const double area = a.cross(b).norm();
        return area > 0 ? std::max(k_least_weight, a.dot(b) / area) : k_least_weight;
    }

    /// Σ weight · (coordinates of an edge − its components along the field)².
    void assemble() {
        std::vector<Eigen::Triplet<double>> A, C;
        m_b.setZero(m_reals);
        m_D.setZero(m_integers, m_integers);
        m_d.setZero(m_integers);
        for (int s = 0; s < 3 * m_surface.face_count(); ++s) {
            const int f = Surface::face_of(s);
            const Eigen::Vector3d edge =
                (m_surface.positions().col(m_surface.to(s)) - m_surface.positions().col(m_surface.from(s))) / m_length;
            const Eigen::Vector3d x = m_field.directions.col(f), y = m_surface.face_normals().col(f).cross(x);
            const double along[2] = {edge.dot(x), edge.dot(y)};
            const double w = weight(s);
            for (int axis = 0; axis < 2; ++axis) {
                const Component component = turned_component(axis, (4 - m_cut.face_turns()[f]) % 4);
                const double target = component.sign * along[component.axis];
                std::vector<Entry> row = corner(Surface::next(s), axis);
                for (const Entry& entry : corner(s, axis)) row.push_back({entry.unknown, -entry.coefficient});
                add_row(row, w, target, A, C);
            }
        }
        for (int k = 0; k < m_reals; ++k) A.emplace_back(k, k, k_grid_shift);
        m_A.resize(m_reals, m_reals);
        m_A.setFromTriplets(A.begin(), A.end());
        m_C.resize(m_reals, m_integers);
        m_C.setFromTriplets(C.begin(), C.end());
    }

    void add_row(const std::vector<Entry>& row, double w, double target, std::vector<Eigen::Triplet<double>>& A,
                 std::vector<Eigen::Triplet<double>>& C) {
        for (const Entry& a : row) {
            if (a.unknown < m_reals)
                m_b[a.unknown] += w * a.coefficient * target;
            else
                m_d[a.unknown - m_reals] += w * a.coefficient * target;
            for (const Entry& b : row) {
                const double product = w * a.coefficient * b.coefficient;
                if (a.unknown < m_reals && b.unknown < m_reals)
                    A.emplace_back(a.unknown, b.unknown, product);
                else if (a.unknown < m_reals)
                    C.emplace_back(a.unknown, b.unknown - m_reals, product);
                else if (b.unknown >= m_reals)
                    m_D(a.unknown - m_reals, b.unknown - m_reals) += product;
            }
        }
    }

    /// The vertices' own coordinates are rounded to parts of a cell, and all others follow exactly.
    GridMap map(const Eigen::VectorXd& reals, const Eigen::VectorXd& integers) const {
        const auto in_parts = [&](int unknown) {
            if (unknown >= m_reals)
                return k_cell * static_cast<std::int64_t>(std::llround(integers[unknown - m_reals]));
            const auto parts = static_cast<std::int64_t>(std::llround(reals[unknown] * static_cast<double>(k_cell)));
            return parts % (k_cell / 2) == 0 && parts % k_cell != 0 ? parts + 1 : parts;
        };
        GridMap map;
        for (int s = 0; s < 3 * m_surface.face_count(); ++s) {
            GridPoint point{}, shift{};
            for (int axis = 0; axis < 2; ++axis)
                for (const Entry& entry : corner(s, axis))
                    point[axis] += static_cast<std::int64_t>(entry.coefficient) * in_parts(entry.unknown);
            for (const ShiftTerm& term : m_cut.shift(s))
                for (int axis = 0; axis < 2; ++axis) {
                    const Component component = turned_component(axis, term.turns);
                    shift[axis] += term.sign * component.sign * in_parts(m_reals + 2 * term.branch + component.axis);
                }
            map.corners.push_back(point);
            map.turns.push_back(m_surface.opposite(s) < 0 ? 0 : m_cut.turns(s));
            map.shifts.push_back(shift);
        }
        return map;
    }

    const Surface& m_surface;
    const DirectionField& m_field;
    double m_length;
    Cut m_cut;
    int m_reals = 0, m_integers = 0;
    std::vector<int> m_unknown;              // of each vertex, the first of two
    std::vector<Place> m_places;             // of the corner at which each side begins
    std::vector<std::vector<Entry>> m_held;  // of each coordinate of a vertex on a line what it is, in integers
    std::vector<IntegerCondition> m_conditions;
    Eigen::SparseMatrix<double> m_A, m_C;
    Eigen::MatrixXd m_D;
    Eigen::VectorXd m_b, m_d;
};

}  // namespace

GridPoint turned(const GridPoint& p, int quarter_turns) {
    GridPoint result{};
    for (int axis = 0; axis < 2; ++axis) {
        const Component component = turned_component(axis, quarter_turns);
        result[axis] = component.sign * p[component.axis];
    }
    return result;
}

GridMap fit_grid(const Surface& surface, const DirectionField& field, double length,
                 const std::vector<bool>& on_lines) {
    return Fit(surface, field, length, on_lines).run();
}

}  // namespace chebnet
