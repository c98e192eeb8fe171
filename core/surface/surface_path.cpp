#include "surface/surface_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace chebnet {

namespace {

constexpr double k_snap_to_corner = 1e-3;
// A detour is worth taking if the path gets shorter by more than this part of it.
constexpr double k_shorter = 1e-9;

using Strip = std::vector<int>;  // triangles, each with a side in common with the next

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Eigen::Vector3d middle_of(const Surface& surface, int face) {
    return surface.position_at({face, Eigen::Vector3d::Constant(1. / 3)});
}

int corner_of(const Surface& surface, int face, int vertex) {
    for (int k = 0; k < 3; ++k)
        if (surface.triangles()(k, face) == vertex) return k;
    return -1;
}

/// The side by which one triangle of a strip is left for the next.
int side_between(const Surface& surface, int face, int next) {
    for (int side = 3 * face; side < 3 * face + 3; ++side)
        if (surface.opposite(side) >= 0 && Surface::face_of(surface.opposite(side)) == next) return side;
    return -1;
}

/// The triangles on the shortest way from middle to middle over those of the edges between (A*, Hart et al. 1968).
/// Empty if there is none.
Strip strip_between(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const Eigen::Vector3d target = surface.position_at(to);
    struct Step {
        double way;
        int before;
    };
    using Entry = std::pair<double, int>;  // the least that the whole way can be, triangle
    std::unordered_map<int, Step> reached{{from.face, {0, -1}}};
    std::unordered_map<int, bool> is_final;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    waiting.push({0, from.face});
    while (!waiting.empty()) {
        const int face = waiting.top().second;
        waiting.pop();
        if (!is_final.emplace(face, true).second) continue;
        if (face == to.face) break;
        const Eigen::Vector3d here = face == from.face ? surface.position_at(from) : middle_of(surface, face);
        for (int side = 3 * face; side < 3 * face + 3; ++side) {
            if (surface.opposite(side) < 0) continue;
            const int next = Surface::face_of(surface.opposite(side));
            const Eigen::Vector3d edge =
                (surface.positions().col(surface.from(side)) + surface.positions().col(surface.to(side))) / 2;
            const Eigen::Vector3d there = middle_of(surface, next);
            const double way = reached.at(face).way + (edge - here).norm() + (there - edge).norm();
            const auto [known, is_new] = reached.try_emplace(next, Step{way, face});
            if (!is_new && way >= known->second.way) continue;
            known->second = {way, face};
            waiting.push({way + (target - there).norm(), next});
        }
    }
    if (!is_final.contains(to.face)) return {};
    Strip strip;
    for (int face = to.face; face >= 0; face = reached.at(face).before) strip.push_back(face);
    std::reverse(strip.begin(), strip.end());
    return strip;
}

/// The vertices on the shortest way along edges, from the triangle of one point to that of another (Dijkstra 1959).
/// Empty if there is none.
std::vector<int> vertices_between(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const auto to_corner = [&](const SurfacePoint& point, int vertex) {
        return (surface.position_at(point) - surface.positions().col(vertex)).norm();
    };
    struct Step {
        double way;
        int before;
    };
    using Entry = std::tuple<double, int, bool>;  // the whole way to here, a vertex, and whether it ends there
    std::unordered_map<int, Step> reached;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    const auto reach = [&](int vertex, const Step& step) {
        const auto [known, is_new] = reached.try_emplace(vertex, step);
        if (!is_new && step.way >= known->second.way) return;
        known->second = step;
        waiting.push({step.way, vertex, false});
    };
    for (const int vertex : surface.triangles().col(from.face)) reach(vertex, {to_corner(from, vertex), -1});
    while (!waiting.empty()) {
        const auto [way, vertex, ends_here] = waiting.top();
        waiting.pop();
        if (ends_here) {
            std::vector<int> vertices;
            for (int v = vertex; v >= 0; v = reached.at(v).before) vertices.push_back(v);
            std::reverse(vertices.begin(), vertices.end());
            return vertices;
        }
        if (way > reached.at(vertex).way) continue;
        if (corner_of(surface, to.face, vertex) >= 0) waiting.push({way + to_corner(to, vertex), vertex, true});
        for (const int side : surface.sides_around(vertex)) {
            reach(surface.to(side), {way + surface.length_of(side), vertex});
            const int back = Surface::previous(side);  // at the boundary no other side goes along its edge
            reach(surface.from(back), {way + surface.length_of(back), vertex});
        }
    }
    return {};
}

/// The triangles beside the shortest way along edges: no path within them that is pulled taut is longer.
Strip strip_along_edges(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const std::vector<int> vertices = vertices_between(surface, from, to);
    Strip strip{from.face};
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const auto is_there = [&](int face) {
            return k + 1 < vertices.size() ? corner_of(surface, face, vertices[k + 1]) >= 0 : face == to.face;
        };
        std::vector<int> faces = surface.faces_around(vertices[k]);
        auto here = std::find(faces.begin(), faces.end(), strip.back());
        if (!surface.is_boundary(vertices[k])) {
            std::rotate(faces.begin(), here, faces.end());
            here = faces.begin();
        }
        auto there = std::find_if(here, faces.end(), is_there);
        if (there == faces.end()) {  // at the boundary, on the other side
            std::reverse(faces.begin(), faces.end());
            here = std::find(faces.begin(), faces.end(), strip.back());
            there = std::find_if(here, faces.end(), is_there);
        }
        strip.insert(strip.end(), here + 1, there + 1);
    }
    return strip;
}

