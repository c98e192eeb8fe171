#include "change/coarsen.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "base/error.h"
#include "change/folded.h"
#include "net/corner_edges.h"
#include "net/rods.h"

namespace chebnet {

namespace {

/// What a vertex is in the coarser net: a vertex, the middle of an edge, the middle of a face.
enum class Role { unknown, vertex, edge, face };

using Quad = std::array<int, 4>;

class Coarsening {
public:
    explicit Coarsening(const Net& net)
        : m_net(net),
          m_topology(net),
          m_edges(corner_edges(net, m_topology)),
          m_roles(static_cast<std::size_t>(net.vertex_count()), Role::unknown),
          m_faces_of_edge(static_cast<std::size_t>(net.edge_count()), {-1, -1}),
          m_faces_of_vertex(static_cast<std::size_t>(net.vertex_count())),
          m_is_reached(static_cast<std::size_t>(net.face_count()), false) {
        if (is_cut(net, m_topology))
            throw Error(ErrorCode::impossible_change,
                        "faces at the border of this net have edges of other lengths, as where rods are cut: of a "
                        "surface lay a net with edges of twice the length instead");
        for (int f = 0; f < net.face_count(); ++f) {
            if (net.faces()[f].size() != 4)
                throw Error(ErrorCode::impossible_change,
                            "face " + std::to_string(f) + " is no quad: nets of quads alone can be made coarser");
            for (int corner = 4 * f; corner < 4 * f + 4; ++corner) {
                std::array<int, 2>& beside = m_faces_of_edge[m_edges[corner]];
                beside[beside[0] < 0 ? 0 : 1] = f;
                m_faces_of_vertex[net.faces().vertices[corner]].push_back(f);
            }
        }
    }

    ChangedMesh coarser() {
        std::vector<bool> is_done(static_cast<std::size_t>(m_net.face_count()), false);
        std::vector<Quad> quads;
        for (int f = 0; f < m_net.face_count(); ++f) {
            if (is_done[f]) continue;
            const std::vector<Quad> found = best_quads(f);
            quads.insert(quads.end(), found.begin(), found.end());
            for (const int member : m_piece) is_done[member] = true;
        }
        if (quads.empty())
            throw Error(ErrorCode::impossible_change, "the net has nowhere two by two quads around a vertex");
        return mesh_of(quads);
    }

private:
    /// Of the piece of the net with face `first`.
    std::vector<Quad> best_quads(int first) {
        std::optional<std::vector<Quad>> best;
        for (int start = 0; start < 4; ++start) {
            if (!give_roles(first, start)) continue;
            std::vector<Quad> quads = quads_of_piece();
            if (m_conflict < 0 && (!best || quads.size() > best->size())) best = std::move(quads);
        }
        if (!best)
            throw Error(ErrorCode::impossible_change,
                        "rows cannot be taken in pairs: at vertex " + std::to_string(m_conflict) +
                            " an odd one is left between singular vertices, or all round; delete a row there first");
        return *best;
    }

    /// Of all faces that lie edge to edge with `first`, whose corner `start` is to be a vertex. False if they
    /// contradict each other.
    bool give_roles(int first, int start) {
        for (const int f : m_piece) {
            m_is_reached[f] = false;
            for (const int v : m_net.faces()[f]) m_roles[v] = Role::unknown;
        }
        m_conflict = -1;
        m_piece.assign(1, first);
        m_is_reached[first] = true;
        give(first, 4 * first + start, Role::vertex);
        for (std::size_t i = 0; i < m_piece.size(); ++i)
            for (int corner = 4 * m_piece[i]; corner < 4 * m_piece[i] + 4; ++corner) give_beyond(m_piece[i], corner);
        return m_conflict < 0;
    }

