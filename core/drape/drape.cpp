#include "drape/drape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "drape/bent_arms.h"
#include "drape/border_cut.h"
#include "drape/bound.h"
#include "drape/compass.h"
#include "drape/draped_net.h"
#include "drape/drawn_curve.h"
#include "drape/least_shear.h"
#include "drape/slits.h"
#include "drape/surroundings.h"

namespace chebnet {

namespace {

// Vertices at one place of the grid, or next to each other there, that are farther apart than this, in edge lengths,
// belong to parts of the net that lie over each other only where it is unrolled, as turns of a spiral do.
constexpr double k_other_part = 4;
// Vertices on a drawn curve with one between them that are nearer, in edge lengths, would have cells on each other.
constexpr double k_turned_back = 0.5;

[[noreturn]] void refuse_size() {
    throw Error(ErrorCode::too_large, "the net would have more than " + std::to_string(k_most_draped_vertices) +
                                          " vertices: the edges are too short for this surface");
}

/// Steps along the two families from the seed.
struct GridPlace {
    int i, j;

    GridPlace operator+(const GridPlace& step) const { return {i + step.i, j + step.j}; }
    int steps() const { return std::abs(i) + std::abs(j); }
    /// The nearest to the seed come first, and all four quadrants alike.
    auto rank() const { return std::tuple(steps(), std::abs(i), i, j); }
    bool operator>(const GridPlace& other) const { return rank() > other.rank(); }
};

constexpr std::array<GridPlace, 4> k_steps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
constexpr std::array<GridPlace, 4> k_diagonals = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

class Draper {
public:
    Draper(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options, const BentArms& bent)
        : m_options(options),
          m_bent(bent),
          m_curve(curve_of(surface, tree, options)),
          m_slits(slits_of(surface, tree, options)),
          m_compass(surface, tree, options.length, slits()),
          m_surroundings(options.length),
          m_largest_cosine(largest_cosine(options.smallest_angle)) {
        const SurfaceTree::Nearest seed =
            tree.nearest(m_curve ? m_curve->nearest(options.seed).position : options.seed);
        add({0, 0}, m_compass.vertex_at(seed.position, seed.at.face));
    }

    Drape run() {
        run_arms();
        do fill();
        while (go_straight_on());
        return result();
    }

private:
    void run_arms() {
        const Eigen::Vector3d normal = m_vertices[0].normal;
        const Eigen::Vector3d first = m_curve ? follow_curve() : m_options.direction;
        const Eigen::Vector3d laid = first - first.dot(normal) * normal;
        if (!(laid.norm() > 1e-9 * first.norm()))
            throw Error(ErrorCode::bad_option, "the direction stands upright on the surface at the seed");
        const Eigen::Vector3d u = laid.normalized();
        const Eigen::Vector3d v = std::cos(m_options.angle) * u + std::sin(m_options.angle) * normal.cross(u);
        std::vector<Arm> growing = {{0, u}, {1, v}, {2, -u}, {3, -v}};
        if (m_curve) std::erase_if(growing, [](const Arm& arm) { return k_steps[arm.number].j == 0; });
        // What lies between the arms keeps pace with them: an arm that goes round a pipe or a hole before it would come
        // to places that are nearer to the seed another way, and the net would end there.
        for (int steps = 2; !growing.empty(); ++steps) {
            std::erase_if(growing, [&](Arm& arm) { return !grow(arm); });
            fill(steps);
        }
    }

    /// A line of edges from the seed, up to its last vertex.
    struct Arm {
        int number;
        Eigen::Vector3d direction;
        int last = 0;
    };

    void run(Arm arm) {
        while (grow(arm)) {
        }
    }

    /// By an edge. False where none fits.
    bool grow(Arm& arm) {
        if (!is_on_surface(m_vertices[arm.last])) return false;
        bend(arm);
        const auto vertex = m_compass.straight_on(m_vertices[arm.last], arm.direction);
        const GridPlace place = m_places[arm.last] + k_steps[arm.number];
        if (!vertex || !is_allowed(place, *vertex, arm.last)) return false;
        arm.last = add(place, *vertex);
        return true;
    }

