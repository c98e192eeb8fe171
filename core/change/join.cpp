#include "change/join.h"

#include <algorithm>
#include <map>
#include <set>
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
// Vertices between which the net is less than so many times as long as the straight way lie near each other since it is
// short, as between rods cut at a border.
constexpr double k_short = 2;

/// The ways along edges from a vertex to others, of those that are shorter than this.
std::map<int, double> short_ways(const Positions& x, const Topology& topology, int from, double longest) {
    std::map<int, double> ways{{from, 0}};
    std::set<std::pair<double, int>> ahead{{0, from}};
    while (!ahead.empty()) {
        const auto [way, v] = ahead.extract(ahead.begin()).value();
        if (way > ways.at(v)) continue;
        for (const int next : topology.neighbours(v)) {
            const double longer = way + (x.col(v) - x.col(next)).norm();
            const auto known = ways.find(next);
            if (longer >= longest || (known != ways.end() && known->second <= longer)) continue;
            ways[next] = longer;
            ahead.emplace(longer, next);
        }
    }
    return ways;
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
    for (auto v = border.begin(); v != border.end(); ++v) {
        const std::map<int, double> ways = short_ways(x, topology, *v, k_short * near);
        for (auto w = v + 1; w != border.end() && x(axis, *w) - x(axis, *v) < near; ++w) {
            const double distance = (x.col(*v) - x.col(*w)).norm();
            const auto way = ways.find(*w);
            const bool are_of_one_border = way != ways.end() && way->second < k_short * distance;
            if (distance < near && !are_of_one_border) together.join(*v, *w);
        }
    }
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
