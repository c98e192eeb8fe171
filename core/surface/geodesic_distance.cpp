#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "surface/geodesics.h"

namespace chebnet {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// The distance at corner c of a triangle with the sides ab, bc, ca from a source in its plane on the other side of ab,
/// which is at the distances da, db from a and b. If the straight way from there does not pass between a and b, the
/// shorter way along an edge.
double distance_across(double da, double db, double ab, double bc, double ca) {
    const double along_edges = std::min(da + ca, db + bc);
    // In a frame with a at the origin and b on the positive x axis.
    const double source_x = (da * da - db * db + ab * ab) / (2 * ab), c_x = (ca * ca - bc * bc + ab * ab) / (2 * ab);
    const double source_depth = std::sqrt(std::max(0.0, da * da - source_x * source_x));
    const double c_height = std::sqrt(std::max(0.0, ca * ca - c_x * c_x));
    if (source_depth + c_height == 0) return along_edges;
    const double crossing = source_x + (c_x - source_x) * source_depth / (source_depth + c_height);
    if (crossing < 0 || crossing > ab) return along_edges;
    return std::min(along_edges, std::hypot(c_x - source_x, c_height + source_depth));
}

class March {
public:
    explicit March(const Surface& surface)
        : m_surface(surface),
          m_distances(static_cast<std::size_t>(surface.vertex_count()), k_infinity),
          m_is_final(m_distances.size()) {}

    void begin_at(const SurfacePoint& source) {
        const Eigen::Vector3d position = m_surface.position_at(source);
        for (const int v : m_surface.triangles().col(source.face))
            lower(v, (m_surface.positions().col(v) - position).norm());
    }

    std::vector<double> run(double most) {
        while (!m_waiting.empty() && m_waiting.top().first <= most) {
            const int vertex = m_waiting.top().second;
            m_waiting.pop();
            if (m_is_final[vertex]) continue;
            m_is_final[vertex] = true;
            go_on_from(vertex);
        }
        for (std::size_t v = 0; v < m_distances.size(); ++v)
            if (!m_is_final[v]) m_distances[v] = k_infinity;
        return std::move(m_distances);
    }

private:
    void lower(int vertex, double distance) {
        if (!(distance < m_distances[vertex])) return;
        m_distances[vertex] = distance;
        m_waiting.push({distance, vertex});
    }

    /// Through all triangles at the vertex, and those across their far sides.
    void go_on_from(int vertex) {
        const int first = m_surface.first_side(vertex);
        for (int side = first; side >= 0;) {
            const int next = Surface::next(side), previous = Surface::previous(side);
            for (const int s : {side, next, previous}) update(s);
            side = m_surface.around(side);
            if (side == first) break;
        }
    }

    /// The corner across from a side, by what is known at its ends.
    void update(int side) {
        const int a = m_surface.from(side), b = m_surface.to(side), c = m_surface.from(Surface::previous(side));
        if (m_is_final[c]) return;
        if (m_is_final[a] && m_is_final[b])
            lower(c, distance_across(m_distances[a], m_distances[b], length(a, b), length(b, c), length(c, a)));
        else if (m_is_final[a])
            lower(c, m_distances[a] + length(a, c));
        else if (m_is_final[b])
            lower(c, m_distances[b] + length(b, c));
    }

    double length(int a, int b) const { return (m_surface.positions().col(a) - m_surface.positions().col(b)).norm(); }

    using Entry = std::pair<double, int>;  // distance, vertex
    const Surface& m_surface;
    std::vector<double> m_distances;
    std::vector<bool> m_is_final;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_waiting;
};

}  // namespace

std::vector<double> geodesic_distances(const Surface& surface, std::span<const SurfacePoint> sources, double most) {
    March march(surface);
    for (const SurfacePoint& source : sources) march.begin_at(source);
    return march.run(most);
}

}  // namespace chebnet
