#include "remesh/fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.h"
#include "edit/equalize.h"
#include "edit/fair_start.h"
#include "edit/resting_near.h"
#include "linear/graph_system.h"
#include "net/measures.h"
#include "net/topology.h"
#include "remesh/singular_wishes.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/length_projection.h"
#include "surface/height.h"

namespace chebnet {

namespace {

// Lengths are reckoned in L. To even out the edges vertices are held on the surface, so that the lengths are found by
// shear, which costs nothing but the straightness of net lines.
constexpr double k_hold = 100, k_stiffness = 1;
constexpr double k_border = 0.05;  // of the distance of borders, where that from the surface counts 1
constexpr int k_least_steps = 4, k_trial_steps = 10;
/// How edges are evened out.
struct Evening {
    double straight;  // weight of the second difference of a net line
    int most_steps;
    int last_steps;  // it ends when so many leave more than this part of the error of lengths
    double least_gain;
    double open;             // corners are kept open by so much more than the limit, in radians
    double limit_stiffness;  // beside edges that weigh 1
    double inertia;          // what a step costs: nothing else keeps vertices from drifting along the surface
};
// With rods as they are laid, what lengths still err by will be folded away, and corners have to be open at once.
constexpr Evening k_for_straight = {0.02, 70, 1, 0.99, 0, 1, 5e-4},
                  k_for_laid = {0.005, 45, 10, 0.99, 8 * std::numbers::pi / 180, 2, 1e-4};
// No vertex moves farther in one step.
constexpr double k_most_move = 0.4;
// Corners are kept open by more than the limit, in diagonals and in degrees, so that they are in the end.
constexpr double k_diagonal_margin = 0.02, k_limit_margin = 0.02;
// A vertex that is so near to a crease, in L, is on it: as the mean of its cells, half of one away on either side, it
// stands off from one at first, by the more the sharper that is.
constexpr double k_on_crease = 0.7;
// An edge runs along a crease if the angle between them is less: a cosine.
constexpr double k_along = 0.87;
// Of TipTerm on closed surfaces, beside bending that weighs 1: with less there are tips, with more the folds stand in
// rings about them.
constexpr double k_tip_weight = 2;
// Exact: no length errs by more than this part.
constexpr double k_exact_error = 1e-11;
// Of all openings together: a mesh that takes more hardly ever becomes a net.
constexpr int k_most_projections = 150, k_most_openings = 30;
// Towards rest near the surface: beyond so many steps little changes.
constexpr double k_pull_of_border = 0.3, k_pull_of_crease = 30;
// The same of a border that is to be where the surface's is, and of its corners: there the surface's border turns by
// more than this (a cosine), and the mesh has its own no farther off, in L.
constexpr double k_pull_along_border = 10, k_pull_of_corner = 30, k_corner = 0.7, k_near_corner = 1.5;
constexpr int k_steps_to_rest = 20;
// The part of the work that is done after each of its stages.
constexpr double k_even_at = 0.3, k_fair_at = 0.7, k_exact_at = 0.75;

double length_of(const Eigen::Vector3d& v) { return std::sqrt(v.x() * v.x() + v.y() * v.y() + v.z() * v.z()); }

class Fitter {
public:
    Fitter(const std::shared_ptr<const Guide>& guide, const Mesh& mesh, const FitOptions& options,
           const std::function<void(double)>& go_on)
        : m_guide(guide),
          m_surface(guide->surface()),
          m_tree(guide->tree()),
          m_go_on(go_on),
          m_net(mesh.positions, mesh.faces, RestLengths::own),
          m_topology(m_net),
          m_options(options),
          m_rods(rods_for(m_net, m_topology)),
          m_evening(m_rods == Rods::straight ? k_for_straight : k_for_laid),
          m_length(options.length > 0 ? options.length : m_net.mean_length()),
          m_positions(mesh.positions),
          m_guess(static_cast<std::size_t>(m_net.vertex_count()), -1) {
        find_diagonals();
        find_bends();
        find_border();
        find_corners();
        find_creases();
        m_system = std::make_unique<SingleBlockSystem>(m_net.vertex_count(), links());
    }

    Net run() {
        spread_edges(m_evening.most_steps);
        make_fair();
        return come_to_rest(exact());
    }

    double evened_error() {
        spread_edges(k_trial_steps);
        return length_error();
    }

private:
    /// Near a closed surface straight rods raise tips at singular vertices. Over a border they may leave it, and do so
    /// where else they would fold.
    static Rods rods_for(const Net& net, const Topology& topology) {
        for (int v = 0; v < net.vertex_count(); ++v)
            if (topology.is_boundary(v)) return Rods::straight;
        for (int v = 0; v < net.vertex_count(); ++v)
            if (topology.valence(v) != k_regular_valence) return Rods::as_laid;
        return Rods::straight;
    }

