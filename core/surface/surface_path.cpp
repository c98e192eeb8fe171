#include "surface/surface_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "surface/strip.h"
#include "surface/surface_point.h"

namespace chebnet {

namespace {

// A detour is worth taking if the path gets shorter by more than this part of it.
constexpr double k_shorter = 1e-9;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The side by which one triangle of a strip is left for the next.
int side_between(const Surface& surface, int face, int next) {
    for (int side = 3 * face; side < 3 * face + 3; ++side)
        if (surface.opposite(side) >= 0 && Surface::face_of(surface.opposite(side)) == next) return side;
    return -1;
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

SurfacePath shortest_path(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const SurfacePoint start = snapped(from), end = snapped(to);
    const Strip over_middles = strip_over_middles(surface, start, end);
    if (over_middles.empty()) return {};
    SurfacePath path = pulled_taut(surface, over_middles, start, end),
                along_edges = pulled_taut(surface, strip_along_edges(surface, start, end), start, end);
    return along_edges.length < (1 - k_shorter) * path.length ? along_edges : path;
}

}  // namespace chebnet
