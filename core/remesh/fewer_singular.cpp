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

std::vector<PlacedWishes::Pin> pins_of(const std::vector<Unit>& units) {
    std::vector<PlacedWishes::Pin> pins;
    for (const Unit& unit : units) pins.push_back({unit.vertex, unit.index});
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

/// Two that cancel each other, or the same twice for one that goes over the border.
struct Cancelled {
    std::size_t i = 0, j = 0;
    double distance = std::numeric_limits<double>::infinity();
};

Cancelled nearest_pair(const std::vector<Unit>& units) {
    Cancelled best;
    for (std::size_t i = 0; i < units.size(); ++i)
        for (std::size_t j = i + 1; j < units.size(); ++j) {
            const double distance = (units[i].point - units[j].point).norm();
            if (units[i].index == units[j].index || units[i].piece != units[j].piece || !(distance < best.distance))
                continue;
            best = {i, j, distance};
        }
    return best;
}

Cancelled nearest_to_border(const std::vector<Unit>& units, const std::vector<std::vector<Eigen::Vector3d>>& borders) {
    Cancelled best;
    for (std::size_t i = 0; i < units.size(); ++i)
        for (const Eigen::Vector3d& point : borders[units[i].piece]) {
            const double distance = (units[i].point - point).norm();
            if (distance < best.distance) best = {i, i, distance};
        }
    return best;
}

}  // namespace

std::vector<std::vector<PlacedWishes::Pin>> fewer_and_fewer(const Surface& surface, const DirectionField& field,
                                                            const std::vector<bool>& held_border) {
    std::vector<Unit> units = units_of(surface, field);
    const std::vector<std::vector<Eigen::Vector3d>> borders = borders_beside(surface, held_border);
    std::vector<std::vector<PlacedWishes::Pin>> result = {pins_of(units)};
    for (;;) {
        const Cancelled pair = nearest_pair(units), single = nearest_to_border(units, borders);
        const auto& [i, j, distance] = pair.distance <= single.distance ? pair : single;
        if (!std::isfinite(distance)) return result;
        if (i != j) units.erase(units.begin() + static_cast<std::ptrdiff_t>(j));
        units.erase(units.begin() + static_cast<std::ptrdiff_t>(i));
        result.push_back(pins_of(units));
    }
}

}  // namespace chebnet
