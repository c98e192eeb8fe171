#include "remesh/grid_map.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <string>

#include "base/error.h"
#include "remesh/field_cut.h"
#include "remesh/integers.h"

namespace chebnet {

namespace {

// Added to the diagonal, relative to a side: fixes where a piece without singular vertices lies.
constexpr double k_grid_shift = 1e-8;
// The weights of sides are cotangents, but no less than this.
constexpr double k_least_weight = 0.1;

// To choose them takes time by the third power of their number, and memory by the second.
constexpr int k_most_integers = 2000;
// Few enough to be chosen for so many longer and as many shorter cells, too. What fits better only by rounding is not
// worth another number of cells.
constexpr int k_few_integers = 60, k_scale_trials = 10;
constexpr double k_clearly_fitter = 0.9;
// Of the map, in cells: nothing has so many in a row.
constexpr double k_most_coordinate = 1e6;
// Where cells may shear, so many rounds lead to edges of one length; about singular vertices nearly so, before whole
// numbers are chosen and after that. What is left shrinks slowly, so that each goes farther than it aims by a factor,
// or, where no vertex is singular, goes on with a part of the round before, more of it from round to round (Nesterov's
// momentum).
constexpr int k_shearing_rounds = 100, k_rounds_to_choose = 15, k_rounds_when_chosen = 5;
constexpr double k_over_relaxation = 1.7, k_momentum = 0.95, k_steepest = 10;
// Rhombs of all angles cost as little as squares do, so that a tube may be drawn out until all of its cells are
// sheared, for the little by which lengths err less then. So each round opens what is sheared by a right angle by a
// part of that, and others by less, by the third power: few cells much sheared are worse than many a little. What is
// opened less from round to round ends with lengths as even as can be, but little sheared: best where cells lie as the
// field does, as about an axis. Where they do not, as beside a border at a slant, cells are better that keep their
// angles and are always opened. Of both that is taken by which lengths err less, where what shears less by one radian
// may err by k_shear_weight more.
struct Aim {
    int steps;           // from the rhomb that is as acute as a cell to the one that is nearest to it
    double first, last;  // what the first and the last round open
};
constexpr Aim k_even_lengths{2, 0.8, 0}, k_open_cells{0, 0.45, 0.45}, k_as_it_is{0, 0, 0};
constexpr double k_shear_weight = 0.2;
constexpr double k_narrowest = std::numbers::pi / 18;  // cells, without a limit, too
constexpr double k_settled = 1e-4;                     // gradients that change less, beside a square's
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

/// Coordinates of a corner: J^turns of its vertex, and shifts.
struct Place {
    int turns = 0;
    std::vector<ShiftTerm> shifts;

    void turn(int by) {
        turns = (turns + by) % 4;
        for (ShiftTerm& term : shifts) term.turns = (term.turns + by) % 4;
    }
};

/// Unknowns: two coordinates of each regular vertex, and integers: two of each branch and two of each singular vertex.
class Fit {
public:
    Fit(const Surface& surface, const DirectionField& field, const std::vector<bool>& on_lines)
        : m_surface(surface), m_field(field), m_is_regular(singular_count(field) == 0), m_cut(surface, m_field) {
        number_unknowns();
        place_corners();
        if (!on_lines.empty()) hold(on_lines);
        check_integers();
        list_rows();
        assemble();
        reduce_to_integers();
    }

    /// `directions`: of the field. `smallest_angle`: of cells.
    GridMap run(const Positions& directions, double length, double slack, double smallest_angle,
                const std::function<void()>& go_on) {
        m_field.directions = directions;
        m_length = length;
        aim_at_squares();
        if (m_N.cols() == 0) {
            const Eigen::VectorXd none = Eigen::VectorXd::Zero(m_integers);
            return map(reals_with(none), none);
        }
        if (!(smallest_angle < std::numbers::pi / 2)) {
            const Eigen::VectorXd integers = m_N * fitting_integers(m_S, slope(), slack);
            return map(reals_with(integers), integers);
        }
        Sheared best = sheared(smallest_angle, m_is_regular ? k_even_lengths : k_as_it_is, go_on);
        if (m_is_regular) {
            Sheared open = sheared(smallest_angle, k_open_cells, go_on);
            if (open.cost < best.cost) best = std::move(open);
        }
        return map(best.reals, best.integers);
    }

private:
    /// Of cells with edges of one length, as far as can be.
    struct Sheared {
        Eigen::VectorXd reals, integers;
        double cost;
    };

