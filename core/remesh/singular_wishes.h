#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "net/net.h"
#include "surface/guide.h"

namespace chebnet {

/// A singular vertex where the user wants one. Its index is k_regular_valence − valence quarter turns.
struct WishedSingular {
    Eigen::Vector3d point;  ///< on the surface, or that one of it which is nearest
    int valence;            ///< 3, 5 or 6
};

/// A part of the surface, that in a ball, in which the user wants no singular vertex.
struct ForbiddenRegion {
    Eigen::Vector3d centre;
    double radius;  ///< in the surface's unit
};

/// What the user wants of the singular vertices of a net on a whole surface.
struct SingularWishes {
    std::vector<WishedSingular> vertices;
    std::vector<ForbiddenRegion> forbidden;
    bool only = false;  ///< no others but those wished for

    bool is_empty() const { return vertices.empty() && forbidden.empty() && !only; }
};

inline constexpr int k_most_wishes = 600;  ///< vertices, and regions

/// Throws Error bad_option, non_finite or too_large: for numbers out of range, a vertex wished for inside of a
/// forbidden region, and, if there are to be no others, on a closed piece of the surface whose Euler characteristic χ
/// their indices do not add up to (Σ = 4 χ), with what is missing.
void check_wishes(const Guide& surface, const SingularWishes& wishes);

/// An inner vertex of a net at which other than four edges meet.
struct SingularVertex {
    Eigen::Vector3d position;
    int vertex, valence;
};
/// In the order of the net's vertices, where they are at rest.
std::vector<SingularVertex> singular_vertices(const Net& net);

/// Of each vertex wished for the one of its valence, nearest to its point, that stands for it; −1: there is none, nor
/// within `farthest`. No vertex stands for two.
std::vector<int> standing_for(const SingularWishes& wishes, const std::vector<SingularVertex>& singular,
                              double farthest);

/// What has become of the wishes.
struct KeptWishes {
    std::vector<double> distances;  ///< of each vertex wished for, in edges of the net: to the singular vertex of its
                                    ///< valence that stands for it; −1: there is none
    std::vector<bool> vertices;     ///< of each vertex wished for: whether that is less than k_kept_distance
    std::vector<int> intruders;     ///< of each region the singular vertices in it
    int others = 0;                 ///< singular vertices that stand for no wish, if there are to be none
    std::vector<double> creases;    ///< of each marked crease how far net lines are from it (see distance_along)

    /// How many are not kept.
    int missed() const;
};
inline constexpr double k_kept_distance = 1.5;

KeptWishes kept_wishes(const Net& net, const std::vector<SingularVertex>& singular, const SingularWishes& wishes);

/// A sentence for each wish that is not kept.
std::vector<std::string> unkept_wishes(const SingularWishes& wishes, const KeptWishes& kept);

}  // namespace chebnet
