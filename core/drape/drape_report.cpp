#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "drape/drape.h"
#include "net/measures.h"
#include "net/topology.h"
#include "net/triangulation.h"
#include "surface/height.h"

namespace chebnet {

namespace {

// The surface is sampled in pieces no wider than this fraction of an edge.
constexpr double k_sample = 0.25;
constexpr int k_most_cuts = 64;  // of one side of a triangle

/// Calls visit(point, area) for the middles of the equal pieces of each triangle.
template <class Visit>
void for_each_sample(const Surface& surface, double width, Visit visit) {
    for (int f = 0; f < surface.face_count(); ++f) {
        double longest = 0;
        for (int side = 3 * f; side < 3 * f + 3; ++side)
            longest = std::max(
                longest,
                (surface.positions().col(surface.to(side)) - surface.positions().col(surface.from(side))).norm());
        const int n = static_cast<int>(std::clamp(std::ceil(longest / width), 1.0, static_cast<double>(k_most_cuts)));
        const double area = surface.areas()[f] / (n * n);
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                const auto visit_at = [&](double u, double v) {
                    visit(surface.position_at({f, {1 - (u + v) / n, u / n, v / n}}), area);
                };
                visit_at(i + 1. / 3, j + 1. / 3);
                if (i + j + 1 < n) visit_at(i + 2. / 3, j + 2. / 3);
            }
    }
}

/// The faces as triangles that share no vertices: cut, two of them may have an edge in common with a third.
Surface loose_triangles(const Net& net) {
    Mesh mesh;
    const std::vector<Triangle> triangles = triangulated(net.rest_positions(), net.faces());
    mesh.positions.resize(3, 3 * std::ssize(triangles));
    for (int t = 0; t < std::ssize(triangles); ++t) {
        for (int k = 0; k < 3; ++k) mesh.positions.col(3 * t + k) = net.rest_positions().col(triangles[t][k]);
        mesh.faces.add({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return Surface(mesh);
}

double coverage(const Surface& surface, const Net& net) {
    const Surface cover = loose_triangles(net);
    const SurfaceTree tree(cover);
    double covered = 0;
    int guess = 0;
    for_each_sample(surface, k_sample * net.mean_length(), [&](const Eigen::Vector3d& point, double area) {
        const SurfaceTree::Nearest nearest = tree.nearest(point, guess);
        guess = nearest.at.face;
        if (nearest.distance <= net.mean_length() / 2) covered += area;
    });
    return covered / surface.area();
}

/// Of each face, how far from a right angle its corners are at the most.
std::vector<double> face_shears(const Net& net) {
    const Positions& x = net.rest_positions();
    std::vector<double> shears(net.face_count());
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        for (std::size_t k = 0; k < face.size(); ++k) {
            const Eigen::Vector3d a = x.col(face[(k + 1) % face.size()]) - x.col(face[k]),
                                  b = x.col(face[(k + face.size() - 1) % face.size()]) - x.col(face[k]);
            shears[f] = std::max(shears[f], std::asin(std::min(1.0, std::abs(a.dot(b)) / (a.norm() * b.norm()))));
        }
    }
    return shears;
}

}  // namespace

double part_sheared(const Net& net, double shear) {
    const std::vector<double> shears = face_shears(net);
    const auto sheared = std::count_if(shears.begin(), shears.end(), [&](double each) { return each > shear; });
    return static_cast<double>(sheared) / net.face_count();
}

DrapeReport measure_drape(const Surface& surface, const SurfaceTree& tree, const Net& net) {
    DrapeReport report{};
    const Positions& x = net.rest_positions();
    int guess = 0;
    const auto add_distance = [&](const Eigen::Vector3d& point) {
        const Height height = height_of(surface, tree, point, guess);
        guess = height.at.face;
        report.mean_distance += std::abs(height.height);
        report.largest_distance = std::max(report.largest_distance, std::abs(height.height));
    };
    for (int v = 0; v < net.vertex_count(); ++v) add_distance(x.col(v));
    for (int e = 0; e < net.edge_count(); ++e) add_distance((x.col(net.edges()(0, e)) + x.col(net.edges()(1, e))) / 2);
    report.mean_distance /= net.vertex_count() + net.edge_count();
    report.coverage = coverage(surface, net);
    const AngleRange angles = corner_angle_range(net, x);
    report.smallest_angle = angles.smallest;
    report.largest_angle = angles.largest;
    report.sheared = part_sheared(net, k_shear);
    report.much_sheared = part_sheared(net, k_much_shear);
    report.rods = static_cast<int>(Topology(net).net_lines().size());
    report.rod_length = net.rest_lengths().sum();
    report.max_deviation = max_deviation(net, x);
    return report;
}

}  // namespace chebnet
