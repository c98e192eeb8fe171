#include "fabricate/flat_pattern.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace chebnet {

namespace {

using Reason = PatternFault::Reason;
using Place = Eigen::Vector2i;  // column, row

constexpr double k_equal = 1e-6;

std::optional<PatternFault> find_unfit(const Net& net, const Topology& topology) {
    for (int f = 0; f < net.face_count(); ++f)
        if (net.faces()[f].size() != 4) return PatternFault{.reason = Reason::not_quads, .face = f};
    const double shortest = net.rest_lengths().minCoeff(), longest = net.rest_lengths().maxCoeff();
    if (longest - shortest > k_equal * shortest) return PatternFault{.reason = Reason::unequal};
    for (int v = 0; v < net.vertex_count(); ++v)
        if (!topology.is_boundary(v) && topology.valence(v) != 4)
            return PatternFault{.reason = Reason::singular, .vertex = v};
    return std::nullopt;
}

/// Both faces at each edge; the second is −1 on the boundary.
std::vector<std::array<int, 2>> faces_of_edges(const Net& net, const std::vector<int>& corner_edges) {
    std::vector<std::array<int, 2>> faces(static_cast<std::size_t>(net.edge_count()), {-1, -1});
    for (std::size_t corner = 0; corner < corner_edges.size(); ++corner) {
        std::array<int, 2>& both = faces[corner_edges[corner]];
        both[both[0] == -1 ? 0 : 1] = static_cast<int>(corner / 4);
    }
    return faces;
}

/// 4F, the edge from each corner of a quad to the next one.
std::vector<int> edges_of_corners(const Net& net, const Topology& topology) {
    std::vector<int> edges;
    for (int f = 0; f < net.face_count(); ++f)
        for (int k = 0; k < 4; ++k) {
            const std::span<const int> face = net.faces()[f], neighbours = topology.neighbours(face[k]);
            const auto next = std::lower_bound(neighbours.begin(), neighbours.end(), face[(k + 1) % 4]);
            edges.push_back(topology.incident_edges(face[k])[next - neighbours.begin()]);
        }
    return edges;
}

/// Corner k of a face, modulo their number.
class Layout {
public:
    Layout(const Net& net, const Topology& topology)
        : m_net(net),
          m_corner_edges(edges_of_corners(net, topology)),
          m_edge_faces(faces_of_edges(net, m_corner_edges)),
          m_places(2, net.vertex_count()),
          m_is_placed(static_cast<std::size_t>(net.vertex_count()), false),
          m_is_laid(static_cast<std::size_t>(net.face_count()), false) {}

    std::variant<FlatPattern, PatternFault> spread() {
        put(vertex(0, 0), {0, 0});
        put(vertex(0, 1), {1, 0});
        std::vector<int> laid{0};
        if (const auto fault = lay(0, 0, {0, 1})) return *fault;
        for (std::size_t i = 0; i < laid.size(); ++i)
            for (int k = 0; k < 4; ++k) {
                const int edge = edge_at(laid[i], k), next = beyond(edge, laid[i]);
                if (next == -1 || m_is_laid[next]) continue;
                if (const auto fault = lay(next, corner_at(next, edge), outwards(laid[i], k))) return *fault;
                laid.push_back(next);
            }
        if (static_cast<int>(laid.size()) < m_net.face_count()) return PatternFault{.reason = Reason::pieces};
        const Place low = m_places.rowwise().minCoeff();
        m_places.colwise() -= low;
        return FlatPattern{m_places, m_places.row(0).maxCoeff(), m_places.row(1).maxCoeff()};
    }

private:
    int vertex(int face, int k) const { return m_net.faces()[face][k % 4]; }
    int edge_at(int face, int k) const { return m_corner_edges[4 * face + k % 4]; }
    Place place(int face, int k) const { return m_places.col(vertex(face, k)); }
    int beyond(int edge, int face) const { return m_edge_faces[edge][m_edge_faces[edge][0] == face ? 1 : 0]; }
    Place outwards(int face, int k) const { return place(face, k) - place(face, k + 3); }
    int corner_at(int face, int edge) const {
        int k = 0;
        while (edge_at(face, k) != edge) ++k;
        return k;
    }

    /// False if the vertex has another place.
    bool put(int v, const Place& place) {
        if (m_is_placed[v]) return m_places.col(v) == place;
        m_is_placed[v] = true;
        m_places.col(v) = place;
        return true;
    }

    /// Lays a face so that it reaches by `step` from the edge at corner k, which has its place.
    std::optional<PatternFault> lay(int face, int k, const Place& step) {
        for (const auto& [above, below] : {std::pair(k + 3, k), std::pair(k + 2, k + 1)})
            if (!put(vertex(face, above), place(face, below) + step))
                return PatternFault{.reason = Reason::closed, .vertex = vertex(face, above)};
        const Place twice_middle = place(face, k) + place(face, k + 2);
        if (!m_taken.emplace(twice_middle.x(), twice_middle.y()).second)
            return PatternFault{.reason = Reason::overlap, .face = face};
        m_is_laid[face] = true;
        return std::nullopt;
    }

    const Net& m_net;
    const std::vector<int> m_corner_edges;
    const std::vector<std::array<int, 2>> m_edge_faces;
    Eigen::Matrix2Xi m_places;
    std::vector<bool> m_is_placed, m_is_laid;
    std::set<std::pair<int, int>> m_taken;  // where a face lies: twice the middle of its square
};

}  // namespace

const char* to_string(PatternFault::Reason reason) {
    switch (reason) {
        case Reason::not_quads:
            return "not_quads";
        case Reason::unequal:
            return "unequal";
        case Reason::singular:
            return "singular";
        case Reason::closed:
            return "closed";
        case Reason::overlap:
            return "overlap";
        case Reason::pieces:
            return "pieces";
    }
    return "";
}

std::variant<FlatPattern, PatternFault> flat_pattern(const Net& net, const Topology& topology) {
    if (const auto fault = find_unfit(net, topology)) return *fault;
    return Layout(net, topology).spread();
}

}  // namespace chebnet
