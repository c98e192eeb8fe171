#include "remesh/thin_limbs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <set>
#include <utility>

#include "base/error.h"
#include "remesh/creases.h"
#include "remesh/even_triangles.h"
#include "remesh/pinholes.h"
#include "surface/geodesics.h"
#include "surface/surface_parts.h"

namespace chebnet {

namespace {

// Of the triangles' edges, in cells: balls are round enough.
constexpr double k_limb_triangle = 0.5;
// The triangles around a ball reach beyond it by about this, of their edges: so much sooner it goes around a limb.
constexpr double k_ball_rim = 0.4;
// What hangs on a limb and goes with it has no larger area, in cells, and no larger part of that of the largest piece.
constexpr double k_most_hanging = 400, k_hanging_part = 0.1;
// A limb is no shorter, in cells: what is lower is a bump, and no hard one.
constexpr double k_shortest_limb = 1;
// How finely girths are told apart, and from where on, in cells.
constexpr double k_girth_step = 0.5, k_least_girth = 1;
// Of the area. A surface that has more of them is thin as such.
constexpr double k_most_lost = 1.0 / 3;

/// Finds how balls around the vertices of a surface meet themselves.
class Balls {
public:
    explicit Balls(const Surface& surface)
        : m_surface(surface),
          m_distance(static_cast<std::size_t>(surface.vertex_count())),
          m_reached(m_distance.size(), -1),
          m_settled(m_distance.size(), -1),
          m_counted(m_distance.size(), -1),
          m_counted_faces(static_cast<std::size_t>(surface.face_count()), -1),
          m_counted_sides(3 * m_counted_faces.size(), -1) {}

    /// Whether that of a radius around a vertex goes around a limb, or a handle: it is no disc, for it has a hole.
    /// False where it meets the border.
    bool goes_around(int vertex, double radius) {
        m_radius = radius;
        m_centre = vertex;
        ++m_number;
        spread();
        return characteristic() <= 0;
    }

private:
    void spread() {
        m_inside.clear();
        lower(m_centre, 0);
        while (!m_waiting.empty()) {
            const int v = m_waiting.top().second;
            m_waiting.pop();
            if (is_settled(v)) continue;
            m_settled[v] = m_number;
            m_inside.push_back(v);
            for (const int side : m_surface.sides_around(v))
                for (const int s : {side, Surface::next(side), Surface::previous(side)}) update(s);
        }
    }

    bool is_settled(int vertex) const { return m_settled[vertex] == m_number; }

    void lower(int vertex, double distance) {
        if (distance > m_radius || (m_reached[vertex] == m_number && distance >= m_distance[vertex])) return;
        m_reached[vertex] = m_number;
        m_distance[vertex] = distance;
        m_waiting.push({distance, vertex});
    }

    void update(int side) {
        const int a = m_surface.from(side), b = m_surface.to(side), c = m_surface.from(Surface::previous(side));
        if (is_settled(c) || !(is_settled(a) || is_settled(b))) return;
        const double ca = length(c, a), bc = length(b, c);
        if (!is_settled(b)) return lower(c, m_distance[a] + ca);
        if (!is_settled(a)) return lower(c, m_distance[b] + bc);
        lower(c, distance_across(m_distance[a], m_distance[b], length(a, b), bc, ca));
    }

    double length(int a, int b) const { return (m_surface.positions().col(a) - m_surface.positions().col(b)).norm(); }

    /// Of all triangles at vertices inside: where one vertex alone is farther, there is no hole. 1 where they meet the
    /// border.
    int characteristic() {
        int count = 0;
        for (const int v : m_inside)
            for (const int side : m_surface.sides_around(v)) {
                const int f = Surface::face_of(side);
                if (std::exchange(m_counted_faces[f], m_number) == m_number) continue;
                ++count;
                for (int s = 3 * f; s < 3 * f + 3; ++s) {
                    if (m_surface.opposite(s) < 0) return 1;
                    if (std::exchange(m_counted_sides[std::min(s, m_surface.opposite(s))], m_number) != m_number)
                        --count;
                    if (std::exchange(m_counted[m_surface.from(s)], m_number) != m_number) ++count;
                }
            }
        return count;
    }