    /// At its last vertex, towards the next.
    void bend(Arm& arm) const {
        const double way = m_places[arm.last].steps() * m_options.length, half = m_options.length / 2;
        const double turn = m_bent.at(arm.number, way + half) - m_bent.at(arm.number, way - half);
        if (turn == 0) return;
        const Eigen::Vector3d left = m_vertices[arm.last].normal.cross(arm.direction);
        arm.direction = std::cos(turn) * arm.direction + std::sin(turn) * left;
    }

    /// Sets the arms of the first family along the curve, and straight on behind its ends. Gives its direction at the
    /// seed.
    Eigen::Vector3d follow_curve() {
        std::array<int, 2> ends{};
        for (const bool forwards : {true, false}) ends[forwards] = follow_curve(forwards);
        const auto at = [&](int i) -> Eigen::Vector3d { return m_vertices[std::max(0, find({i, 0}))].position; };
        Eigen::Vector3d direction = at(1) - at(-1);
        if (direction.isZero(0)) throw Error(ErrorCode::bad_option, "the drawn curve is shorter than an edge");
        for (const bool forwards : {true, false}) {
            if (ends[forwards] < 0) continue;
            const int last = ends[forwards], i = m_places[last].i, step = forwards ? 1 : -1;
            run({forwards ? 0 : 2, at(i) - at(i - step), last});
        }
        return direction;
    }

    /// The last vertex on the curve; −1 if a further one was refused.
    int follow_curve(bool forwards) {
        DrawnCurve::Place here = m_curve->nearest(m_options.seed);
        int last = 0;
        while (const auto next = m_curve->after(here, m_options.length, forwards)) {
            const DrapedVertex vertex = m_compass.vertex_at(next->position, m_vertices[last].at.face);
            const GridPlace place = m_places[last] + k_steps[forwards ? 0 : 2];
            const int before = find({2 * m_places[last].i - place.i, 0});
            if (before >= 0) check_goes_on(m_vertices[before].position, vertex.position);
            if (!is_allowed(place, vertex, last)) return -1;
            last = add(place, vertex);
            here = *next;
        }
        return last;
    }

    /// Of vertices on the curve with one between them.
    void check_goes_on(const Eigen::Vector3d& before, const Eigen::Vector3d& next) const {
        if ((next - before).norm() >= k_turned_back * m_options.length) return;
        const auto text = [](double number) { return std::to_string(number); };
        throw Error(ErrorCode::bad_option, "the drawn curve turns back along itself near " + text(next.x()) + " " +
                                               text(next.y()) + " " + text(next.z()));
    }

    /// Sets every vertex within so many steps from the seed that has three of a cell's before it.
    void fill(int steps = std::numeric_limits<int>::max()) {
        while (!m_waiting.empty() && m_waiting.top().steps() <= steps) {
            const GridPlace place = m_waiting.top();
            m_waiting.pop();
            for (const Corner& corner : corners_at(place))
                if (const auto vertex = vertex_across(place, corner)) add(place, *vertex);
        }
    }

    /// Three vertices of a cell, a and b next to d.
    struct Corner {
        int d, a, b;
    };

    std::optional<DrapedVertex> vertex_across(const GridPlace& place, const Corner& corner) {
        if (find(place, corner.a) >= 0) return std::nullopt;
        const DrapedVertex &d = m_vertices[corner.d], &a = m_vertices[corner.a], &b = m_vertices[corner.b];
        if (!is_on_surface(d) && !is_on_surface(a) && !is_on_surface(b)) return std::nullopt;
        const auto c = m_compass.across(d, a, b);
        if (!c || !is_within_limit({d.position, a.position, c->position, b.position})) {
            refuse(place, corner.d, Refusal::locked);
            return std::nullopt;
        }
        if (m_compass.is_slit_between(a, *c) || m_compass.is_slit_between(b, *c)) return std::nullopt;
        return is_allowed(place, *c, corner.d) ? c : std::nullopt;
    }

