#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace chebnet {

/// Vertex positions, 3×V: column i is vertex i, in the net's own unit of length.
using Positions = Eigen::Matrix3Xd;

/// As seen from `centre` so many times as far; no farther than numbers go.
Positions grown(const Positions& positions, const Eigen::Vector3d& centre, double factor);

/// Faces of any arity as one flat list: face f is vertices[start[f]] … vertices[start[f + 1] − 1], in cyclic order.
struct Faces {
    std::vector<int> start{0};
    std::vector<int> vertices;

    int size() const { return static_cast<int>(start.size()) - 1; }
    std::span<const int> operator[](int f) const {
        return std::span<const int>(vertices).subspan(static_cast<std::size_t>(start[f]),
                                                      static_cast<std::size_t>(start[f + 1] - start[f]));
    }
    void add(std::span<const int> face) {
        vertices.insert(vertices.end(), face.begin(), face.end());
        start.push_back(static_cast<int>(vertices.size()));
    }
    void add(std::initializer_list<int> face) { add(std::span<const int>(face.begin(), face.size())); }
};

/// Which length each edge is to keep.
enum class RestLengths {
    automatic,  ///< `equal` if the net already is a Chebyshev net (every edge within dL < k_chebyshev_deviation of the
                ///< mean length), `own` otherwise
    equal,      ///< one length for all, the mean: a Chebyshev net (Li et al. 2022, section 2)
    own,        ///< each edge the length it has at rest: the paper's extension to general meshes
};

/// A net whose edges deviate less than this from their mean length counts as a Chebyshev net. It is the paper's own
/// tolerance for a result (ε_3, section 3.2), so a saved result opens as what it is.
inline constexpr double k_chebyshev_deviation = 1e-6;
/// Below this max dL all edges of a net that is made have one length: an edge is off by less than 0.0032 % of it.
inline constexpr double k_equal_deviation = 1e-9;

/// Beyond this size, and below its inverse, squares of lengths may overflow or underflow.
inline constexpr double k_largest_size = 1e150;

/// A mesh and the length each of its edges keeps. Immutable and sound: the constructor refuses everything else.
/// Open, closed, several components and vertices of any valence are all fine, faces may have any arity ≥ 3.
class Net {
public:
    /// Takes rest positions (3×V) and faces. Edges are the unique consecutive pairs of the faces.
    /// Throws Error: no_faces, small_face, index_out_of_range, repeated_vertex, non_finite, zero_length_edge,
    /// bad_scale (a coordinate or the mean edge beyond k_largest_size, the mean edge below 1 / k_largest_size),
    /// non_manifold_edge (more than two faces at an edge), unused_vertex (a vertex without a face is refused, not
    /// dropped, so that vertex numbers always stay those of the file). Each message names face, vertex or edge, from 0.
    Net(Positions rest_positions, Faces faces, RestLengths rest_lengths = RestLengths::automatic);

    /// The same net in another unit: all lengths times `factor`, a power of two, which changes no digit of them.
    Net scaled(double factor) const;
    /// The net whose edges are all to be `factor` times as long, above 0: at rest it is the same shape of another size,
    /// about the same centre.
    Net grown(double factor) const;

    int vertex_count() const { return static_cast<int>(m_rest_positions.cols()); }
    int edge_count() const { return static_cast<int>(m_edges.cols()); }
    int face_count() const { return m_faces.size(); }

    const Positions& rest_positions() const { return m_rest_positions; }
    const Faces& faces() const { return m_faces; }
    /// 2×E, column e = the ends (a, b) of edge e with a < b, columns in lexicographic order.
    const Eigen::Matrix2Xi& edges() const { return m_edges; }
    /// E, how many faces meet at each edge: 1 on the boundary, 2 inside.
    const std::vector<int>& edge_face_counts() const { return m_edge_face_counts; }
    /// E, the length L_e that edge e keeps; positive.
    const Eigen::VectorXd& rest_lengths() const { return m_rest_lengths; }
    /// Mean of the edge lengths at rest.
    double mean_length() const { return m_mean_length; }
    /// The power of two next below the mean length: in this unit lengths keep all their digits, and their powers are
    /// far from the limits of numbers.
    double unit() const;
    /// True if one length serves all edges.
    bool is_chebyshev() const { return m_is_chebyshev; }

private:
    void check_faces() const;
    void build_edges();
    void choose_rest_lengths(RestLengths choice);

    Positions m_rest_positions;
    Faces m_faces;
    Eigen::Matrix2Xi m_edges;
    std::vector<int> m_edge_face_counts;
    Eigen::VectorXd m_rest_lengths;
    double m_mean_length = 0;
    bool m_is_chebyshev = false;
};

}  // namespace chebnet
