#include "remesh/singular_wishes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "net/topology.h"
#include "remesh/marked_creases.h"

namespace chebnet {

namespace {

constexpr int k_wishable[] = {3, 5, 6};
constexpr int k_place_digits = 4;  // of coordinates in messages

std::string place_text(const Eigen::Vector3d& point) { return row_text(std::span(point.data(), 3), k_place_digits); }

void check_numbers(const SingularWishes& wishes) {
    if (std::ssize(wishes.vertices) > k_most_wishes || std::ssize(wishes.forbidden) > k_most_wishes)
        throw Error(ErrorCode::too_large,
                    "no more than " + std::to_string(k_most_wishes) + " singular vertices or regions are wished for");
    for (const WishedSingular& wish : wishes.vertices) {
        if (!wish.point.allFinite())
            throw Error(ErrorCode::non_finite, "a coordinate of a singular vertex is not finite");
        if (std::find(std::begin(k_wishable), std::end(k_wishable), wish.valence) == std::end(k_wishable))
            throw Error(ErrorCode::bad_option, "the singular vertex wished for at " + place_text(wish.point) +
                                                   " has valence " + std::to_string(wish.valence) +
                                                   "; it must be 3, 5 or 6");
    }
    for (const ForbiddenRegion& region : wishes.forbidden) {
        if (!region.centre.allFinite() || !std::isfinite(region.radius))
            throw Error(ErrorCode::non_finite, "a number of a forbidden region is not finite");
        if (!(region.radius > 0))
            throw Error(ErrorCode::bad_option, "the radius of a forbidden region must be positive");
    }
}

void check_regions(const SurfaceTree& tree, const SingularWishes& wishes) {
    for (const WishedSingular& wish : wishes.vertices)
        for (const ForbiddenRegion& region : wishes.forbidden)
            if ((tree.nearest(wish.point).position - region.centre).norm() < region.radius)
                throw Error(ErrorCode::bad_option, "the singular vertex wished for at " + place_text(wish.point) +
                                                       " stands in the forbidden region around " +
                                                       place_text(region.centre));
}

/// Four times the Euler characteristic of each closed piece; others are left out.
struct Piece {
    int vertices = 0, sides = 0, faces = 0, border = 0, index = 0;

    int characteristic() const { return vertices - (sides + border) / 2 + faces; }
};

std::vector<Piece> counted_pieces(const Surface& surface) {
    const std::vector<int> of_face = surface.components();
    std::vector<Piece> pieces(1 + static_cast<std::size_t>(*std::max_element(of_face.begin(), of_face.end())));
    for (int v = 0; v < surface.vertex_count(); ++v)
        ++pieces[of_face[Surface::face_of(surface.first_side(v))]].vertices;
    for (int s = 0; s < 3 * surface.face_count(); ++s) {
        Piece& piece = pieces[of_face[Surface::face_of(s)]];
        ++piece.sides;
        piece.border += surface.opposite(s) < 0 ? 1 : 0;
    }
    for (const int piece : of_face) ++pieces[piece].faces;
    return pieces;
}

void check_indices(const Guide& guide, const SingularWishes& wishes) {
    const std::vector<int> of_face = guide.surface().components();
    std::vector<Piece> pieces = counted_pieces(guide.surface());
    for (const WishedSingular& wish : wishes.vertices)
        pieces[of_face[guide.tree().nearest(wish.point).at.face]].index += k_regular_valence - wish.valence;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const Piece& piece = pieces[k];
        const int missing = k_regular_valence * piece.characteristic() - piece.index;
        if (piece.border > 0 || missing == 0) continue;
        throw Error(ErrorCode::bad_option,
                    "these singular vertices alone do not close " +
                        (pieces.size() > 1 ? "piece " + std::to_string(k + 1) + " of the surface"
                                           : std::string("the surface")) +
                        ": " + std::to_string(std::abs(missing)) + " more of valence " +
                        std::to_string(missing > 0 ? 3 : 5) + (std::abs(missing) > 1 ? " are" : " is") +
                        " missing (each of valence 3 counts 1, of 5 -1, of 6 -2, and the sum must be " +
                        std::to_string(k_regular_valence * piece.characteristic()) + ")");
    }
}

}  // namespace

