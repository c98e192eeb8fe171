#include "remesh/wish_placer.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <span>

#include "base/error.h"
#include "base/text.h"
#include "net/topology.h"

namespace chebnet {

namespace {

// No singular vertex is to be so near to a forbidden region, in cells: it moves a little in the end.
constexpr double k_margin = 1.5;
// Nor so near to a pinned one.
constexpr double k_own = 4;
// A pinned vertex is no farther than so many cells from where it is wished for.
constexpr double k_farthest = 3;
constexpr int k_digits = 4;  // of coordinates in messages

}  // namespace

/// A place on one side of a surface. Through a thin plate, or from piece to piece, what is near in space is not so on
/// it.
struct WishPlacer::Place {
    Eigen::Vector3d point, normal;
    int piece;  // as Surface::components() counts them

    bool is_on_side(const Eigen::Vector3d& other) const { return normal.dot(other) >= 0; }
};

/// Vertices where another one has its place, or beside it.
class WishPlacer::Taken {
public:
    explicit Taken(const Surface& surface) : m_is_taken(static_cast<std::size_t>(surface.vertex_count()), false) {}

    bool has(int vertex) const { return m_is_taken[vertex]; }
    void take(const Surface& surface, int vertex) {
        for (const int f : surface.faces_around(vertex))
            for (const int v : surface.triangles().col(f)) m_is_taken[v] = true;
    }

private:
    std::vector<bool> m_is_taken;
};

WishPlacer::WishPlacer(const Surface& surface, double cell)
    : m_surface(surface), m_tree(surface), m_pieces(surface.components()), m_cell(cell) {}

/// On the triangles of this surface, whose pieces need not have the same numbers as those of the surface of `tree`.
WishPlacer::Place WishPlacer::place_of(const Eigen::Vector3d& wished, const SurfaceTree& tree) const {
    const SurfaceTree::Nearest there = tree.nearest(wished);
    Place place{there.position, tree.surface().face_normals().col(there.at.face), -1};
    const int nearest = m_tree.nearest(place.point).at.face;
    if (place.is_on_side(m_surface.face_normals().col(nearest))) {
        place.piece = m_pieces[nearest];
        return place;
    }
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < m_surface.face_count(); ++f) {
        if (!place.is_on_side(m_surface.face_normals().col(f))) continue;
        const double distance = m_tree.nearest_in(f, place.point).distance;
        if (distance < least) least = distance, place.piece = m_pieces[f];
    }
    return place;
}

/// A direction turns by 2π · index / triangles from one to the next, which must be clearly less than half a turn.
bool WishPlacer::may_pin(const Taken& taken, int vertex, int index) const {
    return !taken.has(vertex) && !m_surface.is_boundary(vertex) &&
           std::ssize(m_surface.faces_around(vertex)) > 2 * std::abs(index) + 1;
}

int WishPlacer::nearest_vertex(const Taken& taken, const Place& place, int index) const {
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < m_surface.vertex_count(); ++v) {
        const double distance = (m_surface.positions().col(v) - place.point).squaredNorm();
        if (!(distance < least) || m_pieces[Surface::face_of(m_surface.first_side(v))] != place.piece ||
            !place.is_on_side(m_surface.vertex_normals().col(v)) || !may_pin(taken, v, index))
            continue;
        best = v, least = distance;
    }
    return best;
}

PlacedWishes::Pin WishPlacer::pin(Taken& taken, const Place& place, int index, const Eigen::Vector3d& wished) const {
    const int vertex = nearest_vertex(taken, place, index);
    if (vertex < 0 || (m_surface.positions().col(vertex) - place.point).norm() > k_farthest * m_cell)
        throw Error(ErrorCode::bad_option,
                    "the singular vertex wished for at " + row_text(std::span(wished.data(), 3), k_digits) +
                        " has no place of its own: smaller cells would make some, or others are too near");
    return pin(taken, vertex, index);
}

PlacedWishes::Pin WishPlacer::pin(Taken& taken, int vertex, int index) const {
    taken.take(m_surface, vertex);
    return {vertex, index};
}

void WishPlacer::forbid(const std::vector<ForbiddenRegion>& regions, PlacedWishes& wishes) const {
    for (int f = 0; f < m_surface.face_count(); ++f) {
        const Eigen::Vector3d centre = m_surface.position_at({f, Eigen::Vector3d::Constant(1.0 / 3)});
        const auto is_within = [&](const Eigen::Vector3d& point, double radius) {
            return (centre - point).norm() < radius;
        };
        wishes.is_forbidden.push_back(
            std::any_of(regions.begin(), regions.end(),
                        [&](const ForbiddenRegion& region) {
                            return is_within(region.centre, region.radius + k_margin * m_cell);
                        }) ||
            std::any_of(wishes.pins.begin(), wishes.pins.end(), [&](const PlacedWishes::Pin& pin) {
                return is_within(m_surface.positions().col(pin.vertex), k_own * m_cell);
            }));
    }
}

PlacedWishes WishPlacer::placed(const SingularWishes& wishes, const SurfaceTree& tree) const {
    PlacedWishes result;
    result.only = wishes.only;
    Taken taken(m_surface);
    for (const WishedSingular& wish : wishes.vertices)
        result.pins.push_back(pin(taken, place_of(wish.point, tree), k_regular_valence - wish.valence, wish.point));
    forbid(wishes.forbidden, result);
    return result;
}

PlacedWishes WishPlacer::placed_alone(const std::vector<PlacedWishes::Pin>& pins, const SurfaceTree& tree) const {
    PlacedWishes result;
    result.only = true;
    Taken taken(m_surface);
    for (const auto& [vertex, index] : pins) {
        const Eigen::Vector3d wished = m_surface.positions().col(vertex);
        const bool stays = may_pin(taken, vertex, index);
        result.pins.push_back(stays ? pin(taken, vertex, index) : pin(taken, place_of(wished, tree), index, wished));
    }
    forbid({}, result);
    return result;
}

}  // namespace chebnet