    double tip_weight() const { return m_rods == Rods::as_laid ? k_tip_weight : 0; }

    /// On the surface, until that hardly brings lengths nearer to each other any more.
    void spread_edges(int most_steps) {
        const int last = m_evening.last_steps;
        std::vector<double> errors;
        for (int k = 0; k < most_steps; ++k) {
            m_go_on(k_even_at * k / most_steps);
            if (m_options.length == 0) m_length = fitting_length();
            errors.push_back(length_error());
            if (k >= std::max(k_least_steps, last) && errors[k] > m_evening.least_gain * errors[k - last]) return;
            step();
        }
    }

    /// As a net of edges of length L near the surface that bends least, but for what its lengths still err.
    void make_fair() {
        bool fits = m_options.length == 0;
        if (fits && m_options.suits_creases)
            if (const std::optional<double> length = length_along_creases()) {
                m_length = *length;
                fits = false;
            }
        const Net net = with_length(m_length);
        m_evened = m_positions;
        find_pulls();
        FairStart start(net, m_topology, *m_guide, m_positions,
                        {{}, m_pulls, 1, m_options.smallest_angle, fits, m_rods, tip_weight()});
        double done = 0;
        do {
            m_go_on(k_even_at + (k_fair_at - k_even_at) * done);
            done += (1 - done) / 10;  // it does not know how many steps it takes
            m_positions = start.unit() * start.positions();
            if (!may_slide()) continue;
            find_pulls();
            start.set_pulls(in_unit(m_pulls, start.unit()));
        } while (start.step());
        m_positions = start.unit() * start.positions();
        m_length *= start.unit();
        if (may_slide()) find_pulls();
    }

    /// The mean of the edges along creases, if there are any.
    std::optional<double> length_along_creases() const {
        std::vector<bool> is_on_crease(static_cast<std::size_t>(m_net.vertex_count()), false);
        for (const int v : m_creases.vertices) is_on_crease[v] = true;
        double sum = 0;
        int count = 0;
        for (const Bar& edge : m_edges) {
            if (!is_on_crease[edge.a] || !is_on_crease[edge.b]) continue;
            const Eigen::Vector3d middle = (m_positions.col(edge.a) + m_positions.col(edge.b)) / 2;
            const double length = length_of(vector(edge));
            if (std::abs(vector(edge).dot(way_from(m_creases, middle).along)) < k_along * length) continue;
            sum += length;
            ++count;
        }
        if (count == 0) return std::nullopt;
        return m_length * sum / count;
    }

    bool may_slide() const { return !m_border.vertices.empty() || !m_creases.vertices.empty(); }

    /// To the points of border and creases that are next to vertices, so that these slide from step to step; of a
    /// border that is none of the net's lines, to where they were.
    void find_pulls() {
        m_pulls = m_options.pulls;
        const auto draw_along = [this](const Rail& rail, double weight) {
            for (const int v : rail.vertices)
                m_pulls.push_back({v, m_positions.col(v) - way_from(rail, m_positions.col(v)).away, weight});
        };
        draw_along(m_creases, k_pull_of_crease);
        draw_along(m_border, k_pull_along_border);
        for (const int v : m_steps.vertices) m_pulls.push_back({v, m_evened.col(v), k_pull_of_border});
    }

    static std::vector<Pull> in_unit(std::vector<Pull> pulls, double unit) {
        for (Pull& pull : pulls) pull.target /= unit;
        return pulls;
    }

    /// The mesh of the moment scaled to edges of a mean length, about its middle, so that it stays beside the surface.
    Net with_length(double length) const {
        const double mean = edge_ratios(m_net, m_positions).cwiseProduct(m_net.rest_lengths()).mean();
        const Eigen::Vector3d middle = m_positions.rowwise().mean();
        Positions scaled = (length / mean * (m_positions.colwise() - middle)).colwise() + middle;
        return Net(std::move(scaled), m_net.faces(), RestLengths::equal);
    }

    /// Root mean square, in L.
    double length_error() const {
        double sum = 0;
        for (const Bar& edge : m_edges) {
            const double error = length_of(vector(edge)) - 1;
            sum += error * error;
        }
        return std::sqrt(sum / m_net.edge_count());
    }

