#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "drape/drape.h"
#include "drape/sample_points.h"
#include "net/corner_edges.h"
#include "net/measures.h"
#include "net/rods.h"
#include "net/topology.h"
#include "net/triangulation.h"
#include "surface/guide.h"
#include "surface/height.h"
#include "surface/middles.h"
#include "surface/segment_tree.h"

namespace chebnet {

namespace {

// The surface is sampled in pieces no wider than this fraction of an edge.
constexpr double k_sample = 0.25;
constexpr int k_most_cuts = 64;  // of one side of a triangle
// In L, of what is beside the surface's border: a net that ends inside it is off by a cell's diagonal at most.
constexpr double k_beside_border = 1.5;
// In L: how far in front of the net's border the surface is looked at, and what is beyond its border there.
constexpr double k_ahead = 2, k_least_overhang = 1e-3;

/// Calls visit(point, area) for the middles of the equal pieces of each triangle.
template <class Visit>
void for_each_sample(const Surface& surface, double width, Visit visit) {
    for (int f = 0; f < surface.face_count(); ++f) {
        double longest = 0;
        for (int side = 3 * f; side < 3 * f + 3; ++side) longest = std::max(longest, surface.length_of(side));
        const int n = static_cast<int>(std::clamp(std::ceil(longest / width), 1.0, static_cast<double>(k_most_cuts)));
        const double area = surface.areas()[f] / (n * n);
        for_each_middle(n, [&](const Eigen::Vector3d& weights) { visit(surface.position_at({f, weights}), area); });
    }
}

/// The faces as triangles. One without area covers nothing: a quad may lie folded on itself.
std::vector<Triangle> triangles_with_area(const Net& net) {
    std::vector<Triangle> triangles = triangulated(net.rest_positions(), net.faces());
    std::erase_if(triangles,
                  [&](const Triangle& triangle) { return area_vector(net.rest_positions(), triangle).isZero(0); });
    return triangles;
}

/// Triangles that share no vertices: of faces that were cut, two may have an edge in common with a third.
Surface loose(const Net& net, const std::vector<Triangle>& triangles) {
    Mesh mesh;
    mesh.positions.resize(3, 3 * std::ssize(triangles));
    for (int t = 0; t < std::ssize(triangles); ++t) {
        for (int k = 0; k < 3; ++k) mesh.positions.col(3 * t + k) = net.rest_positions().col(triangles[t][k]);
        mesh.faces.add({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return Surface(mesh);
}

/// What is within half an edge of a net.
class Cover {
public:
    /// `triangles`: of the net, at least one.
    Cover(const Net& net, const std::vector<Triangle>& triangles, double length)
        : m_triangles(loose(net, triangles)), m_tree(m_triangles), m_length(length) {}

    bool covers(const Eigen::Vector3d& point) { return is_within(m_length / 2, point); }

    bool is_within(double distance, const Eigen::Vector3d& point) {
        SurfaceTree::Nearest near = m_tree.nearest_in(m_guess, point);  // which answers most
        if (near.distance > distance) near = m_tree.nearest(point, m_guess);
        m_guess = near.at.face;
        return near.distance <= distance;
    }

private:
    Surface m_triangles;
    SurfaceTree m_tree;
    double m_length;
    int m_guess = 0;
};

/// Nothing if the net has no area.
std::unique_ptr<Cover> cover_of(const Net& net, double length) {
    const std::vector<Triangle> triangles = triangles_with_area(net);
    return triangles.empty() ? nullptr : std::make_unique<Cover>(net, triangles, length);
}

double coverage(const Surface& surface, Cover& cover, double length) {
    double covered = 0;
    for_each_sample(surface, k_sample * length, [&](const Eigen::Vector3d& point, double area) {
        if (cover.covers(point)) covered += area;
    });
    return std::min(1.0, covered / surface.area());  // the pieces' areas are not to the last digit that of the whole
}

/// Of each edge at the border, a vector of length 1 out of its only face, in the plane of that; zero if it has none.
Positions outward_directions(const Net& net, const Topology& topology) {
    const Positions& x = net.rest_positions();
    const std::vector<int> edges = corner_edges(net, topology);
    Positions out = Positions::Zero(3, net.edge_count());
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const int v : face) middle += x.col(v) / static_cast<double>(face.size());
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Eigen::Vector3d a = x.col(face[k]), along = (x.col(face[(k + 1) % face.size()]) - a).normalized();
            const Eigen::Vector3d away = a - middle;
            out.col(edges[net.faces().start[f] + static_cast<int>(k)]) = (away - away.dot(along) * along).normalized();
        }
    }
    return out;
}

/// Whether the surface goes on bare in front of an edge, though its border is near, as that of a narrow strip is
/// everywhere.
bool is_bare_before(const Surface& surface, const SurfaceTree& tree, Cover& cover, const Eigen::Vector3d& ahead,
                    double length) {
    const SurfaceTree::Nearest near = tree.nearest(ahead);
    const bool goes_on =
        near.distance <= length && height_at(surface, near, ahead).overhang <= k_least_overhang * length;
    return goes_on && !cover.is_within(length, near.position);
}

/// Of each edge, whether it is on the net's border but not beside the surface's, or beside it where the surface goes on
/// bare. What lies beyond the surface's border has it for its nearest place.
std::vector<bool> open_edges(const Surface& surface, const SurfaceTree& tree, const Net& net, const Topology& topology,
                             Cover* cover, double length) {
    const SegmentTree border = border_of(surface);
    const double beside = k_beside_border * length;
    std::vector<bool> is_open(static_cast<std::size_t>(net.edge_count()));
    const Positions& x = net.rest_positions();
    const Positions out = outward_directions(net, topology);
    int guess = 0;
    for (int e = 0; e < net.edge_count(); ++e) {
        if (net.edge_face_counts()[e] != 1) continue;
        const Eigen::Vector3d middle = (x.col(net.edges()(0, e)) + x.col(net.edges()(1, e))) / 2;
        const SurfaceTree::Nearest near = tree.nearest(middle, guess);
        guess = near.at.face;
        is_open[e] =
            !(border.nearest(surface.position_at(near.at)).squared_distance <= beside * beside) ||
            (cover != nullptr && is_bare_before(surface, tree, *cover, middle + k_ahead * length * out.col(e), length));
    }
    return is_open;
}

/// How often a walk along the border comes to an open edge from one that is not; once, if all of a loop is open.
int runs_of(const std::vector<bool>& is_open, const Topology& topology) {
    int runs = 0;
    for (const std::vector<int>& loop : topology.boundary_loops()) {
        const auto is_open_from = [&](std::size_t k) {
            return is_open[topology.edge_between(loop[k % loop.size()], loop[(k + 1) % loop.size()])];
        };
        int begun = 0, open = 0;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            open += is_open_from(k) ? 1 : 0;
            begun += is_open_from(k + 1) && !is_open_from(k) ? 1 : 0;
        }
        runs += open == std::ssize(loop) ? 1 : begun;
    }
    return runs;
}

void add_open_border(const Surface& surface, const SurfaceTree& tree, const Net& net, const Topology& topology,
                     Cover* cover, DrapeReport& report) {
    const std::vector<bool> is_open = open_edges(surface, tree, net, topology, cover, report.length);
    for (int e = 0; e < net.edge_count(); ++e)
        if (is_open[e]) report.open_border += net.rest_lengths()[e];
    report.gaps = runs_of(is_open, topology);
}

/// L: those at a border may be cut. `known`: where these are most, as of a net of few cells, most do not say it.
double length_of_most(const Net& net, std::optional<double> known) {
    if (const std::optional<double> shared = shared_length(net)) return *shared;
    if (known) return *known;
    const Topology topology(net);
    return is_cut(net, topology) ? whole_length(net) : net.mean_length();
}

/// The smallest and the largest corner of each whole cell.
std::vector<AngleRange> whole_cells(const Net& net, double length) {
    const Positions& x = net.rest_positions();
    std::vector<AngleRange> cells;
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        AngleRange corners{std::numbers::pi, 0};
        bool is_whole = face.size() == 4;
        for (std::size_t k = 0; k < face.size() && is_whole; ++k) {
            const Eigen::Vector3d a = x.col(face[(k + 1) % 4]) - x.col(face[k]),
                                  b = x.col(face[(k + 3) % 4]) - x.col(face[k]);
            is_whole = std::abs(a.norm() - length) < k_whole_edge * length;
            const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
            corners = {std::min(corners.smallest, angle), std::max(corners.largest, angle)};
        }
        if (is_whole) cells.push_back(corners);
    }
    return cells;
}

