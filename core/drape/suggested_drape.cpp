#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "drape/drape.h"
#include "drape/sample_points.h"
#include "surface/height.h"
#include "surface/segment_tree.h"

namespace chebnet {

namespace {

// A cosine: a direction nearer than that to the normal is of no use.
constexpr double k_upright = 0.9;
// In edge lengths: a net begins so far inside a border that its arms have cells on both sides. Where the surface is
// narrower, this part of as far as can be.
constexpr double k_inside = 3, k_part_of_farthest = 0.8;
// A place this near to the border, in edge lengths, is on it.
constexpr double k_on_border = 0.01;

Eigen::Vector3d centre_of_mass(const Surface& surface) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int f = 0; f < surface.face_count(); ++f)
        sum += surface.areas()[f] * surface.position_at({f, Eigen::Vector3d::Constant(1. / 3)});
    return sum / surface.area();
}

double distance_to(const SegmentTree& border, const Eigen::Vector3d& point) {
    return std::sqrt(border.nearest(point).squared_distance);
}

/// The nearest to `centre` of places all over the surface that are inside the border.
Eigen::Vector3d inside_near(const Surface& surface, const SegmentTree& border, const Eigen::Vector3d& centre,
                            double length) {
    const std::vector<SamplePoint> samples = sample_points(surface, 1 + (surface.face_count() - 1) / k_samples);
    std::vector<double> inside;
    for (const SamplePoint& sample : samples) inside.push_back(distance_to(border, surface.position_at(sample.at)));
    const double enough =
        std::min(k_inside * length, k_part_of_farthest * *std::max_element(inside.begin(), inside.end()));
    Eigen::Vector3d nearest = centre;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const Eigen::Vector3d place = surface.position_at(samples[k].at);
        const double distance = (place - centre).squaredNorm();
        if (inside[k] < enough || distance >= least) continue;
        least = distance;
        nearest = place;
    }
    return nearest;
}

/// The point nearest to the centre of mass, unless that is on a border, as that of a hole in the middle: there a net
/// would have room to one side alone.
Eigen::Vector3d middle_of(const Surface& surface, const SurfaceTree& tree, double length) {
    const Eigen::Vector3d centre = centre_of_mass(surface);
    const Eigen::Vector3d middle = tree.nearest(centre).position;
    const SegmentTree border = border_of(surface);
    const bool is_on_border = distance_to(border, middle) < k_on_border * length;
    return is_on_border ? inside_near(surface, border, centre, length) : middle;
}

}  // namespace

DrapeOptions suggested_drape(const Surface& surface, const SurfaceTree& tree, int cells) {
    if (cells < 1) throw Error(ErrorCode::bad_option, "a net has at least one cell");
    if (!(surface.area() > 0)) throw Error(ErrorCode::bad_option, "the surface has no area");
    DrapeOptions options;
    options.length = std::sqrt(surface.area() / cells);
    options.seed = middle_of(surface, tree, options.length);
    options.direction = suggested_direction(surface, tree, options.seed);
    return options;
}

Eigen::Vector3d suggested_direction(const Surface& surface, const SurfaceTree& tree, const Eigen::Vector3d& seed) {
    if (!seed.allFinite()) throw Error(ErrorCode::non_finite, "the seed has a coordinate that is not finite");
    const SurfaceTree::Nearest nearest = tree.nearest(seed);
    // The normal by which the net begins, which near creases is not the one interpolated from vertices.
    const Eigen::Vector3d normal = height_at(surface, nearest, nearest.position).normal;
    return std::abs(normal.x()) > k_upright ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
}

}  // namespace chebnet
