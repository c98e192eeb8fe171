#pragma once

#include <vector>

#include "drape/drape.h"

namespace chebnet {

/// Where a net may begin, and what came of it when it was tried.
struct DrapeProposal {
    DrapeOptions options;
    double covered = 0;        ///< part of the surface: of the net asked for by sampled_coverage(), of others by the
                               ///< area of their cells
    double much_sheared = 0;   ///< part of the cells with a corner more than k_much_shear from a right angle
    double shear = 0;          ///< of the cells, see rms_shear()
    double mean_distance = 0;  ///< of vertices and middles of edges from the surface, in edge lengths

    /// What is covered, less what shear and distance count against it.
    double worth() const;
};

/// Tries nets of about a thousand cells with geodesic arms from places spread over the surface, in six directions each,
/// and the best of them with the edges and the arms asked for; geodesic ones where a curve is drawn for them. Gives the
/// best of each place, those first that cover most and, among like ones, are sheared least and come nearest to the
/// surface. All but seed and direction is as in `options`. Takes about as long as laying a net of fifty thousand cells.
/// Throws Error as drape does if no place takes a net.
std::vector<DrapeProposal> propose_drapes(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options);

/// Likewise, all in the direction of `options`.
std::vector<DrapeProposal> propose_seeds(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options);

/// The best direction at a seed that is given, of six with such nets: `options` with it, or as they are where none
/// takes a net. Throws Error bad_option or non_finite as check_drape does.
DrapeOptions with_best_direction(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options);

/// Eight places on a surface: the first as given, the others in the middles of parts of about one size (Lloyd 1982),
/// for the ends of a surface are no good beginning.
Positions places_to_begin(const Surface& surface, const Eigen::Vector3d& first);

/// A vector in the plane that touches the surface, so many radians from where the x axis lies there, or the y axis
/// where that stands upright.
Eigen::Vector3d direction_in_surface(const Eigen::Vector3d& normal, double angle);

}  // namespace chebnet
