#include "surface/shortest_cut.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/error.h"
#include "surface/geodesics.h"
#include "surface/surface_path.h"
#include "surface/surface_point.h"

namespace chebnet {

namespace {

// Of a side: halvings by the golden section, down to less than snapped() does away with.
constexpr int k_sections = 16;
const double k_golden = (std::sqrt(5.0) - 1) / 2;

// So many sides are looked at closely.
constexpr std::size_t k_most_sides = 8;
// So many pairs of boundary curves are measured, each by a march over the surface.
constexpr std::size_t k_most_measured = 64;

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

/// On those sides that may be nearest, by the distances of their ends over the surface; nothing if none is in reach.
std::optional<Reached> nearest_on(const Surface& surface, const SurfacePoint& from, const std::vector<Loop>& loops) {
    const std::vector<double> distances = geodesic_distances(surface, {{from}});
    std::vector<std::pair<double, int>>
        sides;  // with a bound of their distance: who comes from there reaches both ends
    for (const Loop& loop : loops)
        for (const int side : loop)
            if (const double ends = distances[surface.from(side)] + distances[surface.to(side)]; std::isfinite(ends))
                sides.emplace_back((ends - surface.length_of(side)) / 2, side);
    if (sides.empty()) return std::nullopt;
    std::sort(sides.begin(), sides.end());
    Reached best;
    for (std::size_t k = 0; k < std::min(k_most_sides, sides.size()) && sides[k].first < best.way; ++k)
        if (const Reached here = nearest_on(surface, from, sides[k].second); here.way < best.way) best = here;
    return best;
}

/// The vertex at which a side begins.
SurfacePoint beginning_of(int side) { return point_on(side, 0); }

/// Of two curves of one piece, that are nearest to each other.
struct Pair {
    std::size_t first = 0;   // place of a curve
    SurfacePoint on_second;  // a vertex of another
    double distance = std::numeric_limits<double>::infinity();
};

std::vector<SurfacePoint> beginnings_of(const Loop& loop) {
    std::vector<SurfacePoint> points;
    std::transform(loop.begin(), loop.end(), std::back_inserter(points), beginning_of);
    return points;
}

/// With the vertex of the second that is nearest to the first.
Pair measured(const Surface& surface, const std::vector<Loop>& loops, int first, int second) {
    const std::vector<double> distances = geodesic_distances(surface, beginnings_of(loops[first]));
    Pair pair;
    for (const int side : loops[second])
        if (const double here = distances[surface.from(side)]; here < pair.distance)
            pair = {static_cast<std::size_t>(first), beginning_of(side), here};
    return pair;
}

/// The least of the ways between curves along an edge of which the ends are nearest to one each, longer than those over
/// the surface by no more than triangles are wide; and which curves they are.
using Neighbours = std::map<std::pair<int, int>, double>;

Neighbours neighbours_of(const Surface& surface, const std::vector<Loop>& loops) {
    std::vector<SurfacePoint> sources;
    std::vector<int> loop_of;
    for (std::size_t k = 0; k < loops.size(); ++k)
        for (const SurfacePoint& point : beginnings_of(loops[k])) {
            sources.push_back(point);
            loop_of.push_back(static_cast<int>(k));
        }
    const auto [distances, nearest] = nearest_sources(surface, sources);
    Neighbours neighbours;
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        const int v = surface.from(s), w = surface.to(s);
        if (nearest[v] < 0 || nearest[w] < 0) continue;  // on a piece without border
        const int loop_v = loop_of[nearest[v]], loop_w = loop_of[nearest[w]];
        if (loop_v == loop_w) continue;
        const double way = distances[v] + surface.length_of(s) + distances[w];
        const auto [place, is_new] = neighbours.try_emplace(std::minmax(loop_v, loop_w), way);
        place->second = std::min(place->second, way);
    }
    return neighbours;
}

/// Of curves that are neighbours those with the least ways are measured.
std::optional<Pair> nearest_pair(const Surface& surface, const std::vector<Loop>& loops) {
    std::vector<std::tuple<double, int, int>> candidates;
    for (const auto& [pair, way] : neighbours_of(surface, loops)) candidates.emplace_back(way, pair.first, pair.second);
    std::sort(candidates.begin(), candidates.end());
    Pair best;
    for (std::size_t k = 0; k < std::min(k_most_measured, candidates.size()); ++k) {
        const auto [way, first, second] = candidates[k];
        if (const Pair pair = measured(surface, loops, first, second); pair.distance < best.distance) best = pair;
    }
    if (!std::isfinite(best.distance)) return std::nullopt;
    return best;
}

/// At a part of a path's length.
SurfacePoint point_along(const Surface& surface, const SurfacePath& path, double part) {
    double rest = part * path.length;
    for (std::size_t k = 0; k < path.faces.size(); ++k) {
        const double step = (surface.position_at(path.points[k + 1]) - surface.position_at(path.points[k])).norm();
        if (rest < step) {
            const int face = path.faces[k];
            const double here = rest / step;
            return {face, (1 - here) * *weights_in(surface, path.points[k], face) +
                              here * *weights_in(surface, path.points[k + 1], face)};
        }
        rest -= step;
    }
    return path.points.back();
}

/// A cut along the shortest path, with points at thirds of it. Where the surface is not cut open its ends may be in one
/// place, on both sides of a cut, and nearer to each other through that; there is no such way between thirds.
CutLine with_thirds(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const SurfacePath path = shortest_path(surface, from, to);
    return {from, point_along(surface, path, 1. / 3), point_along(surface, path, 2. / 3), to};
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
    const Reached there = *nearest_on(surface, pair->on_second, {loops[pair->first]});
    std::vector<Loop> others = loops;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(pair->first));
    const Reached back = *nearest_on(surface, there.point, others);
    // Each in the direction in which it was measured: the other way round another path may be found, that is longer.
    return back.way < there.way ? with_thirds(surface, there.point, back.point)
                                : with_thirds(surface, pair->on_second, there.point);
}

}  // namespace chebnet
