#include "remesh/cones.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "net/topology.h"
#include "remesh/even_triangles.h"
#include "surface/curvature.h"
#include "surface/heat_step.h"

namespace chebnet {

namespace {

// The surface is reckoned with on so many even triangles, and cones stand on so many of their vertices.
constexpr int k_cone_triangles = 4000, k_cone_sites = 300;
// With more vertices, as where it is too thin for such triangles, it would take too much memory.
constexpr int k_most_cone_vertices = 10'000;
constexpr int k_most_cones = 60, k_most_cone_moves = 200;
// Of what is left, a cone has to take away this part, and a move something that survives rounding.
constexpr double k_least_gain = 1e-3, k_least_move_gain = 1e-6;
constexpr double k_quarter_turn = std::numbers::pi / 2;

using Laplacian = Eigen::SparseMatrix<double>;

EvenTriangles triangles_for_cones(const Surface& surface, const SurfaceTree& tree) {
    // An equilateral triangle of edge 1 has the area √3/4.
    return even_triangles(surface, tree, std::sqrt(surface.area() / k_cone_triangles * 4 / std::sqrt(3.0)));
}

bool has_closed_piece(const Surface& surface) {
    const std::vector<int> pieces = surface.components();
    std::vector<bool> is_closed(1 + static_cast<std::size_t>(*std::max_element(pieces.begin(), pieces.end())), true);
    for (int side = 0; side < 3 * surface.face_count(); ++side)
        if (surface.opposite(side) < 0) is_closed[pieces[Surface::face_of(side)]] = false;
    return std::find(is_closed.begin(), is_closed.end(), true) != is_closed.end();
}

std::vector<int> inner_vertices(const Surface& surface) {
    std::vector<int> inner;
    for (int v = 0; v < surface.vertex_count(); ++v)
        if (!surface.is_boundary(v)) inner.push_back(v);
    return inner;
}

/// Of each vertex its place among the inner ones; −1 on the boundary.
std::vector<Eigen::Index> rows_of(const std::vector<int>& inner, int vertex_count) {
    std::vector<Eigen::Index> row(static_cast<std::size_t>(vertex_count), -1);
    for (std::size_t i = 0; i < inner.size(); ++i) row[inner[i]] = static_cast<Eigen::Index>(i);
    return row;
}

/// Of inner vertices; on the boundary u is 0.
Laplacian laplacian_of(const Surface& triangles, const std::vector<Eigen::Index>& row, std::size_t count) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int side = 0; side < 3 * triangles.face_count(); ++side) {
        const Eigen::Index a = row[triangles.from(side)], b = row[triangles.to(side)];
        const double weight = std::max(0.0, cotangent(triangles, side)) / 2;
        if (a >= 0) entries.emplace_back(a, a, weight);
        if (b >= 0) entries.emplace_back(b, b, weight);
        if (a >= 0 && b >= 0) entries.emplace_back(a, b, -weight), entries.emplace_back(b, a, -weight);
    }
    Laplacian laplacian(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
    laplacian.setFromTriplets(entries.begin(), entries.end());
    return laplacian;
}

Eigen::VectorXd vertex_areas(const Surface& triangles) {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(triangles.vertex_count());
    for (int f = 0; f < triangles.face_count(); ++f)
        for (const int v : triangles.triangles().col(f)) areas[v] += triangles.areas()[f] / 3;
    return areas;
}

/// Some of these vertices, each as far as can be from those before it.
std::vector<int> spread_over(const Positions& x, const std::vector<int>& vertices, std::size_t count) {
    std::vector<int> chosen;
    std::vector<double> distances(vertices.size(), std::numeric_limits<double>::infinity());
    std::size_t next = 0;
    while (chosen.size() < std::min(count, vertices.size())) {
        chosen.push_back(vertices[next]);
        for (std::size_t i = 0; i < vertices.size(); ++i)
            distances[i] = std::min(distances[i], (x.col(vertices[i]) - x.col(chosen.back())).squaredNorm());
        next = std::max_element(distances.begin(), distances.end()) - distances.begin();
    }
    return chosen;
}

}  // namespace

/// Cones at some of the sites, and what they leave of ∫ u², where the surface has the area 1.
class Cones::Placement {
public:
    explicit Placement(const Surface& triangles) {
        const std::vector<int> inner = inner_vertices(triangles);
        const std::vector<int> sites = spread_over(triangles.positions(), inner, k_cone_sites);
        m_indices.assign(sites.size(), 0);
        for (const int v : sites) m_points.push_back(triangles.positions().col(v));
        reckon(triangles, inner, sites);
    }