    /// Of the cells at a place whose other three vertices are known: the one nearest to the seed; where there can be
    /// several vertices at a place, all of them, that one first.
    std::vector<Corner> corners_at(const GridPlace& place) const {
        std::vector<Corner> corners;
        for (const GridPlace& diagonal : k_diagonals)
            for (int d = find(place + diagonal); d >= 0; d = m_other_at[d]) {
                const int a = find(place + GridPlace{diagonal.i, 0}, d), b = find(place + GridPlace{0, diagonal.j}, d);
                if (a >= 0 && b >= 0) corners.push_back({d, a, b});
            }
        std::stable_sort(corners.begin(), corners.end(),
                         [&](const Corner& x, const Corner& y) { return m_places[y.d] > m_places[x.d]; });
        const auto is_beside_first = [&](const Corner& corner) { return !are_apart(corner.d, corners.front().d); };
        if (!m_slits && std::all_of(corners.begin(), corners.end(), is_beside_first) && corners.size() > 1)
            corners.erase(corners.begin() + 1, corners.end());
        return corners;
    }

    /// At the rim, where no vertex has three of a cell's before it, the net line nearest to the seed goes one edge
    /// straight on. False if none can.
    bool go_straight_on() {
        while (!m_rim.empty()) {
            const auto [place, from] = m_rim.top();
            m_rim.pop();
            const GridPlace here = m_places[from];
            const int back = find({2 * here.i - place.i, 2 * here.j - place.j}, from);
            if (back < 0 || !is_in_the_open(place, from) || !is_on_surface(m_vertices[from])) continue;
            Eigen::Vector3d direction = m_vertices[from].position - m_vertices[back].position;
            const auto next = m_compass.straight_on(m_vertices[from], direction);
            if (!next || !is_allowed(place, *next, from)) continue;
            add(place, *next);
            return true;
        }
        return false;
    }

    /// Whether nothing is known at a place and around it but `from`, and nothing was refused there.
    bool is_in_the_open(const GridPlace& place, int from) const {
        if (is_known_beside(place, from) || is_refused_beside(place, from)) return false;
        for (const GridPlace& step : k_steps)
            if (is_refused_beside(place + step, from) || is_known_beside(place + step, from)) return false;
        return true;
    }

    /// Whether another vertex than `from` is there, on its part of the net and its side of slits.
    bool is_known_beside(const GridPlace& place, int from) const {
        for (int vertex = find(place); vertex >= 0; vertex = m_other_at[vertex])
            if (vertex != from && are_together(vertex, from)) return true;
        return false;
    }

    /// Whether two vertices are on one part of the net, and on one side of slits.
    bool are_together(int a, int b) const {
        return !are_apart(a, b) && !m_compass.is_slit_between(m_vertices[a], m_vertices[b]);
    }

    bool are_apart(int a, int b) const { return are_apart(m_vertices[a], m_vertices[b]); }
    bool are_apart(const DrapedVertex& a, const DrapedVertex& b) const {
        return (a.position - b.position).squaredNorm() >
               k_other_part * k_other_part * m_options.length * m_options.length;
    }

    /// Of a new vertex, found from one that is known.
    bool is_allowed(const GridPlace& place, const DrapedVertex& vertex, int from) {
        if (std::abs(place.i) > m_options.reach || std::abs(place.j) > m_options.reach) return false;
        if (!is_on_surface(vertex) && is_bound(m_options, slits(), vertex.at)) return false;
        if (meets_net(place, vertex)) {
            refuse(place, from, Refusal::met);
            return false;
        }
        return true;
    }

    const Slits* slits() const { return m_slits ? &*m_slits : nullptr; }

    bool is_on_surface(const DrapedVertex& vertex) const { return m_compass.is_on_surface(vertex); }

