#include "drape/draped_net.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/error.h"

namespace chebnet {

namespace {

template <class Visit>
void for_each_edge(const std::vector<int>& face, Visit visit) {
    for (std::size_t k = 0; k < face.size(); ++k)
        visit(std::pair<int, int>(std::minmax(face[k], face[(k + 1) % face.size()])));
}

}  // namespace

bool keeps_limit(const std::array<Eigen::Vector3d, 4>& cell, double largest_cosine) {
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector3d a = cell[(k + 1) % 4] - cell[k], b = cell[(k + 3) % 4] - cell[k];
        if (std::abs(a.dot(b)) > largest_cosine * a.norm() * b.norm()) return false;
    }
    return true;
}

std::vector<std::vector<int>> joined_to_seed(const std::vector<std::vector<int>>& faces) {
    std::map<std::pair<int, int>, std::vector<std::size_t>> faces_at;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for_each_edge(faces[f], [&](const auto& edge) { faces_at[edge].push_back(f); });
    std::vector<bool> is_reached(faces.size());
    std::vector<std::size_t> waiting;
    const auto reach = [&](std::size_t f) {
        if (!is_reached[f]) waiting.push_back(f);
        is_reached[f] = true;
    };
    for (std::size_t f = 0; f < faces.size() && waiting.empty(); ++f)
        if (std::count(faces[f].begin(), faces[f].end(), 0) > 0) reach(f);
    while (!waiting.empty()) {
        const std::size_t here = waiting.back();
        waiting.pop_back();
        for_each_edge(faces[here], [&](const auto& edge) {
            for (const std::size_t f : faces_at[edge]) reach(f);
        });
    }
    std::vector<std::vector<int>> joined;
    for (std::size_t f = 0; f < faces.size(); ++f)
        if (is_reached[f]) joined.push_back(faces[f]);
    return joined;
}

Drape draped_net(const std::vector<DrapedVertex>& vertices, const Eigen::Matrix2Xi& places, const BorderCut& cut) {
    if (cut.faces.empty())
        throw Error(ErrorCode::bad_option, "no cell of this edge length fits on the surface at the seed");
    std::vector<int> number(vertices.size() + cut.ends.size(), -1);
    for (const std::vector<int>& face : cut.faces)
        for (const int v : face) number[v] = 0;
    std::vector<std::size_t> kept;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<int>(kept.size());
        kept.push_back(v);
    }
    Faces faces;
    for (std::vector<int> face : cut.faces) {
        for (int& v : face) v = number[v];
        faces.add(face);
    }
    Positions positions(3, std::ssize(kept));
    Eigen::Matrix2Xi kept_places(2, std::ssize(kept));
    std::vector<int> at;
    int cut_ends = 0;
    for (Eigen::Index k = 0; k < std::ssize(kept); ++k) {
        const std::size_t v = kept[static_cast<std::size_t>(k)];
        const bool is_end = v >= vertices.size();
        cut_ends += is_end;
        const DrapedVertex& vertex = is_end ? cut.ends[v - vertices.size()].vertex : vertices[v];
        positions.col(k) = vertex.position;
        at.push_back(vertex.at.face);
        kept_places.col(k) = places.col(is_end ? cut.ends[v - vertices.size()].beyond : static_cast<Eigen::Index>(v));
    }
    return {Net(std::move(positions), std::move(faces), RestLengths::automatic),
            std::move(kept_places),
            std::move(at),
            0,
            0,
            cut_ends};
}

}  // namespace chebnet
