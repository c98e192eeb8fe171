#pragma once

#include <Eigen/Core>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

#include "base/angle.h"
#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// Deviation of one edge, dL = r + 1/r − 2 with r = length / rest length (Li et al. 2022, eq. 1), computed without
/// cancellation as (r − 1)²/r, and without overflow. It is (r − 1)² to second order: dL = 1e-6 means 0.1 % of length.
/// Infinite at r = 0.
inline double deviation(double ratio) { return (ratio - 1) * ((ratio - 1) / ratio); }

/// E, the ratio r = length / rest length of every edge. `positions` is 3×V.
Eigen::VectorXd edge_ratios(const Net& net, const Positions& positions);

/// The largest dL of some edge ratios; infinity if one of them is zero or not finite.
double max_deviation(const Eigen::VectorXd& ratios);
/// The largest dL over all edges of a net at `positions`; infinity if one has no length or is not finite.
double max_deviation(const Net& net, const Positions& positions);

/// The shortest and the longest edge at `positions` (3×V).
struct LengthRange {
    double shortest, longest;
};
LengthRange edge_length_range(const Net& net, const Positions& positions);

/// A part of L: an edge nearer to it than that has this length. Such are those of a net whose dL is below
/// k_chebyshev_deviation: a cut net that was edited and saved opens as what it is, too.
inline constexpr double k_whole_edge = 1e-3;

/// L, the rest length of more than half of all edges, if there is one: where a border has cut the net, edges there have
/// others.
std::optional<double> shared_length(const Net& net);

/// The largest dL at rest against the mean length, whatever lengths the edges keep.
double max_deviation_from_mean(const Net& net);

/// Number of corners → how many faces have so many.
std::map<int, int> faces_by_arity(const Faces& faces);

/// Smallest and largest angle at a face corner, radians in [0, π].
struct AngleRange {
    double smallest, largest;
};
AngleRange corner_angle_range(const Net& net, const Positions& positions);

/// Corners and folds that are beyond a limit by so much, in radians, are still at it.
inline constexpr double k_limit_tolerance = 0.1 * k_degree;
/// How many quads have a corner sharper than this angle, radians.
int sharp_quads(const Net& net, const Positions& positions, double angle);

/// A net that folds by more than this at an edge, radians, is crumpled there: none has to on a smooth surface.
inline constexpr double k_fold = std::numbers::pi / 3;

/// How many edges have faces whose normals are farther apart than this angle, radians, by more than k_limit_tolerance.
int sharp_folds(const Net& net, const Positions& positions, double angle);

/// The angle by which the net folds at each edge between two faces, in a fixed order; 0 where it is flat.
std::vector<double> fold_angles(const Net& net, const Positions& positions);

/// How many edges fold by k_fold more at `now` than `before`: no smooth bend folds them so. Nets that are rough as they
/// come, as coarse animals are, may fold sharply all over.
int new_folds(const Net& net, const Positions& before, const Positions& now);

/// 3×V, unit vectors by the areas of the faces at each vertex; zero where these have none.
Positions vertex_normals(const Net& net, const Positions& positions);

/// V, at each vertex the corner angle farthest from a right angle, radians in [0, π]: the shear a wire mesh shows
/// there. Of quads only, if there are any: the other faces are where a border has cut them, or at patches.
Eigen::VectorXd vertex_corner_angles(const Net& net, const Positions& positions);

/// Fairness ("bend"): root mean square, over pairs of edges a–x–b through which a net line goes straight on
/// (Topology::straight_on(), also at inward corners), of the change from rest of ‖x_a − 2x + x_b‖ / L, where L is the
/// mean rest length of the two edges. 0 for a rigid motion.
double bend(const Net& net, const Topology& topology, const Positions& positions);

}  // namespace chebnet