void add_rods(const Net& net, const Topology& topology, std::optional<double> length, DrapeReport& report) {
    for (const std::vector<int>& rod : rods(net, topology, length)) {
        ++report.rods;
        for (std::size_t k = 0; k + 1 < rod.size(); ++k)
            report.rod_length += net.rest_lengths()[topology.edge_between(rod[k], rod[k + 1])];
    }
}

/// Of the corner that is farthest from a right angle.
double shear_of(const AngleRange& corners) {
    const double right = std::numbers::pi / 2;
    return std::max(right - corners.smallest, corners.largest - right);
}

double part_sheared(const std::vector<AngleRange>& cells, double shear) {
    const auto sheared =
        std::count_if(cells.begin(), cells.end(), [&](const AngleRange& corners) { return shear_of(corners) > shear; });
    return cells.empty() ? 0 : static_cast<double>(sheared) / static_cast<double>(cells.size());
}

}  // namespace

double sampled_coverage(const Surface& surface, const Net& net, std::optional<double> length) {
    const std::unique_ptr<Cover> cover = cover_of(net, length_of_most(net, length));
    if (!cover) return 0;
    double covered = 0, area = 0;
    for (const SamplePoint& sample : sample_points(surface, std::max(1, surface.face_count() / k_samples))) {
        area += sample.area;
        if (cover->covers(surface.position_at(sample.at))) covered += sample.area;
    }
    return area > 0 ? covered / area : 0;
}

