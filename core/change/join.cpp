#include "change/join.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/sets.h"
#include "net/repair.h"
#include "net/topology.h"

namespace chebnet {

namespace {

// In mean edges: what hands bring together, while the ends of an edge, and those of the short diagonal of a cell with
// corners of 30 degrees, stay apart.
constexpr double k_near = 0.5;

/// Whether they lie near each other since the net between them is short, as between rods cut at a border: no way along
/// two edges is more than twice as long as the straight one.
bool are_of_one_border(const Positions& x, const Topology& topology, int v, int w) {
    const auto distance = [&](int a, int b) { return (x.col(a) - x.col(b)).norm(); };
    for (const int between : topology.neighbours(v))
        if ((between == w || topology.edge_between(between, w) >= 0) &&
            distance(v, between) + distance(between, w) < 2 * distance(v, w))
            return true;
    return false;
}

/// Border vertices that lie near each other.
Sets near_vertices(const Net& net) {
    const Topology topology(net);
    const Positions& x = net.rest_positions();
    const double near = k_near * net.mean_length();
    std::vector<int> border;
    for (int v = 0; v < net.vertex_count(); ++v)
        if (topology.is_boundary(v)) border.push_back(v);
    if (border.empty()) return Sets(net.vertex_count());
    int axis = 0;  // along which they are spread most, so that few are near each other there
    const Positions at_border = x(Eigen::all, border);
    (at_border.rowwise().maxCoeff() - at_border.rowwise().minCoeff()).maxCoeff(&axis);
    std::sort(border.begin(), border.end(), [&](int v, int w) { return x(axis, v) < x(axis, w); });

    Sets together(net.vertex_count());
    for (auto v = border.begin(); v != border.end(); ++v)
        for (auto w = v + 1; w != border.end() && x(axis, *w) - x(axis, *v) < near; ++w)
            if ((x.col(*v) - x.col(*w)).norm() < near && !are_of_one_border(x, topology, *v, *w)) together.join(*v, *w);
    return together;
}

/// In place of the error's own words, which are of the net that would be: nobody has seen its numbers.
const char* misfit(ErrorCode code) {
    switch (code) {
        case ErrorCode::non_manifold_edge:
            return "more than two faces would meet at an edge";
        case ErrorCode::repeated_vertex:
            return "two corners of a face would become one";
        default:
            return "an edge would have no length";
    }
}

}  // namespace

ChangedMesh joined(const Net& net, const ChangePlace&) {
    Sets together = near_vertices(net);
    std::vector<int> new_vertex;
    std::vector<double> shares;
    ChangedMesh one{.mesh = {}, .origins = {}};
    for (int v = 0; v < net.vertex_count(); ++v) {
        const bool is_first = together.of(v) == v;
        new_vertex.push_back(is_first ? static_cast<int>(one.origins.size()) : new_vertex[together.of(v)]);
        if (is_first) one.origins.push_back(v), shares.push_back(0);
        ++shares[new_vertex[v]];
    }
    if (static_cast<int>(one.origins.size()) == net.vertex_count())
        throw Error(ErrorCode::impossible_change,
                    "no borders lie within half an edge of each other: drag them together first");
    one.mesh.positions = Positions::Zero(3, static_cast<Eigen::Index>(one.origins.size()));
    for (int v = 0; v < net.vertex_count(); ++v)
        one.mesh.positions.col(new_vertex[v]) += net.rest_positions().col(v) / shares[new_vertex[v]];
    one.mesh.faces = net.faces();
    for (int& v : one.mesh.faces.vertices) v = new_vertex[v];
    try {
        Net(one.mesh.positions, one.mesh.faces);
    } catch (const Error& error) {
        throw Error(ErrorCode::impossible_change,
                    std::string("these borders do not fit together: ") + misfit(error.code()));
    }
    one.mesh = repair(std::move(one.mesh), {Defect::inconsistent_winding}).mesh;
    return one;
}

}  // namespace chebnet
