#include "change/add_row.h"

#include <array>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/sets.h"
#include "change/marked.h"
#include "net/corner_edges.h"

namespace chebnet {

namespace {

/// Each edge of the row has two places outside, one beyond each of its ends. Places that are to be one vertex are
/// joined.
class Row {
public:
    Row(const Net& net, const ChangePlace& place)
        : m_net(net),
          m_topology(net),
          m_is_in_row(marked(place.edges, net.edge_count())),
          m_border(static_cast<std::size_t>(net.vertex_count())),
          m_first(static_cast<std::size_t>(net.edge_count()), -1),
          m_places(2 * net.edge_count()),
          m_vertex_of(static_cast<std::size_t>(2 * net.edge_count()), -1) {}

    ChangedMesh added() {
        find_border();
        for (int v = 0; v < m_net.vertex_count(); ++v) join_places(v);
        make_vertices();
        for (int e = 0; e < m_net.edge_count(); ++e)
            if (m_is_in_row[e]) add_quad(e);
        for (int v = 0; v < m_net.vertex_count(); ++v) add_quad_at_corner(v);
        return result();
    }

private:
    void find_border() {
        const Faces& faces = m_net.faces();
        const std::vector<int> edges = corner_edges(m_net, m_topology);
        for (int f = 0; f < faces.size(); ++f)
            for (int corner = faces.start[f]; corner < faces.start[f + 1]; ++corner)
                if (const int e = edges[corner]; m_net.edge_face_counts()[e] == 1) m_first[e] = faces.vertices[corner];
        bool any = false;
        for (int e = 0; e < m_net.edge_count(); ++e) {
            if (m_first[e] < 0) {
                m_is_in_row[e] = false;
                continue;
            }
            any = any || m_is_in_row[e];
            for (const int v : m_net.edges().col(e)) m_border[v].push_back(e);
        }
        if (!any)
            throw Error(ErrorCode::impossible_change,
                        "no edge of this line lies on the border, where rows are added: choose a vertex there");
    }

    void join_places(int v) {
        const std::vector<int> row = row_edges(v);
        if (row.empty()) return;
        if (m_border[v].size() != 2) refuse("the border meets itself", v);
        if (faces_at(v) > 3) refuse("the border turns inwards too sharply", v);
        const int e = row.front(), g = row.back();
        if (row.size() == 1 && faces_at(v) == 3) m_vertex_of[place(v, e)] = other_end(other_border_edge(v, e), v);
        if (row.size() == 2 && faces_at(v) == 2) m_places.join(place(v, e), place(v, g));
        if (!is_inward(v)) return;
        const int u = other_end(e, v), w = other_end(g, v);
        if (is_inward(u) || is_inward(w)) refuse("the border turns inwards twice in a row", v);
        m_places.join(place(u, e), place(w, g));
    }

    void make_vertices() {
        // What is there already serves its whole set.
        for (int p = 0; p < 2 * m_net.edge_count(); ++p)
            if (const int there = m_vertex_of[p]; there >= 0) {
                int& vertex = m_vertex_of[m_places.of(p)];
                if (vertex >= 0 && vertex != there) refuse("the border closes on itself", there);
                vertex = there;
            }
        for (int e = 0; e < m_net.edge_count(); ++e) {
            if (!m_is_in_row[e]) continue;
            for (const int v : m_net.edges().col(e)) {
                int& vertex = m_vertex_of[m_places.of(place(v, e))];
                if (is_inward(v) || (vertex >= 0 && vertex < m_net.vertex_count())) continue;
                if (vertex < 0) vertex = add_vertex();
                m_new[vertex - m_net.vertex_count()] += straight_on(v, e);
                ++m_shares[vertex - m_net.vertex_count()];
            }
        }
        for (std::size_t k = 0; k < m_new.size(); ++k) m_new[k] /= m_shares[k];
    }

    /// Beyond v, where the line goes on that ends there.
    Eigen::Vector3d straight_on(int v, int e) const {
        int from = other_end(other_border_edge(v, e), v);
        for (const int inner : m_topology.incident_edges(v))
            if (m_first[inner] < 0) from = other_end(inner, v);
        return 2 * m_net.rest_positions().col(v) - m_net.rest_positions().col(from);
    }