void check_wishes(const Guide& surface, const SingularWishes& wishes) {
    check_numbers(wishes);
    check_regions(surface.tree(), wishes);
    if (wishes.only) check_indices(surface, wishes);
}

std::vector<SingularVertex> singular_vertices(const Net& net) {
    const Topology topology(net);
    std::vector<SingularVertex> singular;
    for (int v = 0; v < net.vertex_count(); ++v)
        if (topology.is_singular(v)) singular.push_back({net.rest_positions().col(v), v, topology.valence(v)});
    return singular;
}

int KeptWishes::missed() const {
    return static_cast<int>(
               std::count(vertices.begin(), vertices.end(), false) +
               std::count_if(intruders.begin(), intruders.end(), [](int count) { return count > 0; }) +
               std::count_if(creases.begin(), creases.end(), [](double distance) { return !is_followed(distance); })) +
           (others > 0 ? 1 : 0);
}

std::vector<int> standing_for(const SingularWishes& wishes, const std::vector<SingularVertex>& singular,
                              double farthest) {
    std::vector<int> result;
    std::vector<bool> is_taken(singular.size(), false);
    for (const WishedSingular& wish : wishes.vertices) {
        int best = -1;
        double least = farthest;
        for (std::size_t k = 0; k < singular.size(); ++k) {
            const double distance = (singular[k].position - wish.point).norm();
            if (is_taken[k] || singular[k].valence != wish.valence || !(distance <= least)) continue;
            best = static_cast<int>(k), least = distance;
        }
        result.push_back(best);
        if (best >= 0) is_taken[best] = true;
    }
    return result;
}

KeptWishes kept_wishes(const Net& net, const std::vector<SingularVertex>& singular, const SingularWishes& wishes) {
    KeptWishes kept;
    const std::vector<int> near = standing_for(wishes, singular, k_kept_distance * net.mean_length());
    const std::vector<int> any = standing_for(wishes, singular, std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < wishes.vertices.size(); ++k) {
        const int nearest = near[k] >= 0 ? near[k] : any[k];
        kept.vertices.push_back(near[k] >= 0);
        kept.distances.push_back(
            nearest < 0 ? -1 : (singular[nearest].position - wishes.vertices[k].point).norm() / net.mean_length());
    }
    for (const ForbiddenRegion& region : wishes.forbidden)
        kept.intruders.push_back(
            static_cast<int>(std::count_if(singular.begin(), singular.end(), [&](const SingularVertex& vertex) {
                return (vertex.position - region.centre).norm() < region.radius;
            })));
    if (wishes.only)
        kept.others =
            static_cast<int>(std::ssize(singular) - std::count(kept.vertices.begin(), kept.vertices.end(), true));
    return kept;
}

std::vector<std::string> unkept_wishes(const SingularWishes& wishes, const KeptWishes& kept) {
    std::vector<std::string> sentences;
    for (std::size_t k = 0; k < wishes.vertices.size(); ++k) {
        const WishedSingular& wish = wishes.vertices[k];
        if (kept.vertices[k]) continue;
        sentences.push_back("the singular vertex of valence " + std::to_string(wish.valence) + " wished for at " +
                            place_text(wish.point) +
                            (kept.distances[k] < 0 ? " has not come about"
                                                   : " is not there: the nearest stands " +
                                                         number_text(kept.distances[k], 2) + " edges away"));
    }
    for (std::size_t k = 0; k < wishes.forbidden.size(); ++k)
        if (kept.intruders[k] > 0)
            sentences.push_back(std::to_string(kept.intruders[k]) +
                                " singular vertices stand in the forbidden region around " +
                                place_text(wishes.forbidden[k].centre));
    if (kept.others > 0)
        sentences.push_back(std::to_string(kept.others) + " singular vertices stand where none were wished for");
    for (std::size_t k = 0; k < kept.creases.size(); ++k)
        if (!is_followed(kept.creases[k]))
            sentences.push_back("net lines do not run along marked crease " + std::to_string(k + 1) +
                                ": those that do so are " + number_text(kept.creases[k], 2) +
                                " edges away from it on average");
    return sentences;
}

}  // namespace chebnet