/// Without loops, and without triangles at its ends that the path need not enter.
Strip tidied(const Surface& surface, const Strip& strip, const SurfacePoint& from, const SurfacePoint& to) {
    Strip tidy;
    for (const int face : strip) {
        const auto before = std::find(tidy.begin(), tidy.end(), face);
        if (before != tidy.end()) tidy.erase(before, tidy.end());
        if (weights_in(surface, from, face)) tidy.clear();
        tidy.push_back(face);
        if (weights_in(surface, to, face)) break;
    }
    return tidy;
}

/// A strip unfolded into a plane, and the shortest path within it.
class Taut {
public:
    Taut(const Surface& surface, const Strip& strip, const SurfacePoint& from, const SurfacePoint& to)
        : m_surface(surface), m_strip(strip), m_from(from), m_to(to) {
        unfold();
        pull();
    }

    double length() const {
        double length = 0;
        for (std::size_t k = 1; k < m_bends.size(); ++k) length += (m_bends[k].at - m_bends[k - 1].at).norm();
        return length;
    }

    /// Vertices at which the path bends.
    std::vector<int> vertices() const {
        std::vector<int> vertices;
        for (std::size_t k = 1; k + 1 < m_bends.size(); ++k) vertices.push_back(m_bends[k].vertex);
        return vertices;
    }

    SurfacePath path() const {
        SurfacePath path{{{m_strip.front(), *weights_in(m_surface, m_from, m_strip.front())}}, {}, length()};
        std::size_t bend = 1;
        for (std::size_t k = 0; k + 1 < m_strip.size(); ++k) {
            while (m_bends[bend].portal < static_cast<int>(k)) ++bend;
            add(path, m_strip[k], on_portal(k, m_bends[bend - 1].at, m_bends[bend].at));
        }
        add(path, m_strip.back(), {m_strip.back(), *weights_in(m_surface, m_to, m_strip.back())});
        return path;
    }

private:
    struct Portal {  // between two triangles, as seen on the way
        Eigen::Vector2d left, right;
        int side;
    };
    struct Bend {
        Eigen::Vector2d at;
        int portal;  // the last one with this end, or the one behind
        int vertex;
    };

    /// The third corner of a triangle whose side lies from a to b, on the left of it.
    Eigen::Vector2d apex(int side, const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
        const double ab = m_surface.length_of(side), ca = m_surface.length_of(Surface::previous(side)),
                     bc = m_surface.length_of(Surface::next(side));
        const double x = (ab * ab + ca * ca - bc * bc) / (2 * ab), y = std::sqrt(std::max(0.0, ca * ca - x * x));
        const Eigen::Vector2d along = (b - a) / ab;
        return a + x * along + y * Eigen::Vector2d(-along.y(), along.x());
    }

