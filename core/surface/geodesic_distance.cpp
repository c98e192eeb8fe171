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

class March {
public:
    explicit March(const Surface& surface)
        : m_surface(surface),
          m_nearest{std::vector<double>(static_cast<std::size_t>(surface.vertex_count()), k_infinity),
                    std::vector<int>(static_cast<std::size_t>(surface.vertex_count()), -1)},
          m_is_final(m_nearest.distances.size()) {}

    NearestSources run(std::span<const SurfacePoint> sources, double most) {
        for (std::size_t k = 0; k < sources.size(); ++k) begin_at(sources[k], static_cast<int>(k));
        while (!m_waiting.empty() && m_waiting.top().first <= most) {
            const int vertex = m_waiting.top().second;
            m_waiting.pop();
            if (m_is_final[vertex]) continue;
            m_is_final[vertex] = true;
            go_on_from(vertex);
        }
        for (std::size_t v = 0; v < m_is_final.size(); ++v)
            if (!m_is_final[v]) m_nearest.distances[v] = k_infinity, m_nearest.sources[v] = -1;
        return std::move(m_nearest);
    }

private:
    void begin_at(const SurfacePoint& source, int number) {
        const Eigen::Vector3d position = m_surface.position_at(source);
        for (const int v : m_surface.triangles().col(source.face))
            lower(v, (m_surface.positions().col(v) - position).norm(), number);
    }

    void lower(int vertex, double distance, int source) {
        if (!(distance < distance_of(vertex))) return;
        m_nearest.distances[vertex] = distance;
        m_nearest.sources[vertex] = source;
        m_waiting.push({distance, vertex});
    }

    /// Through all triangles at the vertex, and those across their far sides.
    void go_on_from(int vertex) {
        for (const int side : m_surface.sides_around(vertex))
            for (const int s : {side, Surface::next(side), Surface::previous(side)}) update(s);
    }

    /// The corner across from a side, by what is known at its ends.
    void update(int side) {
        const int a = m_surface.from(side), b = m_surface.to(side), c = m_surface.from(Surface::previous(side));
        if (m_is_final[c]) return;
        const auto from = [&](int end, double distance) { lower(c, distance, m_nearest.sources[end]); };
        if (m_is_final[a] && m_is_final[b])
            from(distance_of(a) < distance_of(b) ? a : b,
                 distance_across(distance_of(a), distance_of(b), length(a, b), length(b, c), length(c, a)));
        else if (m_is_final[a])
            from(a, distance_of(a) + length(a, c));
        else if (m_is_final[b])
            from(b, distance_of(b) + length(b, c));
    }

    double distance_of(int vertex) const { return m_nearest.distances[vertex]; }

    double length(int a, int b) const { return (m_surface.positions().col(a) - m_surface.positions().col(b)).norm(); }

    using Entry = std::pair<double, int>;  // distance, vertex
    const Surface& m_surface;
    NearestSources m_nearest;
    std::vector<bool> m_is_final;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_waiting;
};

}  // namespace

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

std::vector<double> geodesic_distances(const Surface& surface, std::span<const SurfacePoint> sources, double most) {
    return March(surface).run(sources, most).distances;
}

NearestSources nearest_sources(const Surface& surface, std::span<const SurfacePoint> sources) {
    return March(surface).run(sources, k_infinity);
}

}  // namespace chebnet
