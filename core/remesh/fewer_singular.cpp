#include "remesh/fewer_singular.h"

#include <Eigen/Core>
#include <limits>
#include <utility>

namespace chebnet {

namespace {

/// A singular vertex of index 1 or −1; two of them stand where a vertex has twice as much.
struct Unit {
    Eigen::Vector3d point;
    int index, piece;
};

std::vector<Unit> units_of(const Surface& surface, const DirectionField& field) {
    const std::vector<int> of_face = surface.components();
    std::vector<Unit> units;
    for (int v = 0; v < surface.vertex_count(); ++v) {
        const int turns = field.holonomy[v];
        // Three quarter turns are one the other way.
        for (int k = 0; k < (turns == 2 ? 2 : turns == 0 ? 0 : 1); ++k)
            units.push_back(
                {surface.positions().col(v), turns == 3 ? -1 : 1, of_face[Surface::face_of(surface.first_side(v))]});
    }
    return units;
}

SingularWishes wishes_of(const std::vector<Unit>& units) {
    SingularWishes wishes;
    wishes.only = true;
    for (const Unit& unit : units) wishes.vertices.push_back({unit.point, k_regular_valence - unit.index});
    return wishes;
}

/// Of opposite index and nearest to each other; the same twice if there are none.
std::pair<std::size_t, std::size_t> nearest_pair(const std::vector<Unit>& units) {
    std::pair<std::size_t, std::size_t> best = {0, 0};
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < units.size(); ++i)
        for (std::size_t j = i + 1; j < units.size(); ++j) {
            const double distance = (units[i].point - units[j].point).norm();
            if (units[i].index == units[j].index || units[i].piece != units[j].piece || !(distance < least)) continue;
            best = {i, j}, least = distance;
        }
    return best;
}

}  // namespace

std::vector<SingularWishes> fewer_and_fewer(const Surface& surface, const DirectionField& field) {
    std::vector<Unit> units = units_of(surface, field);
    std::vector<SingularWishes> result = {wishes_of(units)};
    for (;;) {
        const auto [i, j] = nearest_pair(units);
        if (i == j) return result;
        units.erase(units.begin() + static_cast<std::ptrdiff_t>(j));
        units.erase(units.begin() + static_cast<std::ptrdiff_t>(i));
        result.push_back(wishes_of(units));
    }
}

}  // namespace chebnet
