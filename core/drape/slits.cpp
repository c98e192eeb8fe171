#include "drape/slits.h"

#include <limits>

#include "base/error.h"
#include "surface/geodesics.h"
#include "surface/surface_cut.h"

namespace chebnet {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
// A weight below it counts as 0.
constexpr double k_on_side = 1e-9;
// Triangles no farther from a slit than so many edges of the net are near it.
constexpr double k_near_slit = 3;
// In edges of the net: a way that comes so near to a point of a bank has reached it. No rod ends in a shorter stub.
constexpr double k_reached = 0.05;

}  // namespace

Slits::Slits(const Surface& surface, const SurfaceTree& tree, double reach, const std::vector<bool>& seam)
    : m_surface(surface), m_tree(tree), m_reach(reach) {
    find_banks(seam);
    if (!none()) find_near();
}

/// Sides that face another, or another surface, and their vertices, numbered by runs along the boundary. At the end of
/// a slit it turns back.
void Slits::find_banks(const std::vector<bool>& seam) {
    const std::vector<int> facing = facing_sides(m_surface);
    const auto is_cut = [&](int side) { return facing[side] >= 0 || (!seam.empty() && seam[side]); };
    const auto turns_back = [&](int side, int next) { return facing[side] == next; };
    int bank = 0;
    for (const std::vector<int>& loop : m_surface.boundary_loops()) {
        const std::size_t n = loop.size();
        std::size_t start = 0;  // behind a place where no bank goes on
        for (std::size_t k = 0; k < n; ++k)
            if (!is_cut(loop[k]) || turns_back(loop[k], loop[(k + 1) % n])) start = (k + 1) % n;
        ++bank;
        for (std::size_t k = 0; k < n; ++k) {
            const int side = loop[(start + k) % n], next = loop[(start + k + 1) % n];
            if (!is_cut(side)) {
                ++bank;
                continue;
            }
            if (none()) {
                m_bank_of.assign(static_cast<std::size_t>(m_surface.vertex_count()), 0);
                m_bank_along.assign(3 * static_cast<std::size_t>(m_surface.face_count()), 0);
            }
            m_bank_along[side] = bank;
            const int before = loop[(start + k + n - 1) % n];
            if (!turns_back(before, side)) m_bank_of[m_surface.from(side)] = bank;
            if (turns_back(side, next))
                ++bank;
            else
                m_bank_of[m_surface.to(side)] = bank;
        }
    }
}

void Slits::find_near() {
    std::vector<SurfacePoint> sources;
    for (int side = 0; side < 3 * m_surface.face_count(); ++side)
        if (m_bank_along[side] > 0)
            for (const int end : {side, Surface::next(side)}) sources.push_back(Surface::start_of(end));
    const std::vector<double> distances = geodesic_distances(m_surface, sources, k_near_slit * m_reach);
    m_is_near.resize(static_cast<std::size_t>(m_surface.face_count()));
    for (int f = 0; f < m_surface.face_count(); ++f)
        for (const int corner : m_surface.triangles().col(f))
            m_is_near[f] = m_is_near[f] || distances[corner] < k_infinity;
}

int Slits::bank_of(const SurfacePoint& point) const {
    int corner = 0, across = 0;
    switch ((point.weights.array() > k_on_side).count()) {
        case 1:
            point.weights.maxCoeff(&corner);
            return m_bank_of[m_surface.triangles()(corner, point.face)];
        case 2:
            // Not by the ends of the side: ordinary border may begin at a bank.
            point.weights.minCoeff(&across);
            return m_bank_along[Surface::next(3 * point.face + across)];
        default:
            return 0;
    }
}

SurfaceTree::Nearest Slits::nearest(const Eigen::Vector3d& point, int from) const {
    if (none() || !m_is_near[from]) return m_tree.nearest(point, from);
    const SurfaceTree::Nearest near = descended(point, from);
    // What ends at no slit may have ended in a fold.
    return bank_of(near.at) > 0 ? near : m_tree.nearest(point, near.at.face);
}

/// From triangle to triangle as long as that leads nearer to a point.
SurfaceTree::Nearest Slits::descended(const Eigen::Vector3d& point, int from) const {
    SurfaceTree::Nearest best = m_tree.nearest_in(from, point);
    for (bool is_better = true; is_better;) {
        is_better = false;
        const SurfacePoint here = best.at;
        for (int k = 0; k < 3; ++k) {
            if (here.weights[k] == 0) continue;
            // All triangles around the corners between which the point is.
            if ((here.weights.array() == 0).count() == 0) break;
            for (const int side : m_surface.sides_around(m_surface.triangles()(k, here.face))) {
                const SurfaceTree::Nearest next = m_tree.nearest_in(Surface::face_of(side), point);
                if (next.distance < best.distance) best = next, is_better = true;
            }
        }
    }
    return best;
}

/// Whether the straight way from a vertex on the surface to another ends at a bank before it is there.
bool Slits::runs_into_bank(const DrapedVertex& from, const DrapedVertex& to) const {
    const int bank_to = bank_of(to.at);
    const Eigen::Vector3d target = bank_to > 0 ? m_surface.position_at(to.at) : to.position;
    const Eigen::Vector3d direction = target - m_surface.position_at(from.at);
    try {
        GeodesicWalk walk(m_surface, from.at, direction);
        // A little farther, as rounding would else decide whether what stands on a slit is before it.
        double rest = (1 + k_on_side) * direction.norm();
        while (rest > 0 && !walk.is_at_boundary()) rest -= walk.advance(rest);
        const int bank = walk.is_at_boundary() ? bank_of(walk.point()) : 0;
        return bank > 0 && (bank != bank_to || rest > k_reached * m_reach);
    } catch (const Error&) {
        return false;  // straight above each other
    }
}

/// Whether a way from triangle to triangle leads from a vertex to where another stands on a bank, and not just to that
/// bank: where a slit is bent, it may do so on another arm.
bool Slits::reaches_bank(const DrapedVertex& from, const DrapedVertex& banked) const {
    const SurfaceTree::Nearest end = descended(m_surface.position_at(banked.at), from.at.face);
    return bank_of(end.at) == bank_of(banked.at) && end.distance <= k_reached * m_reach;
}

bool Slits::part(const DrapedVertex& a, const DrapedVertex& b) const {
    if (none() || (!m_is_near[a.at.face] && !m_is_near[b.at.face])) return false;
    const int bank_a = bank_of(a.at), bank_b = bank_of(b.at);
    if (bank_a > 0 && bank_a == bank_b) return !reaches_bank(a, b);
    // Where a slit ends near the bank, the way that leads there may go round its end, the straight one across.
    if (bank_b > 0) return !reaches_bank(a, b) || runs_into_bank(a, b);
    if (bank_a > 0) return !reaches_bank(b, a) || runs_into_bank(b, a);
    return runs_into_bank(a, b);
}

}  // namespace chebnet