    const Surface& m_surface;
    double m_radius = 0;
    int m_centre = -1, m_number = -1;  // of the ball
    std::vector<double> m_distance;
    // Of each, the number of the last ball for which it was.
    std::vector<int> m_reached, m_settled, m_counted, m_counted_faces, m_counted_sides;
    std::vector<int> m_inside;
    using Entry = std::pair<double, int>;  // distance, vertex
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_waiting;
};

/// Which triangles of a surface are of limbs.
class Limbs {
public:
    Limbs(const Surface& surface, double cell, double girth) : m_surface(surface), m_cell(cell), m_girth(girth) {
        mark_thin();
        if (is_any()) complete();
        if (is_any()) keep_what_has_to_stay();
    }

    bool is_any() const { return std::find(m_gone.begin(), m_gone.end(), true) != m_gone.end(); }

    double lost_area() const {
        double sum = 0;
        for (int f = 0; f < m_surface.face_count(); ++f) sum += m_gone[f] ? m_surface.areas()[f] : 0;
        return sum;
    }

    std::vector<ThinLimb> list() const {
        std::vector<ThinLimb> limbs;
        const Pieces regions = pieces(true);
        const std::vector<Measured> measured = measure(regions);
        for (const Measured& limb : measured) limbs.push_back({m_surface.positions().col(limb.farthest), limb.girth()});
        return limbs;
    }

    /// Without them, with caps; nothing if that is no surface.
    std::optional<Surface> rest() const {
        try {
            std::vector<int> part;
            for (const bool gone : m_gone) part.push_back(gone ? -1 : 0);
            const SurfacePart open = std::move(parts_of(m_surface, part, 1).front());
            if (open.surface.vertex_count() != std::ssize(open.vertices)) return std::nullopt;  // cuts touch each other
            std::vector<std::vector<int>> cuts;
            for (std::vector<int>& loop : open.surface.boundary_loops())
                if (!m_surface.is_boundary(open.vertices[open.surface.from(loop.front())]))
                    cuts.push_back(std::move(loop));
            return closed_at(open.surface, cuts);
        } catch (const Error&) {
            return std::nullopt;
        }
    }

private:
    struct Pieces {
        std::vector<int> of_face;  // −1: of none
        int count = 0;
    };
    struct Measured {
        double depth = 0;
        int farthest = -1;
        double girths = 0;  // the sum
        int thin = 0;       // so many
        double girth() const { return girths / std::max(thin, 1); }
    };

    void mark_thin() {
        Balls balls(m_surface);
        m_gone.assign(static_cast<std::size_t>(m_surface.face_count()), false);
        m_girths.assign(static_cast<std::size_t>(m_surface.vertex_count()), 0);
        const auto is_thinner = [&](int vertex, double girth) {
            return balls.goes_around(vertex, (girth / 2 - k_ball_rim * k_limb_triangle) * m_cell);
        };
        for (int v = 0; v < m_surface.vertex_count(); ++v) {
            if (!is_thinner(v, m_girth)) continue;
            m_girths[v] = m_girth;
            while (m_girths[v] > k_least_girth && is_thinner(v, m_girths[v] - k_girth_step))
                m_girths[v] -= k_girth_step;
            for (const int s : m_surface.sides_around(v)) m_gone[Surface::face_of(s)] = true;
        }
    }

    /// With the ends of limbs, and so that what is left is a surface. Nothing comes back, so that this ends.
    void complete() {
        bool goes_on = true;
        while (goes_on) {
            goes_on = take_hanging();
            while (smooth_cuts() || open_touching()) goes_on = true;
        }
    }

    /// Those that are gone, or those that stay, joined along sides.
    Pieces pieces(bool gone) const {
        Pieces found;
        found.of_face.assign(m_gone.size(), -1);
        for (int first = 0; first < m_surface.face_count(); ++first) {
            if (m_gone[first] != gone || found.of_face[first] >= 0) continue;
            std::vector<int> waiting{first};
            found.of_face[first] = found.count;
            while (!waiting.empty()) {
                const int f = waiting.back();
                waiting.pop_back();
                for (int s = 3 * f; s < 3 * f + 3; ++s) {
                    const int other = neighbour(s);
                    if (other < 0 || m_gone[other] != gone || found.of_face[other] >= 0) continue;
                    found.of_face[other] = found.count;
                    waiting.push_back(other);
                }
            }
            ++found.count;
        }
        return found;
    }