    /// To the face on the other side of the edge from this corner to the next.
    void give_beyond(int f, int corner) {
        const std::array<int, 2>& beside = m_faces_of_edge[m_edges[corner]];
        const int other = beside[0] == f ? beside[1] : beside[0];
        if (other < 0) return;
        int v = vertex_at(corner);
        if (m_roles[v] == Role::edge) v = vertex_at(corner_after(m_net.faces(), f, corner));
        int there = 4 * other;
        while (vertex_at(there) != v) ++there;
        if (!m_is_reached[other]) m_piece.push_back(other);
        m_is_reached[other] = true;
        give(other, there, m_roles[v]);
    }

    /// To the corners of a face, of which one is to be a vertex, or the middle of a face.
    void give(int f, int corner, Role role) {
        const std::array<Role, 4> around = {role, Role::edge, role == Role::vertex ? Role::face : Role::vertex,
                                            Role::edge};
        for (const Role each : around) {
            Role& known = m_roles[vertex_at(corner)];
            if (known != Role::unknown && known != each && m_conflict < 0) m_conflict = vertex_at(corner);
            known = each;
            corner = corner_after(m_net.faces(), f, corner);
        }
    }

    std::vector<Quad> quads_of_piece() {
        std::vector<Quad> quads;
        for (const int f : m_piece)
            for (const int v : m_net.faces()[f]) {
                if (m_topology.is_boundary(v) || m_roles[v] == Role::vertex) continue;
                if (m_topology.valence(v) != 4) m_conflict = v;
                // Once, with the first of the four faces around it.
                else if (m_roles[v] == Role::face && m_faces_of_vertex[v].front() == f)
                    quads.push_back(quad_around(v));
            }
        return quads;
    }

    /// The far corners of its faces, in the order in which these lie side by side.
    Quad quad_around(int middle) const {
        Quad quad{};
        int face = m_faces_of_vertex[middle].front(), edge = -1;  // the edge over which the face was entered
        for (int& vertex : quad) {
            int corner = 4 * face;
            while (vertex_at(corner) != middle) ++corner;
            const int ahead = m_edges[corner], behind = m_edges[corner_before(m_net.faces(), face, corner)];
            vertex = vertex_at(4 * face + (corner - 4 * face + 2) % 4);
            edge = edge == ahead ? behind : edge == behind ? ahead : behind;
            const std::array<int, 2>& beside = m_faces_of_edge[edge];
            face = beside[0] == face ? beside[1] : beside[0];
        }
        return quad;
    }

    ChangedMesh mesh_of(const std::vector<Quad>& quads) const {
        std::vector<int> new_vertex(static_cast<std::size_t>(m_net.vertex_count()), -1);
        for (const Quad& quad : quads)
            for (const int v : quad) new_vertex[v] = 0;
        ChangedMesh coarser{.mesh = {}, .origins = {}, .length_factor = 2};
        for (int v = 0; v < m_net.vertex_count(); ++v) {
            if (new_vertex[v] < 0) continue;
            new_vertex[v] = static_cast<int>(coarser.origins.size());
            coarser.origins.push_back(v);
        }
        coarser.mesh.positions = m_net.rest_positions()(Eigen::all, coarser.origins);
        for (const Quad& quad : quads)
            coarser.mesh.faces.add(
                {new_vertex[quad[0]], new_vertex[quad[1]], new_vertex[quad[2]], new_vertex[quad[3]]});
        check_not_folded(coarser.mesh.faces);
        return coarser;
    }

    int vertex_at(int corner) const { return m_net.faces().vertices[corner]; }

    const Net& m_net;
    Topology m_topology;
    std::vector<int> m_edges;  // see corner_edges
    std::vector<Role> m_roles;
    std::vector<std::array<int, 2>> m_faces_of_edge;
    std::vector<std::vector<int>> m_faces_of_vertex;
    std::vector<int> m_piece;  // the faces that have roles
    std::vector<bool> m_is_reached;
    int m_conflict = -1;  // a vertex of two roles, or of one that it cannot have
};

}  // namespace

ChangedMesh coarsened(const Net& net, const ChangePlace&) { return Coarsening(net).coarser(); }

}  // namespace chebnet
