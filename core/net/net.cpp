#include "net/net.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/error.h"

namespace chebnet {

namespace {

std::string edge_name(int a, int b) { return "edge " + std::to_string(a) + "–" + std::to_string(b); }

void check_finite(const Positions& positions) {
    for (int v = 0; v < positions.cols(); ++v)
        if (!positions.col(v).allFinite())
            throw Error(ErrorCode::non_finite, "vertex " + std::to_string(v) + " has a coordinate that is not finite");
}

void check_size(const Positions& positions) {
    static_assert(k_largest_size == 1e150);
    for (int v = 0; v < positions.cols(); ++v)
        if (positions.col(v).lpNorm<Eigen::Infinity>() > k_largest_size)
            throw Error(ErrorCode::bad_scale,
                        "vertex " + std::to_string(v) + " has a coordinate beyond 1e150: please make the net smaller");
}

}  // namespace

Positions grown(const Positions& positions, const Eigen::Vector3d& centre, double factor) {
    constexpr double farthest = std::numeric_limits<double>::max();
    Positions x = positions;
    for (int v = 0; v < x.cols(); ++v)
        for (int axis = 0; axis < 3; ++axis)
            x(axis, v) = std::clamp(centre[axis] + factor * (x(axis, v) - centre[axis]), -farthest, farthest);
    return x;
}

Net::Net(Positions rest_positions, Faces faces, RestLengths rest_lengths)
    : m_rest_positions(std::move(rest_positions)), m_faces(std::move(faces)) {
    check_finite(m_rest_positions);
    check_size(m_rest_positions);
    check_faces();
    build_edges();
    choose_rest_lengths(rest_lengths);
}

void Net::check_faces() const {
    if (face_count() == 0) throw Error(ErrorCode::no_faces, "the net has no faces");
    // For each vertex the last face that names it: finds repetitions within a face, and unused vertices.
    std::vector<int> last_face(static_cast<std::size_t>(vertex_count()), -1);
    for (int f = 0; f < face_count(); ++f) {
        const std::span<const int> face = m_faces[f];
        const std::string name = "face " + std::to_string(f);
        if (face.size() < 3)
            throw Error(ErrorCode::small_face, name + " has only " + std::to_string(face.size()) + " vertices");
        for (int v : face) {
            if (v < 0 || v >= vertex_count())
                throw Error(ErrorCode::index_out_of_range, name + " names vertex " + std::to_string(v) +
                                                               ", but vertices go from 0 to " +
                                                               std::to_string(vertex_count() - 1));
            if (last_face[v] == f)
                throw Error(ErrorCode::repeated_vertex, name + " names vertex " + std::to_string(v) + " twice");
            last_face[v] = f;
        }
    }
    const auto unused = std::find(last_face.begin(), last_face.end(), -1);
    if (unused != last_face.end())
        throw Error(ErrorCode::unused_vertex,
                    "vertex " + std::to_string(unused - last_face.begin()) + " belongs to no face");
}

void Net::build_edges() {
    std::vector<std::pair<int, int>> sides;
    sides.reserve(m_faces.vertices.size());
    for (int f = 0; f < face_count(); ++f) {
        const std::span<const int> face = m_faces[f];
        for (std::size_t k = 0; k < face.size(); ++k)
            sides.push_back(std::minmax({face[k], face[(k + 1) % face.size()]}));
    }
    std::sort(sides.begin(), sides.end());

    m_edges.resize(2, static_cast<Eigen::Index>(sides.size()));
    int count = 0;
    for (std::size_t first = 0, next = 0; first < sides.size(); first = next) {
        next = first + 1;
        while (next < sides.size() && sides[next] == sides[first]) ++next;
        const auto [a, b] = sides[first];
        if (next - first > 2)
            throw Error(ErrorCode::non_manifold_edge,
                        edge_name(a, b) + " has " + std::to_string(next - first) + " faces, more than two");
        m_edges.col(count++) << a, b;
        m_edge_face_counts.push_back(static_cast<int>(next - first));
    }
    m_edges.conservativeResize(2, count);
}

void Net::choose_rest_lengths(RestLengths choice) {
    m_rest_lengths.resize(edge_count());
    for (int e = 0; e < edge_count(); ++e) {
        const int a = m_edges(0, e), b = m_edges(1, e);
        const double square = (m_rest_positions.col(a) - m_rest_positions.col(b)).squaredNorm();
        m_rest_lengths[e] = std::sqrt(square);
        // A square that underflows has lost digits.
        if (square >= std::numeric_limits<double>::min()) continue;
        if (m_rest_positions.col(a) != m_rest_positions.col(b))
            throw Error(ErrorCode::bad_scale, edge_name(a, b) + " is too short to be measured");
        throw Error(ErrorCode::zero_length_edge, edge_name(a, b) + " has length zero");
    }
    // Summing differences keeps the mean of 100,000 equal lengths at that length to the last bit.
    m_mean_length = m_rest_lengths[0] + (m_rest_lengths.array() - m_rest_lengths[0]).mean();
    if (!(m_mean_length > 1 / k_largest_size))
        throw Error(ErrorCode::bad_scale, "the mean edge is shorter than 1e-150: please make the net larger");

    const double shortest = m_rest_lengths.minCoeff() / m_mean_length;
    const double longest = m_rest_lengths.maxCoeff() / m_mean_length;
    const auto dL = [](double ratio) { return (ratio - 1) * (ratio - 1) / ratio; };
    const bool nearly_equal = std::max(dL(shortest), dL(longest)) < k_chebyshev_deviation;
    m_is_chebyshev = choice == RestLengths::equal || (choice == RestLengths::automatic && nearly_equal);
    if (m_is_chebyshev) m_rest_lengths.setConstant(m_mean_length);
}

double Net::unit() const { return std::ldexp(1, std::ilogb(m_mean_length)); }

Net Net::scaled(double factor) const {
    Net net(*this);
    net.m_rest_positions *= factor;
    net.m_rest_lengths *= factor;
    net.m_mean_length *= factor;
    return net;
}

Net Net::grown(double factor) const {
    Net net(*this);
    net.m_rest_positions = chebnet::grown(m_rest_positions, m_rest_positions.rowwise().mean(), factor);
    net.m_rest_lengths *= factor;
    net.m_mean_length *= factor;
    return net;
}

}  // namespace chebnet