    /// −1 at the border.
    int neighbour(int side) const {
        const int opposite = m_surface.opposite(side);
        return opposite < 0 ? -1 : Surface::face_of(opposite);
    }

    bool is_cut(int side) const {
        const int other = neighbour(side);
        return other >= 0 && m_gone[other] != m_gone[Surface::face_of(side)];
    }

    /// Small pieces that are cut off go, too.
    bool take_hanging() {
        const Pieces rest = pieces(false);
        std::vector<double> areas(static_cast<std::size_t>(rest.count), 0);
        std::vector<bool> hangs(areas.size(), false);
        for (int f = 0; f < m_surface.face_count(); ++f) {
            if (rest.of_face[f] < 0) continue;
            areas[rest.of_face[f]] += m_surface.areas()[f];
            for (int s = 3 * f; s < 3 * f + 3; ++s)
                if (is_cut(s)) hangs[rest.of_face[f]] = true;
        }
        const double largest = areas.empty() ? 0 : *std::max_element(areas.begin(), areas.end());
        const double most = std::min(k_most_hanging * m_cell * m_cell, k_hanging_part * largest);
        bool has_taken = false;
        for (int f = 0; f < m_surface.face_count(); ++f) {
            const int piece = rest.of_face[f];
            if (piece >= 0 && hangs[piece] && areas[piece] <= most) m_gone[f] = has_taken = true;
        }
        return has_taken;
    }

    /// No triangle stands out into what is gone.
    bool smooth_cuts() {
        bool has_taken = false;
        for (int f = 0; f < m_surface.face_count(); ++f) {
            if (m_gone[f]) continue;
            const int cut_sides = is_cut(3 * f) + is_cut(3 * f + 1) + is_cut(3 * f + 2);
            if (cut_sides >= 2) m_gone[f] = has_taken = true;
        }
        return has_taken;
    }

    /// Where more than two cut sides end, cuts touch: there all goes.
    bool open_touching() {
        bool has_taken = false;
        for (int v = 0; v < m_surface.vertex_count(); ++v) {
            int cuts = 0;
            for (const int s : m_surface.sides_around(v)) cuts += is_cut(s);
            if (cuts <= 2) continue;
            for (const int s : m_surface.sides_around(v)) m_gone[Surface::face_of(s)] = true;
            has_taken = true;
        }
        return has_taken;
    }

    /// What meets the border of the surface, is no limb on anything, or has handles comes back, and bumps; so do all
    /// bridges where handles would be lost with some.
    void keep_what_has_to_stay() {
        const Pieces regions = pieces(true);
        const std::vector<Measured> measured = measure(regions);
        std::vector<int> euler = characteristics(regions);
        std::vector<bool> stays(measured.size(), false);
        std::vector<int> cuts = cut_counts(regions);
        for (int f = 0; f < m_surface.face_count(); ++f)
            if (m_gone[f] && meets_border(f)) stays[regions.of_face[f]] = true;
        for (int r = 0; r < regions.count; ++r)
            if (cuts[r] == 0 || euler[r] + cuts[r] != 2 || measured[r].depth < k_shortest_limb * m_cell)
                stays[r] = true;
        if (!are_bridges_free(regions, stays))
            for (int r = 0; r < regions.count; ++r)
                if (cuts[r] > 1) stays[r] = true;
        for (int f = 0; f < m_surface.face_count(); ++f)
            if (m_gone[f] && stays[regions.of_face[f]]) m_gone[f] = false;
    }

    bool meets_border(int face) const {
        for (const int v : m_surface.triangles().col(face))
            if (m_surface.is_boundary(v)) return true;
        return false;
    }

    /// V − E + F of each.
    std::vector<int> characteristics(const Pieces& regions) const {
        std::vector<int> result(static_cast<std::size_t>(regions.count), 0);
        for (int f = 0; f < m_surface.face_count(); ++f) {
            if (regions.of_face[f] < 0) continue;
            int& count = result[regions.of_face[f]];
            ++count;
            for (int s = 3 * f; s < 3 * f + 3; ++s)
                if (is_cut(s) || m_surface.opposite(s) < s) --count;
        }
        for (int v = 0; v < m_surface.vertex_count(); ++v)
            for (const int s : m_surface.sides_around(v))
                if (m_gone[Surface::face_of(s)]) {
                    ++result[regions.of_face[Surface::face_of(s)]];
                    break;
                }
        return result;
    }

