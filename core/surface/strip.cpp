#include "surface/strip.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "surface/surface_point.h"

namespace chebnet {

namespace {

Eigen::Vector3d middle_of(const Surface& surface, int face) {
    return surface.position_at({face, Eigen::Vector3d::Constant(1. / 3)});
}

/// The vertices on the shortest way along edges, from the triangle of one point to that of another (A*, which goes by
/// the straight way that is left).
std::vector<int> vertices_between(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const auto straight = [&](const SurfacePoint& point, int vertex) {
        return (surface.position_at(point) - surface.positions().col(vertex)).norm();
    };
    struct Step {
        double way;
        int before;
    };
    using Entry = std::pair<double, int>;  // the least that the whole way can be, vertex
    std::unordered_map<int, Step> reached;
    std::unordered_set<int> is_final;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    const auto reach = [&](int vertex, const Step& step) {
        const auto [known, is_new] = reached.try_emplace(vertex, step);
        if (!is_new && step.way >= known->second.way) return;
        known->second = step;
        waiting.push({step.way + straight(to, vertex), vertex});
    };
    for (const int vertex : surface.triangles().col(from.face)) reach(vertex, {straight(from, vertex), -1});
    int here = waiting.top().second;
    for (; corner_of(surface, to.face, here) < 0; here = waiting.top().second) {
        waiting.pop();
        if (!is_final.insert(here).second) continue;
        const double way = reached.at(here).way;
        for (const int side : surface.sides_around(here)) {
            reach(surface.to(side), {way + surface.length_of(side), here});
            const int back = Surface::previous(side);  // at the boundary no other side goes along its edge
            reach(surface.from(back), {way + surface.length_of(back), here});
        }
    }
    std::vector<int> vertices;
    for (; here >= 0; here = reached.at(here).before) vertices.push_back(here);
    std::reverse(vertices.begin(), vertices.end());
    return vertices;
}

}  // namespace

Strip strip_over_middles(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const Eigen::Vector3d target = surface.position_at(to);
    struct Step {
        double way;
        int before;
    };
    using Entry = std::pair<double, int>;  // the least that the whole way can be, triangle
    std::unordered_map<int, Step> reached{{from.face, {0, -1}}};
    std::unordered_set<int> is_final;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    waiting.push({0, from.face});
    while (!waiting.empty()) {
        const int face = waiting.top().second;
        waiting.pop();
        if (!is_final.insert(face).second) continue;
        if (face == to.face) break;
        const Eigen::Vector3d here = face == from.face ? surface.position_at(from) : middle_of(surface, face);
        for (int side = 3 * face; side < 3 * face + 3; ++side) {
            if (surface.opposite(side) < 0) continue;
            const int next = Surface::face_of(surface.opposite(side));
            const Eigen::Vector3d edge =
                (surface.positions().col(surface.from(side)) + surface.positions().col(surface.to(side))) / 2;
            const Eigen::Vector3d there = middle_of(surface, next);
            const double way = reached.at(face).way + (edge - here).norm() + (there - edge).norm();
            const auto [known, is_new] = reached.try_emplace(next, Step{way, face});
            if (!is_new && way >= known->second.way) continue;
            known->second = {way, face};
            waiting.push({way + (target - there).norm(), next});
        }
    }
    if (!is_final.contains(to.face)) return {};
    Strip strip;
    for (int face = to.face; face >= 0; face = reached.at(face).before) strip.push_back(face);
    std::reverse(strip.begin(), strip.end());
    return strip;
}

Strip strip_along_edges(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to) {
    const std::vector<int> vertices = vertices_between(surface, from, to);
    Strip strip{from.face};
    for (std::size_t k = 0; k < vertices.size(); ++k) {
        const auto is_there = [&](int face) {
            return k + 1 < vertices.size() ? corner_of(surface, face, vertices[k + 1]) >= 0 : face == to.face;
        };
        std::vector<int> faces = surface.faces_around(vertices[k]);
        auto here = std::find(faces.begin(), faces.end(), strip.back());
        if (!surface.is_boundary(vertices[k])) {
            std::rotate(faces.begin(), here, faces.end());
            here = faces.begin();
        }
        auto there = std::find_if(here, faces.end(), is_there);
        if (there == faces.end()) {  // at the boundary, on the other side
            std::reverse(faces.begin(), faces.end());
            here = std::find(faces.begin(), faces.end(), strip.back());
            there = std::find_if(here, faces.end(), is_there);
        }
        strip.insert(strip.end(), here + 1, there + 1);
    }
    return strip;
}

Strip tidied(const Surface& surface, const Strip& strip, const SurfacePoint& from, const SurfacePoint& to) {
    Strip tidy;
    for (const int face : strip) {
        const auto before = std::find(tidy.begin(), tidy.end(), face);
        if (before != tidy.end()) tidy.erase(before, tidy.end());
        if (weights_in(surface, from, face)) tidy.clear();
        tidy.push_back(face);
        if (weights_in(surface, to, face)) break;
    }
    return tidy;
}

std::optional<Strip> around_other_side(const Surface& surface, const Strip& strip, int vertex) {
    if (surface.is_boundary(vertex)) return std::nullopt;
    const auto has_vertex = [&](int face) { return corner_of(surface, face, vertex) >= 0; };
    const auto first = std::find_if(strip.begin(), strip.end(), has_vertex);
    const auto last = std::find_if_not(first, strip.end(), has_vertex) - 1;
    if (first == last) return std::nullopt;
    Strip around;  // counterclockwise
    for (const int side : surface.sides_from(3 * *first + corner_of(surface, *first, vertex)))
        around.push_back(Surface::face_of(side));
    if (around[1] == first[1]) std::reverse(around.begin() + 1, around.end());
    Strip other(strip.begin(), first);
    for (const int face : around) {
        other.push_back(face);
        if (face == *last) break;
    }
    other.insert(other.end(), last + 1, strip.end());
    return other;
}

}  // namespace chebnet
