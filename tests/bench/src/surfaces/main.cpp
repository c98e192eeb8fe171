// What others do on a surface, from the seed and with the edge length that our net has, as JSON:
//   chebnet_surface_rivals (own:NAME | FILE) CELLS
// `plain compass`: each further vertex is A + B − D laid onto the surface, and no length is made exact. `local_global`:
// that net, then each edge takes its length and each vertex its nearest point of the surface by itself, and one
// constant linear system fits them together (Bouaziz et al., Shape-Up, 2012, with closeness).

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "drape/drape.h"
#include "io/file.h"
#include "io/mesh_file.h"
#include "net/measures.h"
#include "surface/gallery.h"
#include "surface/height.h"

namespace chebnet {
namespace {

using Json = nlohmann::ordered_json;

// In edge lengths: a vertex farther beyond the border is not set.
constexpr double k_most_overhang = 0.5;
// Of the cells that would cover the surface: going round a closed body, a net without an end ends here.
constexpr double k_most_cells = 1.3;
// Radians: a fourth vertex between edges closer to each other is not set.
constexpr double k_locked = 0.1;
constexpr int k_iterations = 200;
constexpr double k_closeness = 0.1;  // where an edge's length weighs 1

/// Vertices by their places, and cells of four.
class PlainCompass {
public:
    PlainCompass(const Surface& surface, const SurfaceTree& tree, const DrapeOptions& options)
        : m_surface(surface), m_tree(tree), m_options(options) {
        const SurfaceTree::Nearest seed = tree.nearest(options.seed);
        m_at[{0, 0}] = add(seed.position, seed.at.face);
        const Eigen::Vector3d normal = surface.normal_at(seed.at);
        const Eigen::Vector3d u = (options.direction - options.direction.dot(normal) * normal).normalized();
        const Eigen::Vector3d v = normal.cross(u);
        const auto most = static_cast<std::size_t>(k_most_cells * surface.area() / options.length / options.length);
        for (int steps = 1; m_points.size() < most; ++steps) {
            const std::size_t before = m_points.size();
            for (int i = -steps; i <= steps; ++i)
                for (const int sign : {1, -1}) {
                    const int j = sign * (steps - std::abs(i));
                    if (j == 0 && sign < 0) continue;
                    if (i == 0 || j == 0)
                        arm(i, j, i != 0 ? (i > 0 ? u : -u) : (j > 0 ? v : -v));
                    else
                        fourth(i, j);
                }
            if (m_points.size() == before) return;
        }
    }

    Mesh mesh() const {
        Mesh mesh{Positions(3, std::ssize(m_points)), {}};
        std::vector<int> number(m_points.size(), -1);
        int count = 0;
        const auto numbered = [&](int vertex) {
            if (number[vertex] < 0) {
                number[vertex] = count;
                mesh.positions.col(count++) = m_points[vertex];
            }
            return number[vertex];
        };
        for (const auto& [place, d] : m_at) {
            const auto a = find(place.first + 1, place.second), b = find(place.first, place.second + 1),
                       c = find(place.first + 1, place.second + 1);
            if (a && b && c) mesh.faces.add({numbered(d), numbered(*a), numbered(*c), numbered(*b)});
        }
        mesh.positions.conservativeResize(3, count);
        return mesh;
    }

private:
    std::optional<int> find(int i, int j) const {
        const auto at = m_at.find({i, j});
        return at == m_at.end() ? std::nullopt : std::optional(at->second);
    }

    int add(const Eigen::Vector3d& point, int face) {
        m_points.push_back(point);
        m_faces.push_back(face);
        return static_cast<int>(m_points.size()) - 1;
    }

    /// The nearest point of the surface to a guess, which may stand beyond its border.
    void lay(int i, int j, const Eigen::Vector3d& guess, int from) {
        const Height height = height_of(m_surface, m_tree, guess, m_faces[from]);
        if (height.overhang > k_most_overhang * m_options.length) return;
        m_at[{i, j}] = add(guess - height.height * height.normal, height.at.face);
    }

    void arm(int i, int j, const Eigen::Vector3d& direction) {
        const int di = (i > 0) - (i < 0), dj = (j > 0) - (j < 0);
        const auto last = find(i - di, j - dj), before = find(i - 2 * di, j - 2 * dj);
        if (!last) return;
        const bool is_first = std::abs(i) + std::abs(j) == 1;
        if (!is_first && !before) return;
        const Eigen::Vector3d along =
            is_first ? direction : Eigen::Vector3d(m_points[*last] - m_points[*before]).normalized();
        lay(i, j, m_points[*last] + m_options.length * along, *last);
    }