    /// How many closed cuts each has.
    std::vector<int> cut_counts(const Pieces& regions) const {
        std::vector<int> result(static_cast<std::size_t>(regions.count), 0);
        for (const std::vector<int>& cut : closed_cuts()) ++result[regions.of_face[Surface::face_of(cut.front())]];
        return result;
    }

    /// Walks along the sides of what is gone.
    std::vector<std::vector<int>> closed_cuts() const {
        std::vector<std::vector<int>> cuts;
        std::vector<bool> is_walked(3 * m_gone.size(), false);
        for (int first = 0; first < 3 * m_surface.face_count(); ++first) {
            if (!m_gone[Surface::face_of(first)] || !is_cut(first) || is_walked[first]) continue;
            cuts.emplace_back();
            for (int s = first; !is_walked[s]; s = next_cut(s)) {
                is_walked[s] = true;
                cuts.back().push_back(s);
            }
        }
        return cuts;
    }

    /// Around the end of a cut side within what is gone.
    int next_cut(int side) const {
        int s = Surface::next(side);
        while (!is_cut(s) && m_surface.opposite(s) >= 0) s = Surface::next(m_surface.opposite(s));
        return s;
    }

    /// Pieces that stay and regions that are taken from between them have to form a forest: no handle is cut.
    bool are_bridges_free(const Pieces& regions, const std::vector<bool>& stays) const {
        const Pieces rest = pieces(false);
        std::vector<int> parent(static_cast<std::size_t>(rest.count + regions.count));
        std::iota(parent.begin(), parent.end(), 0);
        const auto root = [&](int node) {
            while (parent[node] != node) node = parent[node];
            return node;
        };
        // What stays joins what it lies between, as often as it does.
        bool is_free = true;
        for (const bool of_staying : {true, false})
            for (const std::vector<int>& cut : closed_cuts()) {
                const int region = regions.of_face[Surface::face_of(cut.front())];
                if (stays[region] != of_staying) continue;
                const int a = root(rest.count + region), b = root(rest.of_face[neighbour(cut.front())]);
                if (a == b && !of_staying) is_free = false;
                parent[a] = b;
            }
        return is_free;
    }

    std::vector<Measured> measure(const Pieces& regions) const {
        std::vector<Measured> result(static_cast<std::size_t>(regions.count));
        std::vector<SurfacePoint> starts;
        for (const std::vector<int>& cut : closed_cuts())
            for (const int s : cut) starts.push_back(Surface::start_of(s));
        const std::vector<double> depths = geodesic_distances(m_surface, starts);
        for (int f = 0; f < m_surface.face_count(); ++f) {
            if (regions.of_face[f] < 0) continue;
            Measured& region = result[regions.of_face[f]];
            for (const int v : m_surface.triangles().col(f)) {
                region.girths += m_girths[v];
                region.thin += m_girths[v] > 0 ? 1 : 0;
                if (std::isfinite(depths[v]) && depths[v] > region.depth) region.depth = depths[v], region.farthest = v;
            }
        }
        return result;
    }

    const Surface& m_surface;
    double m_cell, m_girth;
    std::vector<bool> m_gone;      // of each triangle
    std::vector<double> m_girths;  // of each vertex, in cells; 0: around it nothing is thin
};

}  // namespace

WithoutLimbs without_thin_limbs(const std::shared_ptr<const Guide>& guide, double cell, double girth, double crease) {
    try {
        const Surface even = even_triangles(guide->surface(), guide->tree(), k_limb_triangle * cell,
                                            creases_of(guide->surface(), crease))
                                 .surface;
        const Limbs limbs(even, cell, girth);
        if (!limbs.is_any() || limbs.lost_area() > k_most_lost * even.area()) return {guide};
        std::optional<Surface> rest = limbs.rest();
        if (rest) return {std::make_shared<const Guide>(*std::move(rest)), limbs.list()};
    } catch (const Error&) {  // too thin for even triangles
    }
    return {guide};
}

}  // namespace chebnet