    /// Whether a new vertex is not one edge away from a neighbour, or on what other vertices have covered.
    bool meets_net(const GridPlace& place, const DrapedVertex& next) const {
        for (const GridPlace& step : k_steps)
            for (int neighbour = find(place + step); neighbour >= 0; neighbour = m_other_at[neighbour])
                if (!is_one_edge(m_vertices[neighbour], next) && !are_apart(m_vertices[neighbour], next) &&
                    !m_compass.is_slit_between(m_vertices[neighbour], next))
                    return true;
        for (int same = find(place); same >= 0; same = m_other_at[same])
            if (!are_apart(m_vertices[same], next) && !m_compass.is_slit_between(m_vertices[same], next)) return true;
        return m_surroundings.any_near(next.position, [&](int other) {
            const GridPlace& there = m_places[other];
            const Eigen::Vector2i steps(there.i - place.i, there.j - place.j);
            return lie_on_each_other(m_compass, m_vertices[other], next, steps, m_options.smallest_angle);
        });
    }

    bool is_one_edge(const DrapedVertex& a, const DrapedVertex& b) const {
        return std::abs((a.position - b.position).norm() - m_options.length) <= m_compass.tolerance();
    }

    /// Of the corners of a cell.
    bool is_within_limit(const std::array<Eigen::Vector3d, 4>& cell) const {
        return keeps_limit(cell, m_largest_cosine);
    }

    int add(const GridPlace& place, const DrapedVertex& vertex) {
        if (std::ssize(m_vertices) == k_most_draped_vertices) refuse_size();
        const int number = static_cast<int>(m_vertices.size());
        m_vertices.push_back(vertex);
        m_places.push_back(place);
        m_other_at.push_back(find(place));
        m_at[key(place)] = number;
        m_surroundings.add(vertex.position, number);
        accept(place, number);
        const auto wait_for = [&](const GridPlace& next) {
            if (m_slits || !is_known_beside(next, number)) m_waiting.push(next);
        };
        for (const GridPlace& step : k_steps) {
            m_rim.push({place + step, number});
            // Around the end of a slit lines may have gone up to where what is behind them was not known yet.
            const int before = m_slits ? find(place + step, number) : -1;
            if (before >= 0) m_rim.push({place + step + step, before});
            wait_for(place + step);
        }
        for (const GridPlace& diagonal : k_diagonals) wait_for(place + diagonal);
        return number;
    }

    // --------------------------------------------------------------------------------------------------- the result

    Drape result() const {
        Drape drape = draped_net(m_vertices, places(), left_by_border(connected(complete_cells())));
        drape.locked = count(Refusal::locked);
        drape.met = count(Refusal::met);
        return drape;
    }

    BorderCut left_by_border(const std::vector<std::array<int, 4>>& cells) const {
        if (m_options.border == DrapeOptions::Border::cut)
            return cut_at_border(m_compass, m_options.smallest_angle, m_vertices, cells);
        BorderCut whole;
        for (const auto& cell : cells) whole.faces.emplace_back(cell.begin(), cell.end());
        return whole;
    }

    Eigen::Matrix2Xi places() const {
        Eigen::Matrix2Xi places(2, std::ssize(m_places));
        for (std::size_t v = 0; v < m_places.size(); ++v)
            places.col(static_cast<Eigen::Index>(v)) << m_places[v].i, m_places[v].j;
        return places;
    }