    void fourth(int i, int j) {
        const int di = i > 0 ? 1 : -1, dj = j > 0 ? 1 : -1;
        const auto a = find(i - di, j), b = find(i, j - dj), d = find(i - di, j - dj);
        if (!a || !b || !d) return;
        const Eigen::Vector3d u = m_points[*a] - m_points[*d], v = m_points[*b] - m_points[*d];
        const double angle = std::atan2(u.cross(v).norm(), u.dot(v));
        if (angle < k_locked || angle > EIGEN_PI - k_locked) return;
        lay(i, j, m_points[*a] + v, *a);
    }

    const Surface& m_surface;
    const SurfaceTree& m_tree;
    const DrapeOptions& m_options;
    std::map<std::pair<int, int>, int> m_at;
    std::vector<Eigen::Vector3d> m_points;
    std::vector<int> m_faces;
};

Positions fitted(const Surface& surface, const SurfaceTree& tree, const Net& net, double length) {
    const int n = net.vertex_count();
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(n) + 4 * static_cast<std::size_t>(net.edge_count()));
    for (int v = 0; v < n; ++v) entries.emplace_back(v, v, k_closeness);
    for (int e = 0; e < net.edge_count(); ++e) {
        const int a = net.edges()(0, e), b = net.edges()(1, e);
        for (const auto& [row, column, value] : {std::tuple(a, a, 1.), {b, b, 1.}, {a, b, -1.}, {b, a, -1.}})
            entries.emplace_back(row, column, value);
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    Positions x = net.rest_positions();
    std::vector<int> face(static_cast<std::size_t>(n), 0);
    for (int k = 0; k < k_iterations; ++k) {
        Eigen::MatrixX3d right(n, 3);
        for (int v = 0; v < n; ++v) {
            const Height height = height_of(surface, tree, x.col(v), face[v]);
            face[v] = height.at.face;
            right.row(v) = k_closeness * (x.col(v) - height.height * height.normal).transpose();
        }
        for (int e = 0; e < net.edge_count(); ++e) {
            const int a = net.edges()(0, e), b = net.edges()(1, e);
            const Eigen::Vector3d edge = length * (x.col(a) - x.col(b)).normalized();
            right.row(a) += edge.transpose();
            right.row(b) -= edge.transpose();
        }
        x = factor.solve(right).transpose();
    }
    return x;
}

double largest_error(const Net& net, const Positions& x, double length) {
    double largest = 0;
    for (int e = 0; e < net.edge_count(); ++e)
        largest = std::max(largest, deviation((x.col(net.edges()(0, e)) - x.col(net.edges()(1, e))).norm() / length));
    return largest;
}

Json measured(const Surface& surface, const SurfaceTree& tree, const Net& net, double length, double milliseconds) {
    const DrapeReport report = measure_drape(surface, tree, net);
    const double smallest = corner_angle_range(net, net.rest_positions()).smallest;
    return {{"cells", net.face_count()},
            {"milliseconds", milliseconds},
            {"coverage", report.coverage},
            {"gaps", report.gaps},
            {"mean_distance_in_lengths", report.mean_distance / length},
            {"largest_distance_in_lengths", report.largest_distance / length},
            {"smallest_corner_angle_degrees", smallest * 180 / EIGEN_PI},
            {"max_dL", largest_error(net, net.rest_positions(), length)}};
}

Surface opened(const std::string& name) {
    const std::string own = "own:";
    if (name.starts_with(own)) return make_own_surface(name.substr(own.size()));
    return repaired_surface(read_mesh(read_file(name), name), k_all_defects).surface;
}

int run(const std::string& name, int cells) {
    const Surface surface = opened(name);
    const SurfaceTree tree(surface);
    const DrapeOptions options = suggested_drape(surface, tree, cells);
    Stopwatch watch;
    const Mesh mesh = PlainCompass(surface, tree, options).mesh();
    const double laying = watch.milliseconds();
    const Net plain(mesh.positions, mesh.faces, RestLengths::own);
    watch.restart();
    const Positions x = fitted(surface, tree, plain, options.length);
    const double fitting = watch.milliseconds();
    const Net near(x, plain.faces(), RestLengths::own);
    const Json report = {{"plain compass", measured(surface, tree, plain, options.length, laying)},
                         {"local-global", measured(surface, tree, near, options.length, laying + fitting)}};
    std::puts(report.dump(2).c_str());
    return 0;
}

}  // namespace
}  // namespace chebnet

int main(int count, char** arguments) {
    try {
        if (count != 3) throw std::invalid_argument("usage: chebnet_surface_rivals (own:NAME | FILE) CELLS");
        return chebnet::run(arguments[1], std::atoi(arguments[2]));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
