#include "remesh/fewer_singular.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace chebnet {

namespace {

/// A singular vertex of index 1 or −1; two of them stand where a vertex has twice as much.
struct Unit {
    Eigen::Vector3d point;
    int vertex, index, piece;
};

std::vector<Unit> units_of(const Surface& surface, const DirectionField& field) {
    const std::vector<int> of_face = surface.components();
    std::vector<Unit> units;
    for (int v = 0; v < surface.vertex_count(); ++v) {
        const int turns = field.holonomy[v];
        // Three quarter turns are one the other way.
        for (int k = 0; k < (turns == 2 ? 2 : turns == 0 ? 0 : 1); ++k)
            units.push_back(
                {surface.positions().col(v), v, turns == 3 ? -1 : 1, of_face[Surface::face_of(surface.first_side(v))]});
    }
    return units;
}

std::vector<PlacedWishes::Pin> pins_of(const std::vector<Unit>& units, const std::vector<bool>& is_left) {
    std::vector<PlacedWishes::Pin> pins;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (is_left[i]) pins.push_back({units[i].vertex, units[i].index});
    return pins;
}

/// Of each piece, the vertices of its border where none of these sides is.
std::vector<std::vector<Eigen::Vector3d>> borders_beside(const Surface& surface, const std::vector<bool>& sides) {
    const std::vector<int> of_face = surface.components();
    std::vector<std::vector<Eigen::Vector3d>> borders(
        static_cast<std::size_t>(of_face.empty() ? 0 : 1 + *std::max_element(of_face.begin(), of_face.end())));
    for (int s = 0; s < 3 * surface.face_count(); ++s)
        if (surface.opposite(s) < 0 && (sides.empty() || !sides[s]))
            borders[of_face[Surface::face_of(s)]].push_back(surface.positions().col(surface.from(s)));
    return borders;
}

/// Two that can cancel each other, or the same twice for one that can go over the border.
struct Cancelling {
    std::size_t i, j;
    double distance;
};

/// From the nearest on; of equally near ones pairs come first, and the first of both.
std::vector<Cancelling> ways_to_cancel(const std::vector<Unit>& units,
                                       const std::vector<std::vector<Eigen::Vector3d>>& borders) {
    std::vector<Cancelling> ways;
    for (std::size_t i = 0; i < units.size(); ++i)
        for (std::size_t j = i + 1; j < units.size(); ++j)
            if (units[i].index != units[j].index && units[i].piece == units[j].piece)
                ways.push_back({i, j, (units[i].point - units[j].point).norm()});
    for (std::size_t i = 0; i < units.size(); ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& point : borders[units[i].piece])
            least = std::min(least, (units[i].point - point).norm());
        if (std::isfinite(least)) ways.push_back({i, i, least});
    }
    std::stable_sort(ways.begin(), ways.end(),
                     [](const Cancelling& a, const Cancelling& b) { return a.distance < b.distance; });
    return ways;
}

}  // namespace

std::vector<std::vector<PlacedWishes::Pin>> fewer_and_fewer(const Surface& surface, const DirectionField& field,
                                                            const std::vector<bool>& held_border) {
    const std::vector<Unit> units = units_of(surface, field);
    std::vector<bool> is_left(units.size(), true);
    std::vector<std::vector<PlacedWishes::Pin>> result = {pins_of(units, is_left)};
    for (const auto& [i, j, distance] : ways_to_cancel(units, borders_beside(surface, held_border))) {
        if (!is_left[i] || !is_left[j]) continue;
        is_left[i] = is_left[j] = false;
        result.push_back(pins_of(units, is_left));
    }
    return result;
}

}  // namespace chebnet
