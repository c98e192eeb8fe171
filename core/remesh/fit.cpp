#include "remesh/fit.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "edit/fair_start.h"
#include "edit/resting_near.h"
#include "net/measures.h"
#include "net/topology.h"
#include "remesh/edge_evening.h"
#include "remesh/rails.h"
#include "remesh/vector_length.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/length_projection.h"

namespace chebnet {

namespace {

// Corners are kept open by more than the limit, in degrees, so that they are in the end.
constexpr double k_limit_margin = 0.02;
// An edge runs along a crease if the angle between them is less: a cosine.
constexpr double k_along = 0.87;
// Of TipTerm, beside bending that weighs 1: with less there are tips, with more the folds stand in rings about them.
constexpr double k_tip_weight = 2;
// Over a border, with fewer faces for each singular vertex: what is a tip is all that the net has of a bump, and
// without it the net draws away from the surface.
constexpr double k_fewest_about_tip = 25;
// Exact: no length errs by more than this part.
constexpr double k_exact_error = 1e-11;
// Of all openings together: a mesh that takes more hardly ever becomes a net.
constexpr int k_most_projections = 150, k_most_openings = 30;
// Towards rest near the surface: of a border that is to be where the surface's is, and of one that is not.
constexpr double k_pull_along_border = 10, k_pull_of_border = 0.3, k_pull_of_crease = 30;
// Beyond so many steps little changes.
constexpr int k_steps_to_rest = 20;
// The part of the work that is done after each of its stages.
constexpr double k_even_at = 0.3, k_fair_at = 0.7, k_exact_at = 0.75;

class Fitter {
public:
    Fitter(const std::shared_ptr<const Guide>& guide, const Mesh& mesh, const FitOptions& options,
           const std::function<void(double)>& go_on)
        : m_guide(guide),
          m_go_on(go_on),
          m_mesh(mesh.positions, mesh.faces, RestLengths::own),
          m_topology(m_mesh),
          m_options(options),
          m_rods(rods_for(m_mesh, m_topology)),
          m_length(options.length > 0 ? options.length : m_mesh.mean_length()),
          m_rails(rails_of(guide->surface(), m_mesh, m_topology, m_options, m_length)) {}

    Net run() {
        spread_edges();
        make_fair();
        return come_to_rest(exact());
    }

    double evened_error() const {
        EdgeEvening evening(*m_guide, m_mesh, m_topology, m_options, m_rails, m_rods);
        evening.try_out(m_go_on);
        return evening.length_error();
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

    double tip_weight() const {
        if (m_rods == Rods::as_laid) return k_tip_weight;
        int singular = 0;
        for (int v = 0; v < m_mesh.vertex_count(); ++v) singular += m_topology.is_singular(v);
        return singular > 0 && m_mesh.face_count() >= k_fewest_about_tip * singular ? k_tip_weight : 0;
    }

    /// On the surface, as far as that goes.
    void spread_edges() {
        EdgeEvening evening(*m_guide, m_mesh, m_topology, m_options, m_rails, m_rods);
        evening.run([this](double done) { m_go_on(k_even_at * done); });
        m_positions = m_evened = evening.positions();
        m_length = evening.length();
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
        find_pulls();
        FairStart start(net, m_topology, *m_guide, m_positions,
                        {{},
                         m_pulls,
                         1,
                         m_options.smallest_angle,
                         fits ? FairStart::Size::by_lengths : FairStart::Size::kept,
                         m_rods,
                         tip_weight()});
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
        std::vector<bool> is_on_crease(static_cast<std::size_t>(m_mesh.vertex_count()), false);
        for (const int v : m_rails.creases.vertices) is_on_crease[v] = true;
        double sum = 0;
        int count = 0;
        for (const auto& edge : m_mesh.edges().colwise()) {
            if (!is_on_crease[edge[0]] || !is_on_crease[edge[1]]) continue;
            const Eigen::Vector3d a = m_positions.col(edge[0]), b = m_positions.col(edge[1]), middle = (a + b) / 2;
            const Eigen::Vector3d vector = (a - b) / m_length;
            const double length = length_of(vector);
            if (std::abs(vector.dot(way_from(m_rails.creases, middle).along)) < k_along * length) continue;
            sum += length;
            ++count;
        }
        if (count == 0) return std::nullopt;
        return m_length * sum / count;
    }

    bool may_slide() const { return !m_rails.border.vertices.empty() || !m_rails.creases.vertices.empty(); }

    /// To the points of border and creases that are next to vertices, so that these slide from step to step; of a
    /// border that is none of the net's lines, to where they were.
    void find_pulls() {
        m_pulls = m_options.pulls;
        m_pulls.insert(m_pulls.end(), m_rails.corners.begin(), m_rails.corners.end());
        const auto draw_along = [this](const Rail& rail, double weight) {
            for (const int v : rail.vertices)
                m_pulls.push_back({v, m_positions.col(v) - way_from(rail, m_positions.col(v)).away, weight});
        };
        draw_along(m_rails.creases, k_pull_of_crease);
        draw_along(m_rails.border, k_pull_along_border);
        for (const int v : m_rails.steps.vertices) m_pulls.push_back({v, m_evened.col(v), k_pull_of_border});
    }

    static std::vector<Pull> in_unit(std::vector<Pull> pulls, double unit) {
        for (Pull& pull : pulls) pull.target /= unit;
        return pulls;
    }

    /// The mesh of the moment scaled to edges of a mean length, about its middle, so that it stays beside the surface.
    Net with_length(double length) const {
        const double mean = edge_ratios(m_mesh, m_positions).cwiseProduct(m_mesh.rest_lengths()).mean();
        const Eigen::Vector3d middle = m_positions.rowwise().mean();
        Positions scaled = (length / mean * (m_positions.colwise() - middle)).colwise() + middle;
        return Net(std::move(scaled), m_mesh.faces(), RestLengths::equal);
    }

    Net exact() {
        const Net net = with_length(m_length);
        Net result(projected(net, net.rest_positions()), net.faces(), RestLengths::equal);
        if (!(max_deviation(result, result.rest_positions()) < k_equal_deviation))
            throw Error(ErrorCode::bad_option, "no net with edges of one length was found near the surface");
        return result;
    }

    /// Positions with lengths and corners as they have to be, as far as that many projections lead there.
    Positions projected(const Net& net, Positions x) const {
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
        return x;
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
        if (!(max_deviation(net, editor.positions()) < k_equal_deviation)) return net;
        // Where it has not come to rest in so many steps lengths still err by a little.
        Net rested(projected(net, editor.positions()), net.faces(), RestLengths::equal);
        return max_deviation(rested, rested.rest_positions()) < k_equal_deviation ? rested : net;
    }

    std::unique_ptr<LengthProjection> projection(const Net& net, const CornerLimit& limit) const {
        auto lengths = std::make_unique<LengthProjection>(net, m_topology, limit.watched());
        lengths->set_free(std::vector<bool>(static_cast<std::size_t>(net.vertex_count()), true));
        limit.apply(lengths->system());
        return lengths;
    }

    std::shared_ptr<const Guide> m_guide;
    const std::function<void(double)>& m_go_on;
    Net m_mesh;
    Topology m_topology;
    const FitOptions& m_options;
    Rods m_rods;
    double m_length;
    Rails m_rails;
    Positions m_positions, m_evened;
    std::vector<Pull> m_pulls;  // those asked for, and the border to where it is once edges are even
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