    void unfold() {
        int side = 3 * m_strip.front();
        std::array<Eigen::Vector2d, 3> corners;  // of the triangle at hand, by its own corners
        const auto lay = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
            corners[side % 3] = a;
            corners[Surface::next(side) % 3] = b;
            corners[Surface::previous(side) % 3] = apex(side, a, b);
        };
        const auto place = [&](const SurfacePoint& point, int face) -> Eigen::Vector2d {
            const Eigen::Vector3d weights = *weights_in(m_surface, point, face);
            return weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
        };
        lay(Eigen::Vector2d::Zero(), {m_surface.length_of(side), 0});
        m_start = place(m_from, m_strip.front());
        for (std::size_t k = 0; k + 1 < m_strip.size(); ++k) {
            const int out = side_between(m_surface, m_strip[k], m_strip[k + 1]);
            const Portal portal{corners[Surface::next(out) % 3], corners[out % 3], out};
            m_portals.push_back(portal);
            side = m_surface.opposite(out);
            lay(portal.left, portal.right);
        }
        m_end = place(m_to, m_strip.back());
    }

    /// The funnel from the last bend to the portal at hand; where its sides would cross, the path bends.
    void pull() {
        const int count = static_cast<int>(m_portals.size());
        m_bends = {{m_start, -1, -1}};
        Eigen::Vector2d apex = m_start, left = m_start, right = m_start;
        int at_left = -1, at_right = -1;
        for (int k = 0; k <= count; ++k) {
            const Eigen::Vector2d next_left = k < count ? m_portals[k].left : m_end,
                                  next_right = k < count ? m_portals[k].right : m_end;
            const auto bend_at = [&](const Eigen::Vector2d& at, int portal, bool is_left) {
                k = portal;
                if (portal == count) return;  // the end, which is both sides of its portal
                const int side = m_portals[portal].side;
                m_bends.push_back({at, portal, is_left ? m_surface.to(side) : m_surface.from(side)});
                apex = left = right = at;
                at_left = at_right = portal;
            };
            if (cross(right - apex, next_right - apex) >= 0) {
                if (apex == right || cross(left - apex, next_right - apex) < 0) {
                    right = next_right;
                    at_right = k;
                } else {
                    bend_at(left, at_left, true);
                    continue;
                }
            }
            if (cross(left - apex, next_left - apex) <= 0) {
                if (apex == left || cross(right - apex, next_left - apex) > 0) {
                    left = next_left;
                    at_left = k;
                } else {
                    bend_at(right, at_right, false);
                    continue;
                }
            }
        }
        m_bends.push_back({m_end, count, -1});
    }

    /// Where the straight way from a to b crosses a portal.
    SurfacePoint on_portal(std::size_t k, const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
        const Portal& portal = m_portals[k];
        const double before = cross(b - a, portal.right - a), behind = cross(b - a, portal.left - a);
        double part = before == behind ? 0.5 : std::clamp(before / (before - behind), 0.0, 1.0);
        if (before == behind)  // all on one line
            part = (portal.right - a).norm() < (portal.left - a).norm() ? 0 : 1;
        SurfacePoint point{m_strip[k], Eigen::Vector3d::Zero()};
        point.weights[portal.side % 3] = 1 - part;
        point.weights[Surface::next(portal.side) % 3] = part;
        return snapped(point);
    }

    /// Unless the path is there already, as at a vertex that several portals have in common.
    void add(SurfacePath& path, int face, const SurfacePoint& point) const {
        const SurfacePoint& last = path.points.back();
        const auto weights = weights_in(m_surface, last, point.face);
        if (weights && *weights == point.weights) return;
        path.points.push_back(point);
        path.faces.push_back(face);
    }

    const Surface& m_surface;
    const Strip& m_strip;
    SurfacePoint m_from, m_to;
    Eigen::Vector2d m_start, m_end;
    std::vector<Portal> m_portals;
    std::vector<Bend> m_bends;
};

/// The strip led along the other side of a vertex; nothing at the boundary.
std::optional<Strip> around_other_side(const Surface& surface, const Strip& strip, int vertex) {
    if (surface.is_boundary(vertex)) return std::nullopt;
    const auto has_vertex = [&](int face) { return corner_of(surface, face, vertex) >= 0; };
    const auto first = std::find_if(strip.begin(), strip.end(), has_vertex);
    const auto last = std::find_if_not(first, strip.end(), has_vertex) - 1;
    if (first == last) return std::nullopt;
    Strip around;  // counterclockwise
    for (const int side : surface.sides_from(3 * *first + corner_of(surface, *first, vertex)))
        around.push_back(Surface::face_of(side));
    if (around[1] == first[1]) std::reverse(around.begin() + 1, around.end());
    Strip other(strip.begin(), first);
    for (const int face : around) {
        other.push_back(face);
        if (face == *last) break;
    }
    other.insert(other.end(), last + 1, strip.end());
    return other;
}

/// The strip beside one of the bends within which there is a shorter path; nothing if there is none.
std::optional<Strip> shorter_strip(const Surface& surface, const Strip& strip, const SurfacePoint& from,
                                   const SurfacePoint& to) {
    const Taut taut(surface, strip, from, to);
    for (const int vertex : taut.vertices()) {
        const std::optional<Strip> other = around_other_side(surface, strip, vertex);
        if (!other) continue;
        const Strip tidy = tidied(surface, *other, from, to);
        if (Taut(surface, tidy, from, to).length() < (1 - k_shorter) * taut.length()) return tidy;
    }
    return std::nullopt;
}

/// The locally shortest path that is found from a strip on.
SurfacePath pulled_taut(const Surface& surface, const Strip& begun_with, const SurfacePoint& from,
                        const SurfacePoint& to) {
    Strip strip = tidied(surface, begun_with, from, to);
    while (const std::optional<Strip> shorter = shorter_strip(surface, strip, from, to)) strip = *shorter;
    return Taut(surface, strip, from, to).path();
}

}  // namespace

SurfacePoint snapped(const SurfacePoint& point) {
    SurfacePoint near = point;
    for (double& weight : near.weights)
        if (weight < k_snap_to_corner) weight = 0;
    near.weights /= near.weights.sum();
    return near;
}

std::optional<Eigen::Vector3d> weights_in(const Surface& surface, const SurfacePoint& point, int face) {
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        if (point.weights[k] == 0) continue;
        const int corner = corner_of(surface, face, surface.triangles()(k, point.face));
        if (corner < 0) return std::nullopt;
        weights[corner] = point.weights[k];
    }
    return weights;
}

SurfacePath shortest_path(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const SurfacePoint start = snapped(from), end = snapped(to);
    const Strip over_middles = strip_between(surface, start, end);
    if (over_middles.empty()) return {};
    SurfacePath path = pulled_taut(surface, over_middles, start, end),
                along_edges = pulled_taut(surface, strip_along_edges(surface, start, end), start, end);
    return along_edges.length < (1 - k_shorter) * path.length ? along_edges : path;
}

}  // namespace chebnet