    /// Cells of four known vertices, counterclockwise, which keep the limit and have a vertex on the surface. Around
    /// the end of a slit two vertices at one place may both be beside a third: a side is of the first cell that has it.
    std::vector<std::array<int, 4>> complete_cells() const {
        std::vector<std::array<int, 4>> cells;
        std::unordered_set<std::uint64_t> sides;
        for (std::size_t v = 0; v < m_vertices.size(); ++v) {
            const GridPlace& place = m_places[v];
            const int d = static_cast<int>(v);
            const int a = find(place + GridPlace{1, 0}, d), b = find(place + GridPlace{0, 1}, d);
            const std::array<int, 4> cell{d, a, a < 0 ? -1 : find(place + GridPlace{1, 1}, a), b};
            const auto at = [&](int k) { return m_vertices[cell[k]].position; };
            if (*std::min_element(cell.begin(), cell.end()) < 0) continue;
            if (m_compass.is_slit_between(m_vertices[b], m_vertices[cell[2]])) continue;
            if (std::none_of(cell.begin(), cell.end(), [&](int c) { return is_on_surface(m_vertices[c]); })) continue;
            if (!is_within_limit({at(0), at(1), at(2), at(3)})) continue;
            std::array<std::uint64_t, 4> keys{};
            for (std::size_t k = 0; k < 4; ++k) keys[k] = side_key(cell[k], cell[(k + 1) % 4]);
            if (std::any_of(keys.begin(), keys.end(), [&](std::uint64_t side) { return sides.contains(side); }))
                continue;
            sides.insert(keys.begin(), keys.end());
            cells.push_back(cell);
        }
        return cells;
    }

    /// Those that are joined by edges to the first one at the seed.
    std::vector<std::array<int, 4>> connected(const std::vector<std::array<int, 4>>& cells) const {
        std::unordered_map<std::uint64_t, int> cell_at;  // by sides, which run counterclockwise
        cell_at.reserve(4 * cells.size());
        for (std::size_t c = 0; c < cells.size(); ++c)
            for (std::size_t k = 0; k < 4; ++k)
                cell_at.emplace(side_key(cells[c][k], cells[c][(k + 1) % 4]), static_cast<int>(c));
        std::vector<bool> is_reached(cells.size());
        std::vector<int> waiting;
        const auto reach = [&](int cell) {
            if (!is_reached[cell]) waiting.push_back(cell);
            is_reached[cell] = true;
        };
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t c = 0; c < cells.size() && waiting.empty(); ++c)
                if (cells[c][k] == 0) reach(static_cast<int>(c));
        while (!waiting.empty()) {
            const std::array<int, 4>& cell = cells[waiting.back()];
            waiting.pop_back();
            for (std::size_t k = 0; k < 4; ++k) {
                const auto found = cell_at.find(side_key(cell[(k + 1) % 4], cell[k]));
                if (found != cell_at.end()) reach(found->second);
            }
        }
        std::vector<std::array<int, 4>> reached;
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (is_reached[c]) reached.push_back(cells[c]);
        return reached;
    }

    static std::uint64_t side_key(int from, int to) { return key({from, to}); }

