#include "surface/curvature.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/number.h"

namespace chebnet {

namespace {

constexpr double k_pi = std::numbers::pi;
// The curvature that counts is smoothed over this part of the surface's size: features smaller than that are smaller
// than the cells of a net of a thousand.
constexpr double k_part_of_size = 1. / 30;
constexpr int k_heat_steps = 3;
constexpr double k_largest_cotangent = 100;  // of triangles that are nearly lines
constexpr double k_tolerance = 1e-6;
constexpr int k_most_iterations = 500;

double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    double sum = 0;  // in a fixed order: that of Eigen's sums depends on the compiler
    for (Eigen::Index i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

/// (M + t W) with M the areas of vertices and W the Laplacian.
class HeatStep {
public:
    HeatStep(const Surface& surface, double t) : m_areas(Eigen::VectorXd::Zero(surface.vertex_count())) {
        for (int f = 0; f < surface.face_count(); ++f)
            for (const int v : surface.triangles().col(f)) m_areas[v] += surface.areas()[f] / 3;
        for (int side = 0; side < 3 * surface.face_count(); ++side) {
            const int opposite = surface.opposite(side);
            if (opposite > side) continue;
            const double cotangents = cotangent(surface, side) + (opposite < 0 ? 0 : cotangent(surface, opposite));
            m_links.push_back({surface.from(side), surface.to(side), t * std::max(0.0, cotangents / 2)});
        }
        m_diagonal = m_areas;
        for (const Link& link : m_links) m_diagonal[link.a] += link.weight, m_diagonal[link.b] += link.weight;
    }

    /// The amounts at vertices after the step, for those before it: M (M + t W)⁻¹, by conjugate gradients.
    Eigen::VectorXd spread(const Eigen::VectorXd& amounts) const {
        Eigen::VectorXd density = Eigen::VectorXd::Zero(amounts.size()), residual = amounts, image(amounts.size());
        Eigen::VectorXd scaled = precondition(residual), search = scaled;
        double product = dot(residual, scaled);
        const double enough = k_tolerance * k_tolerance * product;
        for (int k = 0; k < k_most_iterations && product > enough; ++k) {
            multiply(search, image);
            const double step = product / dot(search, image);
            density += step * search;
            residual -= step * image;
            scaled = precondition(residual);
            const double previous = product;
            product = dot(residual, scaled);
            search = scaled + product / previous * search;
        }
        return density.cwiseProduct(m_areas);
    }

private:
    struct Link {
        int a, b;
        double weight;
    };

    /// Of the angle across from a side.
    static double cotangent(const Surface& surface, int side) {
        const Positions& x = surface.positions();
        const int across = surface.from(Surface::previous(side));
        const Eigen::Vector3d a = x.col(surface.from(side)) - x.col(across),
                              b = x.col(surface.to(side)) - x.col(across);
        const double sine = a.cross(b).norm(), cosine = a.dot(b);
        return std::abs(cosine) < k_largest_cotangent * sine ? cosine / sine
                                                             : std::copysign(k_largest_cotangent, cosine);
    }

    /// A vertex of triangles without area has nothing to scale by.
    Eigen::VectorXd precondition(const Eigen::VectorXd& residual) const {
        return (m_diagonal.array() > 0).select(residual.array() / m_diagonal.array(), 0.0);
    }

    void multiply(const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
        to = m_diagonal.cwiseProduct(from);
        for (const auto& [a, b, weight] : m_links) {
            to[a] -= weight * from[b];
            to[b] -= weight * from[a];
        }
    }

    Eigen::VectorXd m_areas, m_diagonal;
    std::vector<Link> m_links;
};

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

Prospect prospect_of(const SurfaceReport& report) {
    if (report.hardest_curvature > 2 * k_pi) return Prospect::too_curved;
    if (report.genus > 0 || report.boundary_loops != report.components) return Prospect::a_seam;
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
        text += " It has " + std::to_string(report.components) + " pieces, of which a net covers one.";
    return text;
}

}  // namespace

Eigen::VectorXd angle_defects(const Surface& surface) {
    Eigen::VectorXd defects(surface.vertex_count());
    for (int v = 0; v < surface.vertex_count(); ++v) defects[v] = surface.is_boundary(v) ? k_pi : 2 * k_pi;
    const Positions& x = surface.positions();
    for (int side = 0; side < 3 * surface.face_count(); ++side) {
        const int v = surface.from(side);
        const Eigen::Vector3d a = x.col(surface.to(side)) - x.col(v);
        const Eigen::Vector3d b = x.col(surface.from(Surface::previous(side))) - x.col(v);
        defects[v] -= std::atan2(a.cross(b).norm(), a.dot(b));
    }
    return defects;
}

Eigen::VectorXd inner_defects(const Surface& surface) {
    Eigen::VectorXd defects = angle_defects(surface);
    for (int v = 0; v < surface.vertex_count(); ++v)
        if (surface.is_boundary(v)) defects[v] = 0;
    return defects;
}

Eigen::VectorXd smoothed_angle_defects(const Surface& surface, double radius) {
    const HeatStep step(surface, radius * radius / k_heat_steps);
    Eigen::VectorXd defects = inner_defects(surface);
    for (int k = 0; k < k_heat_steps; ++k) defects = step.spread(defects);
    return defects;
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
    const Eigen::VectorXd smoothed = smoothed_angle_defects(surface, radius);
    report.smoothed_curvature = total_curvature(smoothed);
    report.hardest_curvature = hardest_curvature(surface, components, smoothed);
    report.prospect = prospect_of(report);
    report.sentence = sentence_of(report);
    return report;
}

}  // namespace chebnet