    int link(int a, int b) {
        return m_links.emplace(std::pair(std::min(a, b), std::max(a, b)), static_cast<int>(m_links.size()))
            .first->second;
    }

    struct Bar {
        int a, b, link;
    };
    /// x_a − 2 x_b + x_c and the links of its three pairs.
    struct Bend {
        int a, b, c, link_ab, link_bc, link_ac;
    };

    void find_diagonals() {
        for (int e = 0; e < m_net.edge_count(); ++e)
            m_edges.push_back(
                {m_net.edges()(0, e), m_net.edges()(1, e), link(m_net.edges()(0, e), m_net.edges()(1, e))});
        for (int f = 0; f < m_net.face_count(); ++f)
            for (int k = 0; k < 2; ++k) {
                const int a = m_net.faces()[f][k], b = m_net.faces()[f][k + 2];
                m_diagonals.push_back({a, b, link(a, b)});
            }
    }

    void find_border() {
        for (const std::vector<int>& loop : m_surface.boundary_loops())
            for (const int s : loop)
                (is_followed(s) ? m_border : m_steps)
                    .segments.push_back(
                        {m_surface.positions().col(m_surface.from(s)), m_surface.positions().col(m_surface.to(s))});
        for (int v = 0; v < m_net.vertex_count(); ++v) {
            if (!m_topology.is_boundary(v) || (m_border.segments.empty() && m_steps.segments.empty())) continue;
            const auto distance = [&](const Rail& rail) {
                return rail.segments.empty() ? std::numeric_limits<double>::infinity()
                                             : length_of(way_from(rail, m_positions.col(v)).away);
            };
            (distance(m_border) <= distance(m_steps) ? m_border : m_steps).vertices.push_back(v);
        }
    }

    bool is_followed(int side) const { return !m_options.border.empty() && m_options.border[side]; }

    void find_corners() {
        for (const std::vector<int>& loop : m_surface.boundary_loops())
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Eigen::Vector3d in = vector_of(loop[k]), out = vector_of(loop[(k + 1) % loop.size()]);
                if (is_followed(loop[k]) && in.dot(out) < k_corner * length_of(in) * length_of(out))
                    hold_corner(m_surface.positions().col(m_surface.to(loop[k])));
            }
    }

    Eigen::Vector3d vector_of(int side) const {
        return m_surface.positions().col(m_surface.to(side)) - m_surface.positions().col(m_surface.from(side));
    }

    void hold_corner(const Eigen::Vector3d& point) {
        constexpr int k_straight_valence = 3;
        int best = -1;
        double least = k_near_corner * m_length;
        for (const int v : m_border.vertices) {
            const double distance = length_of(m_positions.col(v) - point);
            if (m_topology.valence(v) != k_straight_valence && distance < least) best = v, least = distance;
        }
        if (best < 0) return;
        std::erase(m_border.vertices, best);
        m_options.pulls.push_back({best, point, k_pull_of_corner});
    }

    void find_creases() {
        m_creases.segments = m_options.creases;
        for (int v = 0; v < m_net.vertex_count() && !m_creases.segments.empty(); ++v)
            if (!is_held(v) && length_of(way_from(m_creases, m_positions.col(v)).away) < k_on_crease * m_length)
                m_creases.vertices.push_back(v);
    }

    /// To something else.
    bool is_held(int v) const {
        return m_topology.is_boundary(v) || std::any_of(m_options.pulls.begin(), m_options.pulls.end(),
                                                        [v](const Pull& pull) { return pull.vertex == v; });
    }

    void find_bends() {
        for (const std::vector<int>& line : m_topology.net_lines()) {
            for (std::size_t k = 0; k + 2 < line.size(); ++k) add_bend(line[k], line[k + 1], line[k + 2]);
            if (m_topology.is_closed(line) && line.size() > 3) add_bend(line[line.size() - 2], line.front(), line[1]);
        }
    }

    void add_bend(int a, int b, int c) {
        if (a != c) m_bends.push_back({a, b, c, link(a, b), link(b, c), link(a, c)});
    }

    Eigen::Matrix2Xi links() const {
        Eigen::Matrix2Xi result(2, static_cast<Eigen::Index>(m_links.size()));
        for (const auto& [pair, number] : m_links) result.col(number) << pair.first, pair.second;
        return result;
    }