    Sheared sheared(double smallest_angle, const Aim& aim, const std::function<void()>& go_on) {
        aim_at_squares();
        // How many cells there are to be around shows while they need not be whole.
        const Eigen::LDLT<Eigen::MatrixXd> inverse(m_S);
        Eigen::VectorXd integers;
        shear_in_rounds(m_is_regular ? k_shearing_rounds : k_rounds_to_choose, go_on, [&](int round, double part) {
            integers = -m_N * inverse.solve(slope());
            const double opened = std::lerp(aim.first, aim.last, part);
            return shear(reals_with(integers), integers, {round, smallest_angle, aim.steps, opened});
        });
        integers = m_N * fitting_integers(m_S, slope(), 0);
        shear_in_rounds(m_is_regular ? k_shearing_rounds : k_rounds_when_chosen, go_on, [&](int round, double) {
            return shear(reals_with(integers), integers, {round, smallest_angle, aim.steps, aim.last});
        });
        Eigen::VectorXd reals = reals_with(integers);
        const double cost = cost_of(gradients_of(reals, integers));
        return {std::move(reals), std::move(integers), cost};
    }

    Eigen::VectorXd reals_with(const Eigen::VectorXd& integers) const { return m_factor.solve(m_b - m_C * integers); }
    Eigen::VectorXd slope() const { return m_coupling.transpose() * m_factor.solve(m_b) - m_N.transpose() * m_d; }

    /// By how much lengths of edges differ, as a part of their mean, and beside that how far cells are from squares,
    /// both root mean square.
    double cost_of(const std::vector<Eigen::Matrix2d>& gradients) const {
        double area = 0, lengths = 0, squares = 0, shear = 0;
        for (int f = 0; f < m_surface.face_count(); ++f) {
            const Eigen::Matrix2d sides = gradients[f].inverse();
            if (is_turned_over(sides)) continue;
            const double part = m_surface.areas()[f], sheared = angle_between(sides) - std::numbers::pi / 2;
            area += part;
            lengths += part * sides.colwise().norm().mean();
            squares += part * sides.squaredNorm() / 2;
            shear += part * sheared * sheared;
        }
        const double error = std::max(0.0, squares * area / (lengths * lengths) - 1);
        return std::sqrt(error) + k_shear_weight * std::sqrt(shear / area);
    }

    /// Whole numbers near those of the best map, or of that with longer or shorter cells. Edges get one length after
    /// all, so that of y only the direction counts, beside that of the best map: least is what is left of y beside it,
    /// in the norm of S, as a part of y.
    static Eigen::VectorXd fitting_integers(const Eigen::MatrixXd& S, const Eigen::VectorXd& slope, double slack) {
        const int trials = S.rows() <= k_few_integers && slack > 0 ? k_scale_trials : 0;
        const double whole = slope.dot(S.ldlt().solve(slope));
        Eigen::VectorXd best;
        double least = 0;
        for (int k = 0; k <= 2 * trials; ++k) {
            const int steps = k % 2 == 0 ? k / 2 : -(k + 1) / 2;  // the least change first
            const double scale = trials > 0 ? 1 + slack * steps / trials : 1;
            const Eigen::VectorXd y = nearest_integers(S, scale * slope).cast<double>();
            const double along = y.dot(slope), square = y.dot(S * y);
            const double misfit = square > 0 ? 1 - along * along / (square * whole) : 1;
            if (best.size() > 0 && !(misfit < k_clearly_fitter * least)) continue;
            best = y;
            least = misfit;
        }
        return best;
    }

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
            for (const int s : m_surface.sides_around(v)) {
                m_places[s] = place;
                const int crossed = Surface::previous(s);
                place.turn(m_cut.turns(crossed));
                for (const ShiftTerm& term : m_cut.shift(crossed)) place.shifts.push_back(term);
            }
            if (!m_surface.is_boundary(v)) close(v, place);
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

    /// Of the frame of the field in a triangle, what an axis of the triangle is.
    Component in_frame(int face, int axis) const { return turned_component(axis, (4 - m_cut.face_turns()[face]) % 4); }

    /// A side in that frame.
    Eigen::Vector2d edge_of(int side) const {
        const int f = Surface::face_of(side);
        const Eigen::Vector3d edge =
            m_surface.positions().col(m_surface.to(side)) - m_surface.positions().col(m_surface.from(side));
        const Eigen::Vector3d x = m_field.directions.col(f), y = m_surface.face_normals().col(f).cross(x);
        return {edge.dot(x), edge.dot(y)};
    }

