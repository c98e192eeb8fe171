#include "drape/proposals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "base/error.h"
#include "drape/sample_points.h"
#include "net/triangulation.h"
#include "surface/guide.h"

namespace chebnet {

namespace {

constexpr int k_seeds = 8;
constexpr int k_directions = 6;  // over a right angle: after that a net of two like families repeats itself
constexpr int k_trial_cells = 1000;
constexpr std::size_t k_finals = 4;  // how many are tried with the edges asked for
constexpr int k_lloyd_steps = 6;
// A much sheared cell counts as so much of an uncovered one, and so does the shear of all of them, in radians, squared,
// which decides among nets that are nowhere much sheared, and a cell one edge length off the surface.
constexpr double k_much_shear_weight = 0.05, k_shear_weight = 0.01, k_distance_weight = 0.2;

/// All over the surface.
Positions samples_of(const Surface& surface) {
    const std::vector<SamplePoint> points = sample_points(surface, 1 + (surface.face_count() - 1) / k_samples);
    Positions samples(3, std::ssize(points));
    for (std::size_t k = 0; k < points.size(); ++k)
        samples.col(static_cast<Eigen::Index>(k)) = surface.position_at(points[k].at);
    return samples;
}

/// The number of the nearest of the first `count` places.
int nearest_of(const Positions& places, int count, const Eigen::Vector3d& point) {
    int nearest = 0;
    for (int k = 1; k < count; ++k)
        if ((places.col(k) - point).squaredNorm() < (places.col(nearest) - point).squaredNorm()) nearest = k;
    return nearest;
}

/// Each next one as far from all before as can be.
Positions far_apart(const Positions& samples, const Eigen::Vector3d& first) {
    Positions places(3, k_seeds);
    places.col(0) = first;
    for (int count = 1; count < k_seeds; ++count) {
        double farthest = -1;
        for (int k = 0; k < samples.cols(); ++k) {
            const Eigen::Vector3d sample = samples.col(k);
            const double distance = (places.col(nearest_of(places, count, sample)) - sample).squaredNorm();
            if (distance <= farthest) continue;
            farthest = distance;
            places.col(count) = sample;
        }
    }
    return places;
}

/// Of its faces, some of which a border may have cut.
double area_of(const Net& net) {
    double area = 0;
    for (const Triangle& triangle : triangulated(net.rest_positions(), net.faces()))
        area += area_vector(net.rest_positions(), triangle).norm() / 2;
    return area;
}

void rank(std::vector<DrapeProposal>& proposals) {
    std::stable_sort(proposals.begin(), proposals.end(),
                     [](const DrapeProposal& a, const DrapeProposal& b) { return a.worth() > b.worth(); });
}

double distance_of(const Surface& surface, const SurfaceTree& tree, const Net& net, double length) {
    return distance_to(surface, tree, net, net.rest_positions()).mean / length;
}

/// What comes of it with edges of some length; nothing where no cell fits.
std::optional<DrapeProposal> tried(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options,
                                   double length, DrapeOptions::Arms arms, DrapeOptions::Border border) {
    DrapeOptions trial = options;
    trial.length = length;
    trial.border = border;
    trial.arms = arms;
    try {
        const Net net = drape(surface, tree, trial).net;
        return DrapeProposal{options, std::min(1.0, area_of(net) / surface.area()),
                             part_sheared(net, k_much_shear, length), rms_shear(net, length),
                             distance_of(surface, tree, net, length)};
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// The net that is asked for, by what it covers: how ragged its border is says nothing.
std::optional<DrapeProposal> finished(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options,
                                      DrapeOptions::Arms arms) {
    DrapeOptions last = options;
    last.arms = arms;
    try {
        const Net net = drape(surface, tree, last).net;
        const double length = options.length;
        return DrapeProposal{options, sampled_coverage(surface, net, length), part_sheared(net, k_much_shear, length),
                             rms_shear(net, length), distance_of(surface, tree, net, length)};
    } catch (const Error&) {
        return std::nullopt;
    }
}

using Directions = std::vector<Eigen::Vector3d>;

Directions directions_at(const Eigen::Vector3d& normal) {
    Directions directions;
    for (int k = 0; k < k_directions; ++k)
        directions.push_back(direction_in_surface(normal, k * std::numbers::pi / 2 / k_directions));
    return directions;
}

/// `given`: in this direction; else the best of several.
std::optional<DrapeProposal> best_at(const Surface& surface, const SurfaceTree& tree, DrapeOptions options,
                                     const SurfaceTree::Nearest& place, DrapeOptions::Border border,
                                     const std::optional<Eigen::Vector3d>& given = {}) {
    const double length = std::max(options.length, std::sqrt(surface.area() / k_trial_cells));
    std::optional<DrapeProposal> best;
    options.seed = place.position;
    for (const Eigen::Vector3d& direction : given ? Directions{*given} : directions_at(surface.normal_at(place.at))) {
        options.direction = direction;
        const auto proposal = tried(surface, tree, options, length, DrapeOptions::Arms::geodesic, border);
        if (proposal && (!best || proposal->worth() > best->worth())) best = proposal;
    }
    return best;
}

std::vector<DrapeProposal> best_at_each(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options,
                                        const Positions& places, DrapeOptions::Border border,
                                        const std::optional<Eigen::Vector3d>& given) {
    std::vector<DrapeProposal> proposals;
    for (const Eigen::Vector3d place : places.colwise())
        if (const auto best = best_at(surface, tree, options, tree.nearest(place), border, given))
            proposals.push_back(*best);
    return proposals;
}

std::vector<DrapeProposal> proposals_for(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options,
                                         const std::optional<Eigen::Vector3d>& given) {
    check_drape(surface, options);
    const Positions places = places_to_begin(surface, suggested_drape(surface, tree, k_trial_cells).seed);
    std::vector<DrapeProposal> proposals =
        best_at_each(surface, tree, options, places, DrapeOptions::Border::inside, given);
    // What is narrower than two cells has room for none but across its border.
    if (proposals.empty()) proposals = best_at_each(surface, tree, options, places, options.border, given);
    if (proposals.empty()) {
        drape(surface, tree, options);  // says why, unless just this beginning does it
        proposals.push_back({options});
    }
    rank(proposals);
    // A curve that was drawn goes through one seed only.
    const auto arms = options.arms == DrapeOptions::Arms::curve ? DrapeOptions::Arms::geodesic : options.arms;
    for (std::size_t k = 0; k < std::min(k_finals, proposals.size()); ++k)
        if (const auto last = finished(surface, tree, proposals[k].options, arms)) proposals[k] = *last;
    rank(proposals);
    return proposals;
}

}  // namespace

Positions places_to_begin(const Surface& surface, const Eigen::Vector3d& first) {
    const Positions samples = samples_of(surface);
    Positions places = far_apart(samples, first);
    for (int step = 0; step < k_lloyd_steps; ++step) {
        Positions sums = Positions::Zero(3, k_seeds);
        Eigen::VectorXd counts = Eigen::VectorXd::Zero(k_seeds);
        for (int k = 0; k < samples.cols(); ++k) {
            const int nearest = nearest_of(places, k_seeds, samples.col(k));
            sums.col(nearest) += samples.col(k);
            counts[nearest] += 1;
        }
        for (int k = 1; k < k_seeds; ++k)
            if (counts[k] > 0) places.col(k) = sums.col(k) / counts[k];
    }
    return places;
}

Eigen::Vector3d direction_in_surface(const Eigen::Vector3d& normal, double angle) {
    const Eigen::Vector3d axis = std::abs(normal.x()) > 0.9 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
    const Eigen::Vector3d u = (axis - axis.dot(normal) * normal).normalized();
    return std::cos(angle) * u + std::sin(angle) * normal.cross(u);
}

double DrapeProposal::worth() const {
    return covered - k_much_shear_weight * much_sheared - k_shear_weight * shear * shear -
           k_distance_weight * mean_distance;
}

std::vector<DrapeProposal> propose_drapes(const Surface& surface, const SurfaceTree& tree,
                                          const DrapeOptions& options) {
    return proposals_for(surface, tree, options, std::nullopt);
}

std::vector<DrapeProposal> propose_seeds(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options) {
    return proposals_for(surface, tree, options, options.direction);
}

DrapeOptions with_best_direction(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options) {
    check_drape(surface, options);
    const SurfaceTree::Nearest seed = tree.nearest(options.seed);
    for (const DrapeOptions::Border border : {DrapeOptions::Border::inside, options.border}) {
        const auto best = best_at(surface, tree, options, seed, border);
        if (!best) continue;
        DrapeOptions directed = options;
        directed.direction = best->options.direction;
        return directed;
    }
    return options;
}

}  // namespace chebnet
