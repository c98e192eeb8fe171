#include "surface/shortest_cut.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "surface/geodesics.h"
#include "surface/surface_path.h"

namespace chebnet {

namespace {

// Of a side: halvings by the golden section, down to less than snapped() does away with.
constexpr int k_sections = 16;
const double k_golden = (std::sqrt(5.0) - 1) / 2;

using Loop = std::vector<int>;  // sides along a boundary curve

SurfacePoint point_on(int side, double part) {
    SurfacePoint point{Surface::face_of(side), Eigen::Vector3d::Zero()};
    point.weights[side % 3] = 1 - part;
    point.weights[Surface::next(side) % 3] = part;
    return snapped(point);
}

struct Reached {
    SurfacePoint point;
    double way = std::numeric_limits<double>::infinity();
};

/// The point of a side that is nearest to `from`: along it the way gets shorter and then longer, or one of both.
Reached nearest_on(const Surface& surface, const SurfacePoint& from, int side) {
    const auto way = [&](double part) { return shortest_path(surface, from, point_on(side, part)).length; };
    double low = 0, high = 1;
    double a = 1 - k_golden, b = k_golden, way_a = way(a), way_b = way(b);
    for (int k = 0; k < k_sections; ++k) {
        const bool is_left = way_a < way_b;
        (is_left ? high : low) = is_left ? b : a;
        if (is_left) {
            b = a, way_b = way_a;
            a = high - k_golden * (high - low), way_a = way(a);
        } else {
            a = b, way_a = way_b;
            b = low + k_golden * (high - low), way_b = way(b);
        }
    }
    Reached best{point_on(side, 0), way(0)};
    for (const double part : {1.0, (low + high) / 2})
        if (const double here = way(part); here < best.way) best = {point_on(side, part), here};
    return best;
}

/// On the sides at the vertex that is nearest by distances over the surface; nothing if none is in reach.
std::optional<Reached> nearest_on(const Surface& surface, const SurfacePoint& from, const std::vector<Loop>& loops) {
    const std::vector<double> distances = geodesic_distances(surface, {{from}});
    double least = std::numeric_limits<double>::infinity();
    int before = -1, behind = -1;
    for (const Loop& loop : loops)
        for (std::size_t k = 0; k < loop.size(); ++k)
            if (const double here = distances[surface.from(loop[k])]; here < least) {
                least = here;
                before = loop[(k + loop.size() - 1) % loop.size()];
                behind = loop[k];
            }
    if (behind < 0) return std::nullopt;
    const Reached a = nearest_on(surface, from, before), b = nearest_on(surface, from, behind);
    return a.way < b.way ? a : b;
}

/// The vertex at which a side begins.
SurfacePoint beginning_of(int side) { return point_on(side, 0); }

/// Of the sides of one curve, the beginning that is nearest to another.
SurfacePoint nearest_beginning(const Surface& surface, const Loop& from, const Loop& on) {
    std::vector<SurfacePoint> sources;
    std::transform(from.begin(), from.end(), std::back_inserter(sources), beginning_of);
    const std::vector<double> distances = geodesic_distances(surface, sources);
    return beginning_of(*std::min_element(
        on.begin(), on.end(), [&](int a, int b) { return distances[surface.from(a)] < distances[surface.from(b)]; }));
}

/// Of two curves of one piece, that are nearest to each other.
struct Pair {
    std::size_t first = 0;   // place of a curve
    SurfacePoint on_second;  // a vertex of another
};

/// Of each vertex the place of the curve that it is nearest to: that of the neighbour by which its distance came. −1 on
/// pieces without one.
std::vector<int> nearest_loops(const Surface& surface, const std::vector<Loop>& loops,
                               const std::vector<double>& distances) {
    std::vector<int> nearest(static_cast<std::size_t>(surface.vertex_count()), -1), neighbours = nearest;
    std::vector<double> ways(nearest.size(), std::numeric_limits<double>::infinity());
    for (int s = 0; s < 3 * surface.face_count(); ++s)
        for (const auto& [v, w] :
             {std::pair(surface.from(s), surface.to(s)), std::pair(surface.to(s), surface.from(s))})
            if (const double way = distances[w] + surface.length_of(s); distances[w] < distances[v] && way < ways[v])
                ways[v] = way, neighbours[v] = w;
    for (std::size_t k = 0; k < loops.size(); ++k)
        for (const int side : loops[k]) nearest[surface.from(side)] = static_cast<int>(k);
    std::vector<int> outwards(nearest.size());
    std::iota(outwards.begin(), outwards.end(), 0);
    std::stable_sort(outwards.begin(), outwards.end(), [&](int v, int w) { return distances[v] < distances[w]; });
    for (const int v : outwards)
        if (nearest[v] < 0 && neighbours[v] >= 0) nearest[v] = nearest[neighbours[v]];
    return nearest;
}

/// The way between them goes over an edge between what is nearest to the one and what is nearest to the other.
std::optional<Pair> nearest_pair(const Surface& surface, const std::vector<Loop>& loops) {
    std::vector<SurfacePoint> sources;
    for (const Loop& loop : loops) std::transform(loop.begin(), loop.end(), std::back_inserter(sources), beginning_of);
    if (sources.empty()) return std::nullopt;
    const std::vector<double> distances = geodesic_distances(surface, sources);
    const std::vector<int> nearest = nearest_loops(surface, loops, distances);
    double least = std::numeric_limits<double>::infinity();
    std::pair<int, int> pair;
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        const int v = surface.from(s), w = surface.to(s);
        const double way = distances[v] + surface.length_of(s) + distances[w];
        if (nearest[v] == nearest[w] || !(way < least)) continue;
        least = way;
        pair = std::minmax(nearest[v], nearest[w]);
    }
    if (!std::isfinite(least)) return std::nullopt;
    return Pair{static_cast<std::size_t>(pair.first),
                nearest_beginning(surface, loops[pair.first], loops[pair.second])};
}

}  // namespace

CutLine shortest_cut_to_border(const Surface& surface, const SurfacePoint& from) {
    const std::optional<Reached> reached = nearest_on(surface, snapped(from), surface.boundary_loops());
    if (!reached) throw Error(ErrorCode::bad_option, "there is no border that a cut could go to");
    if (!(reached->way > 0)) throw Error(ErrorCode::bad_option, "a cut to the border cannot begin on it");
    return {from, reached->point};
}

CutLine shortest_cut_between_borders(const Surface& surface) {
    const std::vector<Loop> loops = surface.boundary_loops();
    const std::optional<Pair> pair = nearest_pair(surface, loops);
    if (!pair) throw Error(ErrorCode::bad_option, "the surface has no two borders that a cut could join");
    const SurfacePoint end = nearest_on(surface, pair->on_second, {loops[pair->first]})->point;
    std::vector<Loop> others = loops;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(pair->first));
    return {end, nearest_on(surface, end, others)->point};
}

}  // namespace chebnet
