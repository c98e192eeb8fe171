#include "change/refine.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "base/error.h"
#include "net/corner_edges.h"
#include "net/rods.h"

namespace chebnet {

namespace {

constexpr int k_most_refined_vertices = 2'000'000;
// A line that turns more at a vertex is folded there, as the edges of a box are, and is to stay so.
const double k_cosine_of_fold = std::cos(std::numbers::pi / 3);

/// Of b between two neighbours on a line.
bool is_smooth(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    return (b - a).dot(c - b) > k_cosine_of_fold * (b - a).norm() * (c - b).norm();
}

/// Of the edge from b to c of a line that comes from a and goes on to d, each null where it does not: on the cubic
/// through all four, on the parabola through three, or in the middle.
Eigen::Vector3d middle(const Eigen::Vector3d* a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                       const Eigen::Vector3d* d) {
    if (a && d) return (9 * (b + c) - (*a + *d)) / 16;
    if (a) return (3 * c + 6 * b - *a) / 8;
    if (d) return (3 * b + 6 * c - *d) / 8;
    return (b + c) / 2;
}

/// 3×E, on the edges.
Positions middles_on_edges(const Net& net) {
    Positions middles(3, net.edge_count());
    for (int e = 0; e < net.edge_count(); ++e)
        middles.col(e) =
            (net.rest_positions().col(net.edges()(0, e)) + net.rest_positions().col(net.edges()(1, e))) / 2;
    return middles;
}

/// 3×E, on curves along the net lines.
Positions middles_on_curves(const Net& net, const Topology& topology) {
    Positions middles(3, net.edge_count());
    for (const std::vector<int>& line : topology.net_lines()) {
        const int count = static_cast<int>(line.size());
        const bool closed = topology.is_closed(line);
        const auto point = [&](int k) -> Eigen::Vector3d {
            return net.rest_positions().col(line[closed ? (k + count - 1) % (count - 1) : k]);
        };
        for (int k = 0; k + 1 < count; ++k) {
            const Eigen::Vector3d b = point(k), c = point(k + 1);
            const bool comes = closed || k > 0, goes_on = closed || k + 2 < count;
            const Eigen::Vector3d a = comes ? point(k - 1) : b, d = goes_on ? point(k + 2) : c;
            middles.col(topology.edge_between(line[k], line[k + 1])) =
                middle(comes && is_smooth(a, b, c) ? &a : nullptr, b, c, goes_on && is_smooth(b, c, d) ? &d : nullptr);
        }
    }
    return middles;
}

int triangle_count(const Faces& faces) {
    int count = 0;
    for (int f = 0; f < faces.size(); ++f)
        if (faces[f].size() == 3) ++count;
    return count;
}

/// Throws Error impossible_change where the finer faces would be slivers.
void check_can_be_finer(const Net& net, const Topology& topology) {
    if (is_cut(net, topology))
        throw Error(ErrorCode::impossible_change,
                    "faces at the border of this net have edges of other lengths, as where rods are cut, so that finer "
                    "ones would be slivers: of a surface lay a net with edges of half the length instead");
    if (!net.is_chebyshev()) return;
    for (int f = 0; f < net.face_count(); ++f)
        if (net.faces()[f].size() > 4)
            throw Error(ErrorCode::impossible_change,
                        "face " + std::to_string(f) + " has " + std::to_string(net.faces()[f].size()) +
                            " corners: nets of triangles and quads can be made finer, for edges of half the length do "
                            "not reach the middle of larger faces");
}

}  // namespace

ChangedMesh refined(const Net& net, const ChangePlace&) {
    const Faces& faces = net.faces();
    const int V = net.vertex_count(), E = net.edge_count(), F = net.face_count();
    const int triangles = triangle_count(faces), centres = F - triangles;
    if (static_cast<long long>(V) + E + centres > k_most_refined_vertices)
        throw Error(ErrorCode::too_large, "the finer net would have more than 2,000,000 vertices");
    const Topology topology(net);
    check_can_be_finer(net, topology);
    const std::vector<int> edges = corner_edges(net, topology);

    ChangedMesh finer{.mesh = {Positions::Zero(3, V + E + centres), {}},
                      .origins = std::vector<int>(static_cast<std::size_t>(V + E + centres), -1),
                      .length_factor = 0.5,
                      .keeps_edges = triangles == F};
    std::iota(finer.origins.begin(), finer.origins.begin() + V, 0);
    Positions& x = finer.mesh.positions;
    x.leftCols(V) = net.rest_positions();
    x.middleCols(V, E) = triangles == F ? middles_on_edges(net) : middles_on_curves(net, topology);
    int centre = V + E;
    for (int f = 0; f < F; ++f) {
        const bool is_triangle = faces[f].size() == 3;
        for (int corner = faces.start[f]; corner < faces.start[f + 1]; ++corner) {
            const int v = faces.vertices[corner], ahead = V + edges[corner];
            const int behind = V + edges[corner_before(faces, f, corner)];
            if (is_triangle) {
                finer.mesh.faces.add({v, ahead, behind});
                continue;
            }
            finer.mesh.faces.add({v, ahead, centre, behind});
            x.col(centre) += (2 * x.col(ahead) - x.col(v)) / static_cast<double>(faces[f].size());
        }
        if (is_triangle) {
            const int first = faces.start[f];
            finer.mesh.faces.add({V + edges[first], V + edges[first + 1], V + edges[first + 2]});
        } else {
            ++centre;
        }
    }
    return finer;
}

}  // namespace chebnet