    /// With edges of this length the quads, sheared as they are, have the area of the surface.
    double fitting_length() const {
        double area = 0;
        for (int f = 0; f < m_net.face_count(); ++f) {
            const std::span<const int> face = m_net.faces()[f];
            for (std::size_t k = 0; k < 4; ++k) {
                const Eigen::Vector3d a = m_positions.col(face[(k + 1) % 4]) - m_positions.col(face[k]);
                const Eigen::Vector3d b = m_positions.col(face[(k + 3) % 4]) - m_positions.col(face[k]);
                area += length_of(a.cross(b)) / std::max(length_of(a) * length_of(b), 1e-300) / 4;
            }
        }
        return std::sqrt(m_surface.area() / std::max(area, 1.0));
    }

    /// A Gauss–Newton step of Σ hold · (distance to the surface)² + straightness + stiffness · (lengths, sharp
    /// corners).
    void step() {
        m_system->set_zero();
        m_force.setZero(3, m_positions.cols());
        draw_to_surface();
        for (const Rail& rail : {m_border, m_steps, m_creases}) draw_to(rail);
        draw_to_points();
        for (const Bend& bend : m_bends) straighten(bend);
        for (const Bar& edge : m_edges) pull(edge, 1, 1);
        const double open = m_options.smallest_angle + m_evening.open;
        const double shortest = 2 * std::sin(open / 2) + k_diagonal_margin;
        for (const Bar& diagonal : m_diagonals)
            if (length_of(vector(diagonal)) < shortest) pull(diagonal, shortest, m_evening.limit_stiffness);
        if (!m_system->factorize()) return;
        const Eigen::Matrix3Xd moves = m_system->solve(m_force);
        for (int v = 0; v < m_positions.cols(); ++v) {
            const double way = length_of(moves.col(v));
            m_positions.col(v) += m_length * std::min(1.0, k_most_move / std::max(way, 1e-300)) * moves.col(v);
        }
    }

    Eigen::Vector3d vector(const Bar& bar) const {
        return (m_positions.col(bar.a) - m_positions.col(bar.b)) / m_length;
    }

    void draw_to_surface() {
        for (int v = 0; v < m_positions.cols(); ++v) {
            if (m_guess[v] < 0) m_guess[v] = m_tree.nearest(m_positions.col(v)).at.face;
            const Height height = height_of(m_surface, m_tree, m_positions.col(v), m_guess[v]);
            m_guess[v] = height.at.face;
            const Eigen::Vector3d normal = height.normal;
            m_system->add_at_node(
                v, k_hold * normal * normal.transpose() + m_evening.inertia * Eigen::Matrix3d::Identity());
            m_force.col(v) -= k_hold * height.height / m_length * normal;
        }
    }

    /// Lines on the surface, and vertices of the net that are drawn to them and may slide along.
    struct Rail {
        std::vector<Segment> segments;
        std::vector<int> vertices;
    };
    struct Way {
        Eigen::Vector3d away = Eigen::Vector3d::Zero(), along = Eigen::Vector3d::Zero();  // from, and of, the line
    };