    static std::uint64_t key(const GridPlace& place) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(place.i)) << 32 |
               static_cast<std::uint32_t>(place.j);
    }
    int find(const GridPlace& place) const {
        const auto found = m_at.find(key(place));
        return found == m_at.end() ? -1 : found->second;
    }
    /// The vertex at a place next to that of another: of several, the one on its part of the net, and on its side of
    /// slits. −1 if there is none.
    int find(const GridPlace& place, int beside) const {
        int vertex = find(place);
        const DrapedVertex& other = m_vertices[beside];
        while (vertex >= 0 &&
               (!is_one_edge(m_vertices[vertex], other) || m_compass.is_slit_between(m_vertices[vertex], other)))
            vertex = m_other_at[vertex];
        return vertex;
    }
    static std::optional<DrawnCurve> curve_of(const Surface& surface, const SurfaceTree& tree,
                                              const DrapeOptions& options) {
        std::optional<DrawnCurve> curve;
        if (options.arms == DrapeOptions::Arms::curve) curve.emplace(surface, tree, options.along);
        return curve;
    }
    static std::optional<Slits> slits_of(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options) {
        std::optional<Slits> slits;
        if (options.slits) slits.emplace(surface, tree, options.length, options.seam);
        if (slits && slits->none()) slits.reset();
        return slits;
    }

    /// Of a place on the part of the net, and the side of slits, where a vertex is.
    struct Refusal {
        enum Reason { locked, met } reason;
        int beside;
    };
    void refuse(const GridPlace& place, int beside, Refusal::Reason reason) {
        if (!is_refused_beside(place, beside)) m_refused.emplace(key(place), Refusal{reason, beside});
    }
    /// A vertex is there that was found another way.
    void accept(const GridPlace& place, int vertex) {
        for (auto [refusal, end] = m_refused.equal_range(key(place)); refusal != end;)
            refusal = are_together(refusal->second.beside, vertex) ? m_refused.erase(refusal) : std::next(refusal);
    }
    bool is_refused_beside(const GridPlace& place, int vertex) const {
        const auto [begin, end] = m_refused.equal_range(key(place));
        return std::any_of(begin, end, [&](const auto& entry) { return are_together(entry.second.beside, vertex); });
    }
    int count(Refusal::Reason reason) const {
        return static_cast<int>(std::count_if(m_refused.begin(), m_refused.end(),
                                              [&](const auto& entry) { return entry.second.reason == reason; }));
    }

    struct Extension {
        GridPlace place;
        int from;  // a vertex
        bool operator>(const Extension& other) const { return place > other.place; }
    };
    template <class T>
    using Queue = std::priority_queue<T, std::vector<T>, std::greater<>>;

    const DrapeOptions& m_options;
    const BentArms& m_bent;
    std::optional<DrawnCurve> m_curve;  // if the arms of the first family are along one
    std::optional<Slits> m_slits;       // if there are any to keep to
    Compass m_compass;
    std::vector<DrapedVertex> m_vertices;
    std::vector<GridPlace> m_places;
    std::unordered_map<std::uint64_t, int> m_at;  // by places: the last vertex there
    std::vector<int> m_other_at;  // the one before at the same place, beyond a slit or apart; −1 if there is none
    std::unordered_multimap<std::uint64_t, Refusal> m_refused;  // by places
    Surroundings m_surroundings;
    Queue<GridPlace> m_waiting;
    Queue<Extension> m_rim;
    double m_largest_cosine;
};

}  // namespace

void check_drape(const Surface& surface, const DrapeOptions& options) {
    const auto refuse = [](const std::string& what) { throw Error(ErrorCode::bad_option, what); };
    if (!options.seed.allFinite() || !options.direction.allFinite() || !options.along.allFinite())
        throw Error(ErrorCode::non_finite, "the seed, the direction or the curve has a coordinate that is not finite");
    const double size = (surface.positions().rowwise().maxCoeff() - surface.positions().rowwise().minCoeff()).norm();
    if (!(options.length > 1e-6 * size && options.length <= size))
        refuse("the edge length must be between a millionth of the surface's size and that size");
    if (!(options.smallest_angle > 0 && options.smallest_angle < std::numbers::pi / 2))
        refuse("the shear limit must be an angle above 0 and below 90 degrees");
    if (!(options.angle >= options.smallest_angle && options.angle <= std::numbers::pi - options.smallest_angle))
        refuse("the angle at the seed must keep within the shear limit");
    if (options.arms == DrapeOptions::Arms::curve && options.along.cols() < 2)
        refuse("a curve for the arms to run along needs at least two points");
    if (!options.seam.empty() && std::ssize(options.seam) != 3 * surface.face_count())
        refuse("the seam must be told of each side of the surface");
    if (options.reach < 1) refuse("the net must reach at least one cell from the seed");
    // Known beforehand, rather than after minutes; by twice as many, since a part of the surface may not be covered.
    if (options.reach == DrapeOptions{}.reach &&
        surface.area() / (options.length * options.length) > 2.0 * k_most_draped_vertices)
        refuse_size();
}

Drape drape(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options) {
    check_drape(surface, options);
    if (options.arms == DrapeOptions::Arms::least_shear) return least_shear_drape(surface, tree, options);
    return drape_with(surface, tree, options, {});
}

Drape drape_with(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options, const BentArms& bent) {
    Drape drape = Draper(surface, tree, options, bent).run();
    if (options.arms == DrapeOptions::Arms::curve) drape.arms = options.arms;
    return drape;
}

}  // namespace chebnet
