#include "shapes/relaxation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "linear/graph_system.h"
#include "net/topology.h"
#include "solve/parts/length_projection.h"

namespace chebnet {

namespace {

constexpr int k_first_iterations = 20;  // without multipliers: from afar these would overshoot
// ρ of the method, where the stiffness of rods is 1. With less, rods buckle edges before the lengths are right; with
// more, it takes longer until they are straight.
constexpr double k_stiffness = 20;
constexpr double k_diagonal_stiffness = 0.3;  // relative to that of edges
// Keeps the system definite in single precision; only slows a motion of the whole.
constexpr double k_shift = 1e-3;

/// The sum in this order: Eigen's depends on whether it is vectorised.
double length(const Eigen::Vector3d& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z()); }

/// Two vertices whose distance is to stay within a range.
struct Bar {
    int a, b;
    double weight, shortest, longest;
    bool is_strict = true;                                 // else drawn towards the range, as far as the rest gives way
    Eigen::Vector3d multiplier = Eigen::Vector3d::Zero();  // divided by ρ
    Eigen::Vector3d vector = Eigen::Vector3d::Zero();      // chosen for x_a − x_b, less the multiplier
};

/// What corners may be, by their cosines.
struct CornerRange {
    double sharpest, bluntest;
};
constexpr CornerRange k_corners{0.5, -0.5};

// With rounded cones: corners at inner vertices of these valences; so much more of the sum of all directions there;
// stiffer diagonals; and, as bars of this stiffness, how sharply rods turn, by the cosine, which the thinnest limbs
// cannot keep.
struct TipCorners {
    int valence;
    CornerRange range;
};
constexpr TipCorners k_tip_corners[] = {{3, {-0.438, -0.574}}, {5, {0.5, 0}}, {6, {0.5, 0.174}}};
constexpr double k_tip_weight = 3, k_rounded_diagonal_stiffness = 0.7;
constexpr double k_turn_cosine = 0.809, k_turn_stiffness = 1.5;

/// κ at a vertex: Σ_i (x_i − x_centre) / length_i.
struct Bend {
    struct End {
        int vertex;
        double per_length;
    };
    int centre;
    std::vector<End> ends;
    double area, per_length;  // the sum of those of the ends
};

/// A link of the system with its entry.
struct Entry {
    int a, b;
    double weight;
};

class Gridshell {
public:
    Gridshell(const Mesh& blocks, const Loads& loads, double rounding)
        : m_net(blocks.positions, blocks.faces, RestLengths::own),
          m_topology(m_net),
          m_loads(loads),
          m_rounding(rounding),
          m_area(static_cast<std::size_t>(m_net.vertex_count()), 0.0) {
        measure_faces();
        add_bends();
        make_system();
    }

    void relax(int iterations, Positions& x) {
        Eigen::Matrix3Xd force(3, m_net.vertex_count());
        for (int k = 0; k < iterations; ++k) {
            for (Bar& bar : m_bars) choose_vector(bar, x, k > k_first_iterations && bar.is_strict);
            collect_forces(x, force);
            m_system->solve_in_place(force);
            x += force;
        }
    }

private:
    double rest_length(int a, int b) const {
        return (m_net.rest_positions().col(a) - m_net.rest_positions().col(b)).cwiseAbs().maxCoeff();
    }