    std::vector<WishedSingular> placed_until(double most_stretch) {
        for (int count = 0; count < k_most_cones && m_left > most_stretch * most_stretch; ++count) {
            if (!place_one()) break;
            for (int moves = 0; moves < k_most_cone_moves && move_one(); ++moves) {
            }
        }
        std::vector<WishedSingular> cones;
        for (std::size_t i = 0; i < m_indices.size(); ++i)
            if (m_indices[i] != 0) cones.push_back({m_points[i], k_regular_valence - m_indices[i]});
        return cones;
    }

private:
    /// u without cones, and how each site would change it.
    void reckon(const Surface& triangles, const std::vector<int>& inner, const std::vector<int>& sites) {
        const std::vector<Eigen::Index> row = rows_of(inner, triangles.vertex_count());
        const Eigen::SimplicialLDLT<Laplacian> factor(laplacian_of(triangles, row, inner.size()));
        Eigen::MatrixXd sources =
            Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(inner.size()), static_cast<Eigen::Index>(sites.size()));
        for (std::size_t k = 0; k < sites.size(); ++k)
            sources(row[sites[k]], static_cast<Eigen::Index>(k)) = k_quarter_turn;
        const Eigen::MatrixXd changes = factor.solve(sources);
        const Eigen::VectorXd u = factor.solve(inner_defects(triangles)(inner).eval());
        const Eigen::VectorXd areas = vertex_areas(triangles)(inner) / triangles.area();
        const Eigen::MatrixXd weighted = areas.asDiagonal() * changes;
        m_products = weighted.transpose() * changes;
        m_with_u = weighted.transpose() * u;
        m_left = u.dot(areas.cwiseProduct(u));
    }

    /// What a cone more at a site changes of ∫ u².
    double change(Eigen::Index site, int index) const { return m_products(site, site) - 2 * index * m_with_u[site]; }

    void add(Eigen::Index site, int index) {
        m_left += change(site, index);
        m_with_u -= index * m_products.col(site);
        m_indices[site] += index;
    }

    bool place_one() {
        double least = -k_least_gain * m_left;
        std::optional<std::pair<Eigen::Index, int>> best;
        for (Eigen::Index site = 0; site < m_with_u.size(); ++site)
            for (const int index : {1, -1})
                if (m_indices[site] == 0 && change(site, index) < least)
                    least = change(site, index), best = {site, index};
        if (best) add(best->first, best->second);
        return best.has_value();
    }

    bool move_one() {
        double least = -k_least_move_gain * m_left;
        std::optional<std::pair<Eigen::Index, Eigen::Index>> best;
        for (Eigen::Index from = 0; from < m_with_u.size(); ++from) {
            const int index = m_indices[from];
            if (index == 0) continue;
            for (Eigen::Index to = 0; to < m_with_u.size(); ++to) {
                if (m_indices[to] != 0) continue;
                const double gain = change(from, -index) + change(to, index) - 2 * m_products(from, to);
                if (gain < least) least = gain, best = {from, to};
            }
        }
        if (!best) return false;
        const int index = m_indices[best->first];
        add(best->first, -index);
        add(best->second, index);
        return true;
    }

    std::vector<Eigen::Vector3d> m_points;  // of the sites
    std::vector<int> m_indices;             // likewise: of the cone there, in quarter turns; 0: there is none
    Eigen::MatrixXd m_products;             // ∫ of the products of what cones of index 1 take from u
    Eigen::VectorXd m_with_u;               // and of these and u
    double m_left = 0;                      // ∫ u²
};

Cones::Cones(const Surface& surface, const SurfaceTree& tree) {
    const EvenTriangles even = triangles_for_cones(surface, tree);
    const bool is_small = even.surface.vertex_count() <= k_most_cone_vertices;
    if (!is_small || has_closed_piece(even.surface) || inner_vertices(even.surface).empty()) return;
    m_bare = std::make_unique<const Placement>(even.surface);
}

Cones::~Cones() = default;

std::vector<WishedSingular> Cones::placed(double most_stretch) const {
    return m_bare ? Placement(*m_bare).placed_until(most_stretch) : std::vector<WishedSingular>();
}

}  // namespace chebnet