    Way way_from(const Rail& rail, const Eigen::Vector3d& x) const {
        double least = std::numeric_limits<double>::infinity();
        Way way;
        for (const auto& [from, to] : rail.segments) {
            const Eigen::Vector3d side = to - from;
            const double fraction = std::clamp((x - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
            const Eigen::Vector3d difference = x - from - fraction * side;
            if (difference.squaredNorm() >= least) continue;
            least = difference.squaredNorm();
            way = {difference, side};
        }
        way.along /= length_of(way.along);
        return way;
    }

    void draw_to(const Rail& rail) {
        for (const int v : rail.vertices) {
            const auto [away, along] = way_from(rail, m_positions.col(v));
            const double weight = k_border * k_hold;
            m_system->add_at_node(v, weight * (Eigen::Matrix3d::Identity() - along * along.transpose()));
            m_force.col(v) -= weight / m_length * (away - away.dot(along) * along);
        }
    }

    void draw_to_points() {
        for (const Pull& pull : m_options.pulls) {
            m_system->add_at_node(pull.vertex, pull.weight * Eigen::Matrix3d::Identity());
            m_force.col(pull.vertex) -= pull.weight / m_length * (m_positions.col(pull.vertex) - pull.target);
        }
    }

    void straighten(const Bend& bend) {
        const double straight = m_evening.straight;
        const Eigen::Matrix3d form = straight * Eigen::Matrix3d::Identity();
        m_system->add_at_link(bend.link_ab, 2 * form);
        m_system->add_at_link(bend.link_bc, 2 * form);
        m_system->add_at_link(bend.link_ac, -form);
        const Eigen::Vector3d difference =
            straight / m_length * (m_positions.col(bend.a) - 2 * m_positions.col(bend.b) + m_positions.col(bend.c));
        m_force.col(bend.a) -= difference;
        m_force.col(bend.b) += 2 * difference;
        m_force.col(bend.c) -= difference;
    }

    /// A spring between two vertices, as stiff across as it is stretched.
    void pull(const Bar& bar, double rest, double weight) {
        const Eigen::Vector3d d = vector(bar);
        const double length = std::max(length_of(d), 1e-3);
        const Eigen::Vector3d along = d / length;
        const double across = std::max(0.0, 1 - rest / length);
        const Eigen::Matrix3d form = (1 - across) * (along * along.transpose()) + across * Eigen::Matrix3d::Identity();
        m_system->add_at_link(bar.link, weight * k_stiffness * form);
        const Eigen::Vector3d force = weight * k_stiffness * (length - rest) * along;
        m_force.col(bar.a) -= force;
        m_force.col(bar.b) += force;
    }

    Net exact() {
        const Net net = with_length(m_length);
        Positions x = net.rest_positions();
        CornerLimit limit(net, m_options.smallest_angle + k_limit_margin * std::numbers::pi / 180);
        limit.watch(x);
        auto lengths = projection(net, limit);
        int left = k_most_projections;
        for (int opening = 0; opening < k_most_openings && left > 0; ++opening) {
            for (; left > 0; --left) {
                if (!lengths->project(x)) break;
                lengths->system().assemble(x);
                if (lengths->system().errors().lpNorm<Eigen::Infinity>() < k_exact_error) break;
            }
            if (limit.needs_more_rows(x)) {
                limit.watch(x);
                lengths = projection(net, limit);
            }
            if (limit.hold_short_ones(x) == 0) break;
            limit.apply(lengths->system());
        }
        Net result(std::move(x), net.faces(), RestLengths::equal);
        if (!(max_deviation(result, result.rest_positions()) < k_equal_deviation))
            throw Error(ErrorCode::bad_option, "no net with edges of one length was found near the surface");
        return result;
    }

    /// Of all nets of this length the one that bends least near the surface, or what comes close to it.
    Net come_to_rest(const Net& net) {
        Editor editor = resting_near(net, m_guide, m_options.smallest_angle, m_rods, tip_weight());
        std::vector<Handle> handles;
        for (const Pull& pull : m_pulls) handles.push_back({pull.vertex, pull.target, pull.weight});
        editor.set_handles(handles);
        for (int k = 0; k < k_steps_to_rest; ++k) {
            m_go_on(k_exact_at + (1 - k_exact_at) * k / k_steps_to_rest);
            if (editor.solve({.iterations = 1}).status != Status::running) break;
        }
        const Positions& x = editor.positions();
        return max_deviation(net, x) < k_equal_deviation ? Net(x, net.faces(), RestLengths::equal) : net;
    }

    std::unique_ptr<LengthProjection> projection(const Net& net, const CornerLimit& limit) const {
        auto lengths = std::make_unique<LengthProjection>(net, m_topology, limit.watched());
        lengths->set_free(std::vector<bool>(static_cast<std::size_t>(net.vertex_count()), true));
        limit.apply(lengths->system());
        return lengths;
    }

    std::shared_ptr<const Guide> m_guide;
    const Surface& m_surface;
    const SurfaceTree& m_tree;
    const std::function<void(double)>& m_go_on;
    Net m_net;  // the mesh
    Topology m_topology;
    FitOptions m_options;
    Rods m_rods;
    Evening m_evening;
    double m_length;
    Positions m_positions, m_evened;
    std::vector<int> m_guess;
    std::vector<Pull> m_pulls;          // those asked for, and the border to where it is once edges are even
    Rail m_border, m_steps, m_creases;  // where the border is one of the net's lines, and where it is not
    std::map<std::pair<int, int>, int> m_links;
    std::vector<Bar> m_edges, m_diagonals;
    std::vector<Bend> m_bends;
    std::unique_ptr<SingleBlockSystem> m_system;
    Eigen::Matrix3Xd m_force;
};

}  // namespace

Net fit_net(const std::shared_ptr<const Guide>& guide, const Mesh& mesh, const FitOptions& options,
            const std::function<void(double)>& go_on) {
    return Fitter(guide, mesh, options, go_on).run();
}

double evened_error(const std::shared_ptr<const Guide>& guide, const Mesh& mesh, double smallest_angle) {
    const std::function<void(double)> go_on = [](double) {};
    FitOptions options;
    options.smallest_angle = smallest_angle;
    return Fitter(guide, mesh, options, go_on).evened_error();
}

}  // namespace chebnet