    /// Areas about vertices, and the bars: edges and diagonals.
    void measure_faces() {
        std::vector<double> width(static_cast<std::size_t>(m_net.edge_count()), 0.0);
        for (int f = 0; f < m_net.face_count(); ++f) {
            const auto q = m_net.faces()[f];
            const double u = rest_length(q[0], q[1]), v = rest_length(q[1], q[2]);
            for (int k = 0; k < 4; ++k) {
                m_area[q[k]] += u * v / 4;
                width[m_topology.edge_between(q[k], q[(k + 1) % 4])] += (k % 2 == 0 ? v : u) / 2;
            }
            for (int k = 0; k < 2; ++k) {
                const auto [sharpest, bluntest] = corners_beside(q[k + 1], q[(k + 3) % 4]);
                m_bars.push_back({q[k], q[k + 2],
                                  k_stiffness * rounded(k_diagonal_stiffness, k_rounded_diagonal_stiffness),
                                  side_opposite(u, v, sharpest), side_opposite(u, v, bluntest)});
            }
        }
        for (int e = 0; e < m_net.edge_count(); ++e) {
            const double rest = m_net.rest_lengths()[e];
            m_bars.push_back({m_net.edges()(0, e), m_net.edges()(1, e), k_stiffness * width[e] / rest, rest, rest});
        }
    }

    /// A number that is one thing with sharp cones and another with rounded ones.
    double rounded(double sharp, double round) const { return sharp + m_rounding * (round - sharp); }

    /// For the two corners of a quad beside one of its diagonals, which are as blunt as each other.
    CornerRange corners_beside(int a, int b) const {
        for (const int v : {a, b})
            for (const auto& [valence, range] : k_tip_corners)
                if (!m_topology.is_boundary(v) && m_topology.valence(v) == valence)
                    return {rounded(k_corners.sharpest, range.sharpest), rounded(k_corners.bluntest, range.bluntest)};
        return k_corners;
    }

    /// Of the triangle with sides u and v and this cosine between them.
    static double side_opposite(double u, double v, double cosine) {
        return std::sqrt(u * u + v * v - 2 * u * v * cosine);
    }

    void add_bends() {
        for (const std::vector<int>& line : m_topology.net_lines()) {
            for (std::size_t i = 1; i + 1 < line.size(); ++i) add_turn(line[i - 1], line[i], line[i + 1]);
            if (m_topology.is_closed(line)) add_turn(line[line.size() - 2], line[0], line[1]);
        }
        for (int v = 0; v < m_net.vertex_count(); ++v)
            if (!m_topology.is_boundary(v) && ends_lines(v))
                add_bend(v, m_topology.neighbours(v), rounded(1, k_tip_weight));
    }

    bool ends_lines(int v) const { return m_topology.valence(v) != (m_topology.is_boundary(v) ? 3 : 4); }

    /// Of a net line.
    void add_turn(int before, int centre, int after) {
        add_bend(centre, std::array{before, after}, 1);
        if (m_rounding == 0) return;
        const double u = rest_length(before, centre), v = rest_length(centre, after);
        m_bars.push_back({before, after, k_stiffness * k_turn_stiffness,
                          side_opposite(u, v, -rounded(-1, k_turn_cosine)), u + v, false});
    }

    void add_bend(int centre, std::span<const int> ends, double weight) {
        Bend bend{centre, {}, weight * m_area[centre], 0};
        for (const int end : ends) {
            bend.ends.push_back({end, 1 / rest_length(centre, end)});
            bend.per_length += bend.ends.back().per_length;
        }
        m_bends.push_back(std::move(bend));
    }