    /// By what coordinates change along sides.
    void list_rows() {
        m_row_start.assign(1, 0);
        for (int s = 0; s < 3 * m_surface.face_count(); ++s)
            for (int axis = 0; axis < 2; ++axis) {
                const std::vector<Entry> to = corner(Surface::next(s), axis), from = corner(s, axis);
                m_entries.insert(m_entries.end(), to.begin(), to.end());
                for (const Entry& entry : from) m_entries.push_back({entry.unknown, -entry.coefficient});
                m_row_start.push_back(m_entries.size());
            }
    }
    std::span<const Entry> row(int side, int axis) const {
        const std::size_t k = 2 * static_cast<std::size_t>(side) + static_cast<std::size_t>(axis);
        return {m_entries.data() + m_row_start[k], m_row_start[k + 1] - m_row_start[k]};
    }

    double target(int side, int axis) const {
        const int f = Surface::face_of(side);
        const Component component = in_frame(f, axis);
        return component.sign * m_gradients[f].row(component.axis).dot(edge_of(side));
    }

    /// Σ weight · (change of a coordinate along an edge − what the gradient aimed at makes of it)².
    void assemble() {
        std::vector<Eigen::Triplet<double>> A, C;
        m_D.setZero(m_integers, m_integers);
        for (int s = 0; s < 3 * m_surface.face_count(); ++s)
            for (int axis = 0; axis < 2; ++axis) add_row(row(s, axis), weight(s), A, C);
        for (int k = 0; k < m_reals; ++k) A.emplace_back(k, k, k_grid_shift);
        m_A.resize(m_reals, m_reals);
        m_A.setFromTriplets(A.begin(), A.end());
        m_C.resize(m_reals, m_integers);
        m_C.setFromTriplets(C.begin(), C.end());
    }

    /// The energy at the best real coordinates for given integers N y (Schur complement).
    void reduce_to_integers() {
        m_N = integer_null_space(m_integers, m_conditions).cast<double>().sparseView();
        m_factor.compute(m_A);
        if (m_N.cols() == 0) return;
        m_coupling = m_C * m_N;
        m_S = m_N.transpose() * Eigen::MatrixXd(m_D * m_N) -
              m_coupling.transpose() * m_factor.solve(Eigen::MatrixXd(m_coupling));
        m_S = (m_S + m_S.transpose().eval()) / 2;
        m_S.diagonal().array() += k_grid_shift * (1 + m_S.diagonal().maxCoeff());
    }

    void aim_at_squares() {
        m_gradients.assign(static_cast<std::size_t>(m_surface.face_count()), Eigen::Matrix2d::Identity() / m_length);
        m_aims = m_gradients;
        assemble_targets();
    }

    void assemble_targets() {
        m_b.setZero(m_reals);
        m_d.setZero(m_integers);
        for (int s = 0; s < 3 * m_surface.face_count(); ++s)
            for (int axis = 0; axis < 2; ++axis) {
                const double pull = weight(s) * target(s, axis);
                for (const auto& [unknown, coefficient] : row(s, axis))
                    (unknown < m_reals ? m_b[unknown] : m_d[unknown - m_reals]) += coefficient * pull;
            }
    }

