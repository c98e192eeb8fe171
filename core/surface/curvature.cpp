#include "surface/curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/number.h"
#include "surface/heat_step.h"

namespace chebnet {

namespace {

constexpr double k_pi = std::numbers::pi;
// The curvature that counts is smoothed over this part of the surface's size: features smaller than that are smaller
// than the cells of a net of a thousand.
constexpr double k_part_of_size = 1. / 30;
constexpr int k_heat_steps = 3;
// Noise of a scan is as wide as its edges: before that the surface is smoothed over so many, if they are not longer
// than this part of what curvature is smoothed over.
constexpr double k_edges_of_noise = 2, k_part_of_radius = 0.5;
// Round a hole that less than this would fill, 6°, lines of a net come back to themselves nearly.
constexpr double k_flat = 0.1;

double mean_edge(const Surface& surface) {
    double sum = 0;
    for (int side = 0; side < 3 * surface.face_count(); ++side) sum += surface.length_of(side);
    return sum / (3. * surface.face_count());
}

Positions without_noise(const Surface& surface, double radius) {
    const double width = std::min(k_edges_of_noise * mean_edge(surface), k_part_of_radius * radius);
    const HeatStep step(surface, width * width);
    Positions x = surface.positions();
    for (int coordinate = 0; coordinate < 3; ++coordinate)
        x.row(coordinate) += step.change(x.row(coordinate).transpose()).transpose();
    return x;
}

Eigen::VectorXd angle_defects_at(const Surface& surface, const Positions& x) {
    Eigen::VectorXd defects(surface.vertex_count());
    for (int v = 0; v < surface.vertex_count(); ++v) defects[v] = surface.is_boundary(v) ? k_pi : 2 * k_pi;
    for (int side = 0; side < 3 * surface.face_count(); ++side) {
        const int v = surface.from(side);
        const Eigen::Vector3d a = x.col(surface.to(side)) - x.col(v);
        const Eigen::Vector3d b = x.col(surface.from(Surface::previous(side))) - x.col(v);
        defects[v] -= std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return defects;
}

Eigen::VectorXd inner_part(const Surface& surface, Eigen::VectorXd defects) {
    for (int v = 0; v < surface.vertex_count(); ++v)
        if (surface.is_boundary(v)) defects[v] = 0;
    return defects;
}

Eigen::VectorXd spread_over(const Surface& surface, double radius, Eigen::VectorXd defects) {
    const HeatStep step(surface, radius * radius / k_heat_steps);
    for (int k = 0; k < k_heat_steps; ++k) defects = step.spread(defects);
    return defects;
}

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

Prospect prospect_of(const SurfaceReport& report, double most_curved_hole) {
    if (report.hardest_curvature > 2 * k_pi) return Prospect::too_curved;
    if (report.genus > 0 || most_curved_hole > k_flat) return Prospect::a_seam;
    return report.hardest_curvature > 2 * (k_pi - 2 * k_prospect_angle) ? Prospect::tight : Prospect::one_piece;
}

/// "1.3 π"
std::string in_pi(double radians) { return number_text(radians / k_pi, 2) + " π"; }

std::string sentence_of(const SurfaceReport& report) {
    const std::string has = in_pi(report.hardest_curvature);
    std::string text;
    switch (report.prospect) {
        case Prospect::one_piece:
            text = "One uncut piece will cover it.";
            break;
        case Prospect::tight:
            text = "One uncut piece may cover it, with corners sharper than 30°: it has a total curvature of " + has +
                   ", and one net can take 2 π.";
            break;
        case Prospect::a_seam:
            text =
                "One uncut piece will meet itself, where it goes round a hole or a handle: expect a seam there, or "
                "make a net over the whole.";
            break;
        case Prospect::too_curved:
            text = "More curvature than one net can take (" + has +
                   " of 2 π): expect a gap here, cut it, or use singular vertices.";
            break;
    }
    if (report.components > 1)
        text += " It has " + std::to_string(report.components) + " pieces: such a net covers one of them.";
    return text;
}

}  // namespace

Eigen::VectorXd angle_defects(const Surface& surface) { return angle_defects_at(surface, surface.positions()); }

Eigen::VectorXd inner_defects(const Surface& surface) { return inner_part(surface, angle_defects(surface)); }

Eigen::VectorXd smoothed_angle_defects(const Surface& surface, double radius) {
    const Eigen::VectorXd defects = angle_defects_at(surface, without_noise(surface, radius));
    return spread_over(surface, radius, inner_part(surface, defects));
}

TotalCurvature total_curvature(const Eigen::VectorXd& defects) {
    TotalCurvature total;
    for (const double defect : defects) (defect > 0 ? total.positive : total.negative) += defect;
    return total;
}

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

SurfaceReport describe(const Surface& surface) {
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
    const Eigen::VectorXd defects = angle_defects_at(surface, without_noise(surface, radius));
    const Eigen::VectorXd smoothed = spread_over(surface, radius, inner_part(surface, defects));
    report.smoothed_curvature = total_curvature(smoothed);
    report.hardest_curvature = hardest_curvature(surface, components, smoothed);
    report.prospect = prospect_of(report, most_curved_hole(surface, components, defects));
    report.sentence = sentence_of(report);
    return report;
}

}  // namespace chebnet
