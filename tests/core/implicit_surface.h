#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <map>
#include <utility>

#include "net/mesh.h"

namespace chebnet::samples {

/// Where a function is 0 in a box of n³ cubes, each cut into six tetrahedra (Doi & Koide 1991): triangles of all forms,
/// slivers among them, turned towards where the function is above 0. Open where the box ends.
inline Mesh implicit_surface(int n, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                             const std::function<double(const Eigen::Vector3d&)>& function) {
    const auto number = [n](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
    std::vector<Eigen::Vector3d> points;
    std::vector<double> values;
    for (int k = 0; k <= n; ++k)
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                points.emplace_back(low + Eigen::Vector3d(i, j, k).cwiseProduct(high - low) / n);
                values.push_back(function(points.back()));
            }
    Mesh mesh;
    std::vector<Eigen::Vector3d> vertices;
    std::map<std::pair<int, int>, int> vertex_on;
    const auto crossing = [&](int a, int b) {  // of the edge between a grid point below and one above
        const auto [at, is_new] = vertex_on.emplace(std::minmax(a, b), static_cast<int>(vertices.size()));
        if (is_new) vertices.emplace_back((values[b] * points[a] - values[a] * points[b]) / (values[b] - values[a]));
        return at->second;
    };
    const auto add = [&](int p, int q, int r, const Eigen::Vector3d& upwards) {
        const Eigen::Vector3d normal = (vertices[q] - vertices[p]).cross(vertices[r] - vertices[p]);
        normal.dot(upwards) > 0 ? mesh.faces.add({p, q, r}) : mesh.faces.add({p, r, q});
    };
    const auto cut = [&](const std::array<int, 4>& corners) {
        std::vector<int> below, above;
        for (const int c : corners) (values[c] < 0 ? below : above).push_back(c);
        if (below.empty() || above.empty()) return;
        Eigen::Vector3d upwards = Eigen::Vector3d::Zero();
        for (const int b : below)
            for (const int a : above) upwards += points[a] - points[b];
        if (below.size() == 2) {
            const int quad[] = {crossing(below[0], above[0]), crossing(below[0], above[1]),
                                crossing(below[1], above[1]), crossing(below[1], above[0])};
            add(quad[0], quad[1], quad[2], upwards);
            add(quad[0], quad[2], quad[3], upwards);
            return;
        }
        const int alone = below.size() == 1 ? below[0] : above[0];
        const std::vector<int>& others = below.size() == 1 ? above : below;
        add(crossing(alone, others[0]), crossing(alone, others[1]), crossing(alone, others[2]), upwards);
    };
    constexpr std::array<std::array<int, 2>, 6> k_orders = {{{0, 1}, {0, 2}, {1, 0}, {1, 2}, {2, 0}, {2, 1}}};
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (const auto& order : k_orders) {  // along the cube's axes, one after the other
                    std::array<int, 3> at{i, j, k};
                    std::array<int, 4> corners{number(i, j, k), 0, 0, number(i + 1, j + 1, k + 1)};
                    for (std::size_t step = 0; step < 2; ++step) {
                        ++at[order[step]];
                        corners[step + 1] = number(at[0], at[1], at[2]);
                    }
                    cut(corners);
                }
    mesh.positions.resize(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t v = 0; v < vertices.size(); ++v) mesh.positions.col(static_cast<Eigen::Index>(v)) = vertices[v];
    return mesh;
}

}  // namespace chebnet::samples