    /// Bars as links of their weight; a bend Σ c_i x_i with Σ c_i = 0 as a link of −A c_i c_j between any two.
    void make_system() {
        std::vector<Entry> entries;
        const auto add = [&entries](int a, int b, double weight) {
            entries.push_back({std::min(a, b), std::max(a, b), weight});
        };
        for (const Bar& bar : m_bars) add(bar.a, bar.b, bar.weight);
        for (const Bend& bend : m_bends)
            for (auto i = bend.ends.begin(); i != bend.ends.end(); ++i) {
                add(bend.centre, i->vertex, bend.area * bend.per_length * i->per_length);
                for (auto j = bend.ends.begin(); j != i; ++j)
                    add(i->vertex, j->vertex, -bend.area * i->per_length * j->per_length);
            }
        // Stable, so that the weights of a link are added in the same order everywhere.
        const auto ends = [](const Entry& entry) { return std::pair(entry.a, entry.b); };
        std::stable_sort(entries.begin(), entries.end(),
                         [&](const Entry& one, const Entry& other) { return ends(one) < ends(other); });
        std::vector<Entry> merged;
        for (const Entry& entry : entries)
            if (!merged.empty() && ends(merged.back()) == ends(entry))
                merged.back().weight += entry.weight;
            else
                merged.push_back(entry);

        Eigen::Matrix2Xi links(2, static_cast<Eigen::Index>(merged.size()));
        for (int k = 0; k < links.cols(); ++k) links.col(k) << merged[k].a, merged[k].b;
        m_system.emplace(m_net.vertex_count(), links);
        for (int k = 0; k < links.cols(); ++k) m_system->add_at_link(k, LaplacianSystem::Block(merged[k].weight));
        for (int v = 0; v < m_net.vertex_count(); ++v)
            m_system->add_at_node(v, LaplacianSystem::Block(k_shift + m_loads.hold * m_area[v]));
        m_system->factorize();  // cannot fail: a sum of squares, shifted
    }

    void collect_forces(const Positions& x, Eigen::Matrix3Xd& force) const {
        for (int v = 0; v < m_net.vertex_count(); ++v)
            force.col(v) = m_loads.hold * m_area[v] * (m_net.rest_positions().col(v) - x.col(v));
        for (int f = 0; f < m_net.face_count(); ++f) {
            const auto q = m_net.faces()[f];
            const Eigen::Vector3d u = x.col(q[2]) - x.col(q[0]), v = x.col(q[3]) - x.col(q[1]);
            for (const int corner : q) force.col(corner) += m_loads.pressure / 8 * u.cross(v);
        }
        for (const Bar& bar : m_bars) {
            const Eigen::Vector3d pull = bar.weight * (bar.vector - (x.col(bar.a) - x.col(bar.b)));
            force.col(bar.a) += pull;
            force.col(bar.b) -= pull;
        }
        for (const Bend& bend : m_bends) {
            Eigen::Vector3d curvature = -bend.per_length * x.col(bend.centre);
            for (const Bend::End& end : bend.ends) curvature += end.per_length * x.col(end.vertex);
            curvature *= bend.area;
            force.col(bend.centre) += bend.per_length * curvature;
            for (const Bend::End& end : bend.ends) force.col(end.vertex) -= end.per_length * curvature;
        }
    }

    static void choose_vector(Bar& bar, const Positions& x, bool with_multiplier) {
        const Eigen::Vector3d shifted = x.col(bar.a) - x.col(bar.b) + bar.multiplier;
        const double now = length(shifted);
        const Eigen::Vector3d chosen = std::clamp(now, bar.shortest, bar.longest) / now * shifted;
        if (with_multiplier) bar.multiplier = shifted - chosen;
        bar.vector = chosen - bar.multiplier;
    }

    const Net m_net;
    const Topology m_topology;
    const Loads m_loads;
    const double m_rounding;
    std::vector<double> m_area;
    std::vector<Bar> m_bars;
    std::vector<Bend> m_bends;
    std::optional<LaplacianSystem> m_system;
};

}  // namespace

void relax(const Mesh& blocks, const Loads& loads, double rounding, int iterations, Positions& positions) {
    Gridshell(blocks, loads, rounding).relax(iterations, positions);
}

void restore_lengths(const Mesh& blocks, Positions& positions) {
    constexpr int most_projections = 40;
    constexpr double precision = 1e-14;  // of an edge, root mean square
    const Net net(blocks.positions, blocks.faces, RestLengths::own);
    const Topology topology(net);
    LengthProjection projection(net, topology);
    projection.set_free(std::vector<bool>(static_cast<std::size_t>(net.vertex_count()), true));
    const double enough = precision * precision * net.edge_count();
    for (int k = 0; k < most_projections; ++k)
        if (!projection.project(positions) || projection.squared_error() < enough) return;
}

}  // namespace chebnet