double part_sheared(const Net& net, double shear, std::optional<double> length) {
    return part_sheared(whole_cells(net, length_of_most(net, length)), shear);
}

double rms_shear(const Net& net, std::optional<double> length) {
    const std::vector<AngleRange> cells = whole_cells(net, length_of_most(net, length));
    double sum = 0;
    for (const AngleRange& corners : cells) sum += shear_of(corners) * shear_of(corners);
    return cells.empty() ? 0 : std::sqrt(sum / static_cast<double>(cells.size()));
}

DrapeReport measure_drape(const Surface& surface, const SurfaceTree& tree, const Net& net,
                          std::optional<double> length) {
    DrapeReport report{};
    report.length = length_of_most(net, length);
    const Positions& x = net.rest_positions();
    const Topology topology(net);
    const GuideDistance distance = distance_to(surface, tree, net, x);
    report.mean_distance = distance.mean;
    report.largest_distance = distance.largest;
    const std::unique_ptr<Cover> cover = cover_of(net, report.length);
    report.coverage = cover ? coverage(surface, *cover, report.length) : 0;
    add_open_border(surface, tree, net, topology, cover.get(), report);
    const std::vector<AngleRange> cells = whole_cells(net, report.length);
    report.whole_cells = static_cast<int>(std::ssize(cells));
    report.smallest_angle = std::numbers::pi;
    for (const AngleRange& corners : cells) {
        report.smallest_angle = std::min(report.smallest_angle, corners.smallest);
        report.largest_angle = std::max(report.largest_angle, corners.largest);
    }
    report.sheared = part_sheared(cells, k_shear);
    report.much_sheared = part_sheared(cells, k_much_shear);
    report.folds = sharp_folds(net, x, k_fold);
    add_rods(net, topology, length, report);
    report.max_deviation = max_deviation(net, x);
    return report;
}

}  // namespace chebnet
