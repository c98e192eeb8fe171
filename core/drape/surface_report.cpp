#include "drape/surface_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/error.h"
#include "base/number.h"
#include "drape/drape.h"
#include "drape/proposals.h"
#include "drape/tilt.h"
#include "surface/smoothed_surface.h"
#include "surface/surface_parts.h"

namespace chebnet {

namespace {

constexpr double k_pi = std::numbers::pi;
// The curvature that counts is smoothed over this part of the surface's size: features smaller than that are smaller
// than the cells of a net of a thousand.
constexpr double k_part_of_size = 1. / 30;
// Round a hole that less than this would fill, 6°, lines of a net come back to themselves nearly.
constexpr double k_flat = 0.1;
// Of the nets that are tried.
constexpr int k_tried_cells = 400, k_tried_places = 4;
constexpr std::array<double, 4> k_tried_turns = {0, 45, 22.5, 67.5};  // degrees
// So many refused vertices are no seam and no slit yet.
constexpr int k_few_refused = 2;
// Radians, on average: a surface that is tilted more against cells has folds or bumps that they are too large for.
constexpr double k_fine_tilt = 7 * k_degree;
// Part of a surface: what a net leaves bare may be a row of half cells at a seam or a border.
constexpr double k_covers = 0.98;
// Radians, of corners where they may be sharp.
constexpr double k_sharpest = 5 * k_degree;

int boundary_side_count(const Surface& surface) {
    int count = 0;
    for (int side = 0; side < 3 * surface.face_count(); ++side) count += surface.opposite(side) < 0;
    return count;
}

/// From Euler's V − E + F = 2 C − 2 g − B.
int genus_of(const Surface& surface, int components, int boundary_loops) {
    const int edges = (3 * surface.face_count() + boundary_side_count(surface)) / 2;
    const int characteristic = surface.vertex_count() - edges + surface.face_count();
    return (2 * components - boundary_loops - characteristic) / 2;
}

/// The larger of both signs' integrals, in the component where that is largest.
double hardest_curvature(const Surface& surface, const std::vector<int>& components, const Eigen::VectorXd& defects) {
    std::vector<TotalCurvature> totals(components.size());
    double hardest = 0;
    for (int v = 0; v < surface.vertex_count(); ++v) {
        TotalCurvature& total = totals[components[Surface::face_of(surface.first_side(v))]];
        (defects[v] > 0 ? total.positive : total.negative) += defects[v];
    }
    for (const TotalCurvature& total : totals) hardest = std::max({hardest, total.positive, -total.negative});
    return hardest;
}

/// The curvature of what would fill a hole smoothly, by Gauss and Bonnet from how its border turns.
double curvature_within(const Surface& surface, const std::vector<int>& loop, const Eigen::VectorXd& defects) {
    double turn = 0;
    for (const int side : loop) turn += defects[surface.from(side)];
    return 2 * k_pi + turn;
}

/// The most that would fill a hole; of each component the longest loop is its border.
double most_curved_hole(const Surface& surface, const std::vector<int>& components, const Eigen::VectorXd& defects) {
    std::vector<std::vector<int>> loops = surface.boundary_loops();
    std::stable_sort(loops.begin(), loops.end(),
                     [&](const auto& a, const auto& b) { return surface.length_of(a) > surface.length_of(b); });
    std::vector<bool> has_border(components.size(), false);
    double most = 0;
    for (const std::vector<int>& loop : loops) {
        const int component = components[Surface::face_of(loop.front())];
        if (has_border[component]) most = std::max(most, std::abs(curvature_within(surface, loop, defects)));
        has_border[component] = true;
    }
    return most;
}

/// The component with most area.
std::shared_ptr<const Guide> largest_piece(const std::shared_ptr<const Guide>& guide, int components) {
    if (components == 1) return guide;
    std::vector<Surface> pieces = pieces_of(guide->surface());
    const auto largest = std::max_element(pieces.begin(), pieces.end(),
                                          [](const Surface& a, const Surface& b) { return a.area() < b.area(); });
    return std::make_shared<const Guide>(std::move(*largest));
}

struct TriedNet {
    DrapeOptions options;
    double coverage = 0;
    bool is_whole = false;  // nothing of it locks or meets itself, and its cells are as fine as the surface
    bool is_first = false;  // from where a net begins unless it is told otherwise

