#pragma once

#include <Eigen/Core>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "base/angle.h"
#include "base/enum_names.h"
#include "net/net.h"
#include "surface/surface.h"
#include "surface/surface_tree.h"

namespace chebnet {

/// How a net is laid on a surface from one point.
struct DrapeOptions {
    /// What happens where the surface ends.
    enum class Border {
        inside,  ///< no vertex stands beyond it
        beyond,  ///< cells go over it that have a vertex on the surface; there it goes on as flat as it is there. Not
                 ///< over a cut, behind which another part of the net lies: see `slits` and `seam`
        cut,     ///< likewise, and then rods are cut at the boundary curve (see cut_at_border)
    };
    /// How the net lines through the seed run, from which all others follow.
    enum class Arms {
        geodesic,
        least_shear,  ///< bent so that cells are sheared less (see least_shear_arms), where that makes a better net
        curve,  ///< of the first family along a drawn curve, and straight on behind its ends; of the other geodesic
    };

    Eigen::Vector3d seed = Eigen::Vector3d::Zero();        ///< the vertex to begin with is the nearest point to it
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< of the first family of net lines there
    double length = 1;                                     ///< L, of all edges
    double angle = std::numbers::pi / 2;                   ///< between the two families at the seed
    double smallest_angle = k_usual_shear_limit;           ///< no corner is sharper, nor blunter than π less it
    int reach = std::numeric_limits<int>::max();           ///< cells from the seed along either family
    Border border = Border::beyond;
    Arms arms = Arms::geodesic;
    /// Of Arms::curve, 3×N points near the surface, joined by shortest paths; the last may be the first again. The seed
    /// goes to the nearest point of the curve, from which the first family runs as it was drawn, whatever `direction`.
    Positions along{};
    /// Where boundary runs along boundary, as along a cut, no edge goes across. Else what is near enough is joined.
    bool slits = false;
    /// Of each side of the surface's triangles, whether it was cut from another surface there; empty where it was
    /// nowhere. With `slits` no edge goes across such sides, either.
    std::vector<bool> seam{};
    bool beyond_cuts = false;  ///< with Border::beyond cells go over cuts, too: for rods that are to be cut there later
};

inline constexpr EnumName<DrapeOptions::Border> k_drape_borders[] = {{"inside", DrapeOptions::Border::inside},
                                                                     {"beyond", DrapeOptions::Border::beyond},
                                                                     {"cut", DrapeOptions::Border::cut}};
inline constexpr EnumName<DrapeOptions::Arms> k_drape_arms[] = {{"geodesic", DrapeOptions::Arms::geodesic},
                                                                {"least_shear", DrapeOptions::Arms::least_shear},
                                                                {"curve", DrapeOptions::Arms::curve}};

/// A beginning for want of a better one: from the point nearest to the centre of mass or, where that is on a border,
/// the nearest one some cells inside, in the suggested direction, with the length that gives about so many `cells` (≥
/// 1) if the whole is covered.
DrapeOptions suggested_drape(const Surface& surface, const SurfaceTree& tree, int cells);

/// From a seed: along the x axis or, where that is nearly upright, the y axis. Throws Error non_finite.
Eigen::Vector3d suggested_direction(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& seed);

/// A net on a surface, and why it is not larger: how many times a further vertex was refused.
struct Drape {
    Net net;
    Eigen::Matrix2Xi places;  ///< 2×V, the steps from the seed to each vertex along the first and the second family; to
                              ///< the end of a rod that was cut, those to the vertex beyond the border
    std::vector<int> faces;  ///< V, of the surface, the triangle at each vertex: on its side of slits
    int locked = 0;          ///< its corners would have been too sharp or too blunt, or no such point exists
    int met = 0;             ///< it would have stood on the net, or not one edge away from all its neighbours
    int cut_ends = 0;        ///< of rods at the boundary curve, each behind a shorter edge
    DrapeOptions::Arms arms = DrapeOptions::Arms::geodesic;  ///< those it has: geodesic ones also where others that
                                                             ///< were to shear less would not have made a better net
};

/// One patch of a net from a seed, each vertex on the surface and each edge of length L up to rounding. From the seed
/// four arms run along straightest geodesics, or as `arms` says; each further vertex is the point of the surface one
/// edge away from two known ones, across from a third (Compass), those nearest to the seed first. Where no such vertex
/// is left, net lines at the rim go straight on, once for each bay.
///
/// Where the net locks or a corner would break the limit, and where the net comes round to itself, no vertex is set: a
/// gap stays, and what hangs on the patch by a corner is taken off. The result is the same natively and in WebAssembly
/// up to the last bits of the angles given.
///
/// Where rods were cut, each edge keeps a length of its own: L but for those at the border.
///
/// Throws Error bad_option (a length or angles out of range, a direction upright on the surface, no cell fits there, a
/// curve that is not on the surface or shorter than an edge), non_finite, too_large (more than k_most_draped_vertices).
Drape drape(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options);

/// Throws Error bad_option or non_finite where drape() would for the numbers alone.
void check_drape(const Surface& surface, const DrapeOptions& options);

inline constexpr int k_most_draped_vertices = 2'000'000;

/// Shear, radians: at 15° programs for draping cloth begin to warn, at 30° they call it the most that cloth bears.
inline constexpr double k_shear = std::numbers::pi / 12, k_much_shear = std::numbers::pi / 6;

// In what follows `length` is L, where it is known: a net of few cells, most of whose edges a border has cut, does not
// say it.

/// The part of a net's whole cells (see DrapeReport) with a corner farther than `shear` (radians) from a right angle.
double part_sheared(const Net& net, double shear, std::optional<double> length = {});

/// How far the corner of each whole cell that is farthest from a right angle is from it, radians, root mean square.
double rms_shear(const Net& net, std::optional<double> length = {});

/// The part of a surface's area that is within half an edge of a net, by about two thousand samples or some more (see
/// sample_points): a fast guess at the coverage of DrapeReport.
double sampled_coverage(const Surface& surface, const Net& net, std::optional<double> length = {});

/// How well a net lies on a surface. Its whole cells are those that no border has cut: quads with edges of length L.
struct DrapeReport {
    double length;                           ///< L: of most edges, or as given, or whole_length() if is_cut(), or mean
    double coverage;                         ///< part of the surface's area that is within L / 2 of the net
    double open_border;                      ///< length of the net's border that is not beside the surface's, or is so
                                             ///< where the surface goes on bare: of gaps, and of both sides of slits,
                                             ///< which coverage counts as covered
    int gaps;                                ///< how many stretches of border that is; a whole loop is one
    double mean_distance, largest_distance;  ///< of vertices and middles of edges from the surface, beyond its border
                                             ///< from where it would go on; in the surface's unit
    int whole_cells;                         ///< without any, the next four say nothing
    double smallest_angle, largest_angle;    ///< of corners of whole cells, radians
    double sheared, much_sheared;  ///< parts of the whole cells with a corner more than k_shear, k_much_shear from
                                   ///< a right angle
    int folds;                     ///< edges at which the net folds by more than k_fold: it is crumpled there
    int rods;                      ///< net lines, each from end to end, but for those along a border that cuts: rods()
    double rod_length;             ///< of all of them together, in the surface's unit
    double max_deviation;          ///< the largest dL
};

/// Takes about a microsecond for each sample of the surface, of which there are at least as many as triangles.
DrapeReport measure_drape(const Surface& surface, const SurfaceTree& tree, const Net& net,
                          std::optional<double> length = {});

}  // namespace chebnet
