#include "remesh/rails.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "remesh/vector_length.h"

namespace chebnet {

namespace {

// A vertex that is so near to a crease, in L, is on it: as the mean of its cells, half of one away on either side, it
// stands off from one at first, by the more the sharper that is.
constexpr double k_on_crease = 0.7;
// The border has a corner where it turns by more than this (a cosine), and the mesh has its own no farther off, in L.
constexpr double k_corner = 0.7, k_near_corner = 1.5;
constexpr double k_pull_of_corner = 30;

class RailFinder {
public:
    RailFinder(const Surface& surface, const Net& mesh, const Topology& topology, const FitOptions& options,
               double length)
        : m_surface(surface), m_mesh(mesh), m_topology(topology), m_options(options), m_length(length) {}

    Rails run() {
        find_border();
        find_corners();
        find_creases();
        return std::move(m_rails);
    }

private:
    void find_border() {
        std::vector<Segment> border, steps;
        for (const std::vector<int>& loop : m_surface.boundary_loops())
            for (const int s : loop) (is_followed(s) ? border : steps).push_back(segment_of(m_surface, s));
        m_rails.border.lines = SegmentTree(std::move(border));
        m_rails.steps.lines = SegmentTree(std::move(steps));
        if (m_rails.border.lines.empty() && m_rails.steps.lines.empty()) return;
        for (int v = 0; v < m_mesh.vertex_count(); ++v)
            if (m_topology.is_boundary(v))
                (distance(m_rails.border, v) <= distance(m_rails.steps, v) ? m_rails.border : m_rails.steps)
                    .vertices.push_back(v);
    }

    bool is_followed(int side) const { return !m_options.border.empty() && m_options.border[side]; }

    /// Infinite from one without lines.
    double distance(const Rail& rail, int vertex) const {
        return rail.lines.empty() ? std::numeric_limits<double>::infinity()
                                  : length_of(way_from(rail, at(vertex)).away);
    }

    Eigen::Vector3d at(int vertex) const { return m_mesh.rest_positions().col(vertex); }

    void find_corners() {
        for (const std::vector<int>& loop : m_surface.boundary_loops())
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Eigen::Vector3d in = vector_of(loop[k]), out = vector_of(loop[(k + 1) % loop.size()]);
                if (is_followed(loop[k]) && in.dot(out) < k_corner * length_of(in) * length_of(out))
                    hold_corner(m_surface.positions().col(m_surface.to(loop[k])));
            }
    }

    Eigen::Vector3d vector_of(int side) const {
        return m_surface.positions().col(m_surface.to(side)) - m_surface.positions().col(m_surface.from(side));
    }

    void hold_corner(const Eigen::Vector3d& point) {
        constexpr int k_straight_valence = 3;
        int best = -1;
        double least = k_near_corner * m_length;
        for (const int v : m_rails.border.vertices) {
            const double distance = length_of(at(v) - point);
            if (m_topology.valence(v) != k_straight_valence && distance < least) best = v, least = distance;
        }
        if (best < 0) return;
        std::erase(m_rails.border.vertices, best);
        m_rails.corners.push_back({best, point, k_pull_of_corner});
    }

    void find_creases() {
        m_rails.creases.lines = SegmentTree(m_options.creases);
        if (m_options.creases.empty()) return;
        std::vector<bool> is_held(static_cast<std::size_t>(m_mesh.vertex_count()), false);  // to something else
        for (const Pull& pull : m_options.pulls) is_held[pull.vertex] = true;
        for (int v = 0; v < m_mesh.vertex_count(); ++v)
            if (!is_held[v] && !m_topology.is_boundary(v) && distance(m_rails.creases, v) < k_on_crease * m_length)
                m_rails.creases.vertices.push_back(v);
    }

    const Surface& m_surface;
    const Net& m_mesh;
    const Topology& m_topology;
    const FitOptions& m_options;
    double m_length;
    Rails m_rails;
};

}  // namespace

WayFromRail way_from(const Rail& rail, const Eigen::Vector3d& point) {
    WayFromRail way;
    if (const int nearest = rail.lines.nearest(point).segment; nearest >= 0) {
        const auto& [from, to] = rail.lines.segments()[nearest];
        way.along = to - from;
        const double fraction = std::clamp((point - from).dot(way.along) / way.along.squaredNorm(), 0.0, 1.0);
        way.away = point - from - fraction * way.along;
    }
    way.along /= length_of(way.along);
    return way;
}

Rails rails_of(const Surface& surface, const Net& mesh, const Topology& topology, const FitOptions& options,
               double length) {
    return RailFinder(surface, mesh, topology, options, length).run();
}

}  // namespace chebnet