    bool covers() const { return coverage >= k_covers; }
    bool is_good() const { return covers() && is_whole; }
    auto rank() const { return std::pair(is_good(), coverage); }
};

/// Nothing where no cell fits.
std::optional<TriedNet> tried_net(const Guide& guide, const DrapeOptions& options) {
    try {
        const Drape laid = drape(guide.surface(), guide.tree(), options);
        return TriedNet{options, sampled_coverage(guide.surface(), laid.net, options.length),
                        laid.locked + laid.met <= k_few_refused && mean_tilt(guide, laid.net) <= k_fine_tilt};
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// From some places, until nets cover the surface, and in some directions, until one of these is whole.
std::optional<TriedNet> best_tried_net(const Guide& guide) {
    if (!(guide.surface().area() > 0 && std::isfinite(guide.surface().area()))) return std::nullopt;
    DrapeOptions options = suggested_drape(guide.surface(), guide.tree(), k_tried_cells);
    const Positions places = places_to_begin(guide.surface(), options.seed);
    std::optional<TriedNet> best;
    for (int place = 0; place < k_tried_places; ++place) {
        const SurfaceTree::Nearest seed = guide.tree().nearest(places.col(place));
        options.seed = seed.position;
        const Eigen::Vector3d normal = guide.surface().normal_at(seed.at);
        for (const double turn : k_tried_turns) {
            options.direction = direction_in_surface(normal, turn * k_degree);
            std::optional<TriedNet> net = tried_net(guide, options);
            if (!net || (best && net->rank() <= best->rank())) continue;
            net->is_first = place == 0 && turn == 0;
            best = std::move(net);
            if (best->is_good()) return best;
        }
        if (best && best->covers()) return best;
    }
    return best;
}

bool covers_with_sharp_corners(const Guide& guide, DrapeOptions options) {
    options.smallest_angle = k_sharpest;
    const std::optional<TriedNet> net = tried_net(guide, options);
    return net && net->covers();
}

/// `goes_round`: whether the surface has something that a net comes back round to itself.
Prospect prospect_of(const SurfaceReport& report, const Guide& laid_on, const std::optional<TriedNet>& net,
                     bool goes_round) {
    const bool covers = net ? net->covers() : report.hardest_curvature <= 2 * k_pi;
    if (!covers && (goes_round || !net || !covers_with_sharp_corners(laid_on, net->options)))
        return Prospect::too_curved;
    if (goes_round) return Prospect::a_seam;
    return net && net->is_good() ? Prospect::one_piece : Prospect::tight;
}

/// A tube or a torus, for which a net over the whole needs no singular vertices.
bool is_ring(const SurfaceReport& report) {
    return report.components == 1 && 2 * report.genus + report.boundary_loops == 2;
}

std::string sentence_of(const SurfaceReport& report, bool begins_anywhere) {
    std::string text;
    switch (report.prospect) {
        case Prospect::one_piece:
            text = begins_anywhere ? "One uncut piece will cover it."
                                   : "One uncut piece will cover it, if it begins at a good place.";
            break;
        case Prospect::tight:
            text = "One uncut piece may cover it, with a slit or with corners sharper than 30° at some places.";
            break;
        case Prospect::a_seam:
            text =
                "One uncut piece will meet itself, as it does round a closed body, a hole or a handle: expect a seam "
                "there, or make a net over the whole.";
            break;
        case Prospect::too_curved:
            text = (is_ring(report) ? "One piece laid from a point leaves gaps on the way round"
                                    : "More curvature than one net can take") +
                   (": coarse ones that were tried covered up to " + number_text(100 * report.tried_coverage, 2)) +
                   " %. " +
                   (is_ring(report) ? "Make a net over the whole, which goes round it, or cut it."
                                    : "Expect gaps here, cut it, or use singular vertices.");
            break;
    }
    if (report.components > 1)
        text += " It has " + std::to_string(report.components) + " pieces: such a net covers one of them.";
    return text;
}

}  // namespace

const char* to_string(Prospect prospect) {
    switch (prospect) {
        case Prospect::one_piece:
            return "one_piece";
        case Prospect::tight:
            return "tight";
        case Prospect::a_seam:
            return "a_seam";
        case Prospect::too_curved:
            return "too_curved";
    }
    return "";
}

SurfaceReport describe(const std::shared_ptr<const Guide>& guide) {
    const Surface& surface = guide->surface();
    SurfaceReport report{};
    report.vertices = surface.vertex_count();
    report.triangles = surface.face_count();
    report.triangles_without_area = static_cast<int>((surface.areas().array() == 0).count());
    const std::vector<int> components = surface.components();
    report.components = 1 + *std::max_element(components.begin(), components.end());
    report.boundary_loops = static_cast<int>(surface.boundary_loops().size());
    report.genus = genus_of(surface, report.components, report.boundary_loops);
    report.area = surface.area();
    report.curvature = total_curvature(inner_defects(surface));
    const double radius = k_part_of_size * std::sqrt(surface.area());
    const Eigen::VectorXd defects = angle_defects_without_noise(surface, radius);
    const Eigen::VectorXd smoothed = spread_inner_defects(surface, radius, defects);
    report.smoothed_curvature = total_curvature(smoothed);
    report.hardest_curvature = hardest_curvature(surface, components, smoothed);
    const std::shared_ptr<const Guide> laid_on =
        without_roughness(largest_piece(guide, report.components), std::sqrt(surface.area() / k_tried_cells));
    const std::optional<TriedNet> net = best_tried_net(*laid_on);
    report.tried_coverage = net ? net->coverage : 0;
    const bool goes_round =
        report.genus > 0 || report.boundary_loops == 0 || most_curved_hole(surface, components, defects) > k_flat;
    report.prospect = prospect_of(report, *laid_on, net, goes_round);
    report.sentence = sentence_of(report, net && net->is_first);
    return report;
}

SurfaceReport describe(const Surface& surface) { return describe(std::make_shared<const Guide>(surface)); }

}  // namespace chebnet