    void add_row(std::span<const Entry> row, double w, std::vector<Eigen::Triplet<double>>& A,
                 std::vector<Eigen::Triplet<double>>& C) {
        for (const Entry& a : row) {
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

    /// Of the map that these unknowns make, the changes of coordinates along two sides of a triangle, in its frame.
    Eigen::Matrix2d changes_in(int face, const Eigen::VectorXd& reals, const Eigen::VectorXd& integers) const {
        Eigen::Matrix2d changes;
        for (int k = 0; k < 2; ++k)
            for (int axis = 0; axis < 2; ++axis) {
                double change = 0;
                for (const auto& [unknown, coefficient] : row(3 * face + k, axis))
                    change += coefficient * (unknown < m_reals ? reals[unknown] : integers[unknown - m_reals]);
                const Component component = in_frame(face, axis);
                changes(component.axis, k) = component.sign * change;
            }
        return changes;
    }

    /// Of that map, the gradients in each triangle's frame.
    std::vector<Eigen::Matrix2d> gradients_of(const Eigen::VectorXd& reals, const Eigen::VectorXd& integers) const {
        std::vector<Eigen::Matrix2d> gradients(m_gradients.size());
        for (int f = 0; f < m_surface.face_count(); ++f) {
            Eigen::Matrix2d edges;
            edges << edge_of(3 * f), edge_of(3 * f + 1);
            gradients[f] = changes_in(f, reals, integers) * edges.inverse();
        }
        return gradients;
    }

    /// `round`: is given its number, from 0, and which part of them is done with it, and returns how much it has
    /// changed.
    template <class Round>
    static void shear_in_rounds(int rounds, const std::function<void()>& go_on, Round round) {
        for (int k = 0; k < rounds; ++k) {
            if (go_on) go_on();
            if (round(k, (k + 1.0) / rounds) < k_settled) return;
        }
    }

    struct Round {
        int number;
        double smallest_angle;  // of cells
        int steps;              // as of an Aim
        double opened;
    };

    /// Aims at what is nearest to the map that these unknowns make among cells with edges of one length; without
    /// singular vertices, sheared along a diagonal of the field. There are as many of them as there were of squares.
    /// Returns how much a gradient changes at most, beside a square's.
    double shear(const Eigen::VectorXd& reals, const Eigen::VectorXd& integers, const Round& round) {
        const std::vector<Eigen::Matrix2d> present = gradients_of(reals, integers);
        const double length = length_for(present, round);
        const double momentum = k_momentum * round.number / (round.number + 3);
        double change = 0;
        for (std::size_t f = 0; f < m_gradients.size(); ++f) {
            const Eigen::Matrix2d unit = length * present[f];
            const Eigen::Matrix2d nearest =
                m_is_regular ? rhomb_on_axes(unit, round) : rhomb(unit.inverse(), round.smallest_angle);
            const Eigen::Matrix2d aim = nearest / length, before = m_gradients[f];
            if (m_is_regular)
                m_gradients[f] = aim + momentum * (aim - m_aims[f]);
            else if (present[f].norm() < k_steepest * aim.norm())
                m_gradients[f] = present[f] + k_over_relaxation * (aim - present[f]);
            else  // a triangle that is hardly one may have any gradient, which would grow from round to round
                m_gradients[f] = aim;
            m_aims[f] = aim;
            change = std::max(change, m_length * (m_gradients[f] - before).cwiseAbs().maxCoeff());
        }
        assemble_targets();
        return change;
    }

    /// Of the edges of so many cells as there were of squares, sheared as those of a map with these gradients.
    double length_for(const std::vector<Eigen::Matrix2d>& gradients, const Round& round) const {
        double area = 0, squares = 0;
        for (int f = 0; f < m_surface.face_count(); ++f) {
            const Eigen::Matrix2d sides = gradients[f].inverse();
            const double angle = is_turned_over(sides)
                                     ? std::numbers::pi / 2
                                     : opened_by(round.opened, kept_open(angle_between(sides), round.smallest_angle));
            area += m_surface.areas()[f];
            squares += m_surface.areas()[f] / std::sin(angle);
        }
        return m_length * std::sqrt(squares / area);
    }

    static bool is_turned_over(const Eigen::Matrix2d& sides) {
        return !sides.allFinite() || !(sides.determinant() > 0);
    }

    static double angle_between(const Eigen::Matrix2d& sides) {
        return std::atan2(sides.determinant(), sides.col(0).dot(sides.col(1)));
    }

    static double kept_open(double angle, double smallest_angle) {
        const double least = std::max(smallest_angle, k_narrowest);
        return std::clamp(angle, least, std::numbers::pi - least);
    }

    /// By that part of it if it is sheared by a right angle, and by less, by the third power, if by less.
    static double opened_by(double part, double angle) {
        constexpr double k_square = std::numbers::pi / 2;
        const double sheared = (k_square - angle) / k_square;
        return angle + part * k_square * sheared * sheared * sheared;
    }

    /// The gradient of the map onto the rhomb of side 1 with diagonals between the axes that is as acute as the cell
    /// with this gradient, or after some Gauss-Newton steps the nearest to it, but not too acute, and `opened`; of a
    /// cell that is turned over, onto a square. Along the diagonals it is 1 / (√2 cos h) and 1 / (√2 sin h), where h is
    /// half an angle.
    static Eigen::Matrix2d rhomb_on_axes(const Eigen::Matrix2d& gradient, const Round& round) {
        const double sum = gradient.sum() / 2, difference = (gradient.trace() - gradient(0, 1) - gradient(1, 0)) / 2;
        if (!(sum > 0) || !(difference > 0)) return Eigen::Matrix2d::Identity();
        double angle = kept_open(2 * std::atan2(sum, difference), round.smallest_angle);
        for (int k = 0; k < round.steps; ++k) {
            const auto [along, across] = on_diagonals(angle);
            const double tangent = std::tan(angle / 2), by_along = along * tangent, by_across = -across / tangent;
            const double fall = (sum - along) * by_along + (difference - across) * by_across;
            angle = kept_open(angle + 2 * fall / (by_along * by_along + by_across * by_across), round.smallest_angle);
        }
        const auto [along, across] = on_diagonals(opened_by(round.opened, angle));
        Eigen::Matrix2d rhomb;
        rhomb << along + across, along - across, along - across, along + across;
        return rhomb / 2;
    }

    /// What the gradient of a map onto rhombs of side 1 is along their diagonals.
    static std::array<double, 2> on_diagonals(double angle) {
        return {std::numbers::sqrt2 / 2 / std::cos(angle / 2), std::numbers::sqrt2 / 2 / std::sin(angle / 2)};
    }

    /// The gradient of the map onto the rhomb of side 1 with its sides along those of the cell, however it lies, but
    /// not too acute; of a cell that is turned over, onto a square.
    static Eigen::Matrix2d rhomb(const Eigen::Matrix2d& sides, double smallest_angle) {
        if (is_turned_over(sides)) return Eigen::Matrix2d::Identity();
        const double angle = angle_between(sides), opened = kept_open(angle, smallest_angle) - angle;
        Eigen::Matrix2d rhomb;
        rhomb << Eigen::Rotation2Dd(-opened / 2) * sides.col(0).normalized(),
            Eigen::Rotation2Dd(opened / 2) * sides.col(1).normalized();
        return rhomb.inverse();
    }

    /// The vertices' own coordinates are rounded to parts of a cell, and all others follow exactly.
    GridMap map(const Eigen::VectorXd& reals, const Eigen::VectorXd& integers) const {
        const auto is_grid = [](const Eigen::VectorXd& unknowns) {
            return unknowns.allFinite() && unknowns.lpNorm<Eigen::Infinity>() < k_most_coordinate;
        };
        if (!is_grid(reals) || !is_grid(integers))
            throw Error(ErrorCode::bad_option, "no grid of whole cells was found on the surface");
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
    DirectionField m_field;
    double m_length = 0;
    bool m_is_regular;  // there are no singular vertices
    FieldCut m_cut;
    int m_reals = 0, m_integers = 0;
    std::vector<int> m_unknown;              // of each vertex, the first of two
    std::vector<Place> m_places;             // of the corner at which each side begins
    std::vector<std::vector<Entry>> m_held;  // of each coordinate of a vertex on a line what it is, in integers
    std::vector<IntegerCondition> m_conditions;
    std::vector<Entry> m_entries;              // of rows, see list_rows()
    std::vector<std::size_t> m_row_start;      // of each side and axis, and the end
    std::vector<Eigen::Matrix2d> m_gradients;  // of each triangle, those the map follows, in the field's frame
    std::vector<Eigen::Matrix2d> m_aims;       // those of rhombs that the last round has aimed at
    Eigen::SparseMatrix<double> m_A, m_C;
    Eigen::MatrixXd m_D;
    Eigen::VectorXd m_b, m_d;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factor;  // of A
    Eigen::SparseMatrix<double> m_N;                              // integers that fit together are N y
    Eigen::SparseMatrix<double> m_coupling;                       // C N
    Eigen::MatrixXd m_S;                                          // the form of the energy in y
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

GridMap fit_grid(const Surface& surface, const DirectionField& field, double length, double slack,
                 const std::vector<bool>& on_lines, double smallest_angle, const std::function<void()>& go_on) {
    return Fit(surface, field, on_lines).run(field.directions, length, slack, smallest_angle, go_on);
}

GridFitter grid_fitter(const Surface& surface, const DirectionField& field) {
    return [fit = std::make_shared<Fit>(surface, field, std::vector<bool>())](const DirectionField& other,
                                                                              double length, double smallest_angle) {
        return fit->run(other.directions, length, 0, smallest_angle, nullptr);
    };
}

}  // namespace chebnet
