#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "drape/compass.h"

namespace chebnet {

/// Whether two vertices of a net, so many steps along each of its two families from each other, are nearer to each
/// other on one side of the surface than a net comes that does not lie on itself: vertices more than two steps apart
/// keep 1.03 edge lengths where it is sheared to 30°, and less only across short diagonals of cells that are sharper.
/// `smallest_angle`: of their corners, radians.
inline bool lie_on_each_other(const Compass& compass, const DrapedVertex& a, const DrapedVertex& b,
                              const Eigen::Vector2i& steps, double smallest_angle) {
    constexpr double k_least_distance = 0.7;  // in edge lengths
    constexpr double k_least_part = 0.68;     // of short diagonals in a row, which bend
    constexpr int k_near_steps = 2;
    const Eigen::Vector2i apart = steps.cwiseAbs();
    const double distance = (a.position - b.position).norm();
    if (apart.sum() <= k_near_steps || distance >= k_least_distance * compass.length()) return false;
    if (apart[0] == apart[1]) {
        const double diagonal = 2 * std::sin(smallest_angle / 2) * compass.length();
        if (distance >= k_least_part * apart[0] * diagonal) return false;
    }
    return a.normal.dot(b.normal) > 0 && !compass.is_slit_between(a, b);
}

/// Vertices by the cube of space in which they are, by a hash.
class Surroundings {
public:
    /// `size`: of a cube.
    explicit Surroundings(double size) : m_size(size) {}

    void add(const Eigen::Vector3d& position, int vertex) { m_vertices.emplace(key_of(cube_of(position)), vertex); }

    /// Whether `condition` holds for one of the vertices in this cube and those around it, and maybe for some farther
    /// away.
    template <class Condition>
    bool any_near(const Eigen::Vector3d& position, Condition condition) const {
        const Cube cube = cube_of(position);
        for (int a = -1; a <= 1; ++a)
            for (int b = -1; b <= 1; ++b)
                for (int c = -1; c <= 1; ++c) {
                    const auto [begin, end] = m_vertices.equal_range(key_of({cube[0] + a, cube[1] + b, cube[2] + c}));
                    for (auto entry = begin; entry != end; ++entry)
                        if (condition(entry->second)) return true;
                }
        return false;
    }

private:
    using Cube = std::array<std::int64_t, 3>;

    Cube cube_of(const Eigen::Vector3d& position) const {
        Cube cube{};
        for (int k = 0; k < 3; ++k)
            cube[k] = static_cast<std::int64_t>(std::clamp(std::floor(position[k] / m_size), -k_farthest, k_farthest));
        return cube;
    }

    static std::uint64_t key_of(const Cube& cube) {
        std::uint64_t key = 0;
        for (const std::int64_t number : cube) {
            key = (key ^ static_cast<std::uint64_t>(number)) * 0x9E3779B97F4A7C15u;
            key ^= key >> 32;
        }
        return key;
    }

    static constexpr double k_farthest = 0x1p62;  // all beyond is in one cube

    double m_size;
    std::unordered_multimap<std::uint64_t, int> m_vertices;
};

}  // namespace chebnet