    void add_quad(int e) {
        const int a = m_first[e], b = other_end(e, a);
        if (is_inward(a) || is_inward(b)) return;
        m_quads.add({b, a, outside(a, e), outside(b, e)});
    }

    void add_quad_at_corner(int v) {
        const std::vector<int> row = row_edges(v);
        if (row.size() != 2 || faces_at(v) == 2) return;
        const bool in_order = m_first[row.front()] != v;
        const int in = in_order ? row.front() : row.back(), out = in_order ? row.back() : row.front();
        const int u = other_end(in, v), w = other_end(out, v);
        if (is_inward(v)) return m_quads.add({w, v, u, outside(u, in)});
        const int beside = outside(v, in), ahead = outside(v, out);
        if (beside == ahead) refuse("the border closes on itself", v);
        const Eigen::Vector3d point = point_of(beside) + point_of(ahead) - m_net.rest_positions().col(v);
        const int beyond = add_vertex();
        m_new.back() = point;
        m_quads.add({v, beside, beyond, ahead});
    }

    ChangedMesh result() {
        const int V = m_net.vertex_count(), count = V + static_cast<int>(m_new.size());
        ChangedMesh larger{.mesh = {Positions(3, count), m_net.faces()},
                           .origins = std::vector<int>(static_cast<std::size_t>(count), -1)};
        std::iota(larger.origins.begin(), larger.origins.begin() + V, 0);
        larger.mesh.positions.leftCols(V) = m_net.rest_positions();
        for (int k = V; k < count; ++k) larger.mesh.positions.col(k) = m_new[k - V];
        for (int f = 0; f < m_quads.size(); ++f) larger.mesh.faces.add(m_quads[f]);
        return larger;
    }

    /// Of a new vertex, or one that was there, as where the row ends in a corner that it fills.
    Eigen::Vector3d point_of(int vertex) const {
        const int V = m_net.vertex_count();
        return vertex < V ? Eigen::Vector3d(m_net.rest_positions().col(vertex)) : m_new[vertex - V];
    }

    int add_vertex() {
        m_new.emplace_back(Eigen::Vector3d::Zero());
        m_shares.push_back(0);
        return m_net.vertex_count() + static_cast<int>(m_new.size()) - 1;
    }

    std::vector<int> row_edges(int v) const {
        std::vector<int> edges;
        for (const int e : m_border[v])
            if (m_is_in_row[e]) edges.push_back(e);
        return edges;
    }

    /// Where the border turns inwards within the row: the two edges there have one quad.
    bool is_inward(int v) const { return row_edges(v).size() == 2 && faces_at(v) == 3; }
    /// Of a vertex at which the border does not meet itself.
    int faces_at(int v) const { return m_topology.valence(v) - 1; }
    int place(int v, int e) const { return 2 * e + (m_net.edges()(0, e) == v ? 0 : 1); }
    int outside(int v, int e) { return m_vertex_of[m_places.of(place(v, e))]; }
    int other_end(int e, int v) const { return m_net.edges()(0, e) + m_net.edges()(1, e) - v; }
    int other_border_edge(int v, int e) const { return m_border[v][0] + m_border[v][1] - e; }

    [[noreturn]] static void refuse(const char* what, int v) {
        throw Error(ErrorCode::impossible_change, "at vertex " + std::to_string(v) + " " + what +
                                                      ": add the row on one side of it, or delete the faces there");
    }

    const Net& m_net;
    Topology m_topology;
    std::vector<bool> m_is_in_row;
    std::vector<std::vector<int>> m_border;  // of each vertex its edges with one face
    std::vector<int> m_first;  // of each such edge the end its face comes to first; −1: it has two faces
    Sets m_places;
    std::vector<int> m_vertex_of;  // of each set of places, at its first
    std::vector<Eigen::Vector3d> m_new;
    std::vector<double> m_shares;  // of how many places a new vertex is the mean
    Faces m_quads;
};

}  // namespace

ChangedMesh with_row(const Net& net, const ChangePlace& place) { return Row(net, place).added(); }

}  // namespace chebnet
