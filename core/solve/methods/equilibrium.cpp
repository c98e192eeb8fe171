#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "base/stopwatch.h"
#include "linear/dense_kernels.h"
#include "net/measures.h"
#include "solve/methods/methods.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/length_projection.h"
#include "solve/parts/nearest_rotation.h"
#include "solve/parts/stopping.h"
#include "solve/parts/tangent_newton.h"
#include "solve/terms/bending_term.h"
#include "solve/terms/closeness_term.h"
#include "solve/terms/load_terms.h"
#include "solve/terms/shear_term.h"

namespace chebnet {

namespace {

// Where handles move by more edge lengths than one step takes, the net follows in several: in few up to what a hand
// does in a frame or two, and beyond, where nobody drags, with as much care as a slow hand takes, so that it ends where
// that would.
constexpr double k_one_step = 1, k_fast_drag = 8, k_fast_step = 0.25, k_careful_step = 0.125;
constexpr double k_least_stride = 1.0 / 100;  // of the way: far jumps end, too
// Of a step: where so little is left of it, the net is about to be taut.
constexpr double k_least_progress = 0.1;
// A step repeats so much of the one before it, and no more than so many times that. Less than all, so that what was
// rough in one does not grow from step to step.
constexpr double k_repeated = 0.95, k_most_repeated = 2;
// Handles that are as near to their places of rest, in edge lengths, in the same arrangement, are at home: there the
// rest shape is the answer.
constexpr double k_home = 1e-6;
// What the last net counts for, beside one handle, where handles alone do not say how the rest shape is turned.
constexpr double k_free_weight = 1e-10;
// Handles that are nearer to one line than this leave a turn about it free.
constexpr double k_determined = 1e-6;
// Tries of such a step, at once or in shorter ones.
constexpr int k_most_trials = 8;
// Nets are projected until no length errs by more than this part, dL < 1e-10, or by less if the threshold asks for it.
constexpr double k_exact_error = 1e-5;
constexpr int k_most_projections = 15, k_patience = 4;  // in all, and without coming closer
// Iterations within a Newton step: few while handles may still be moving, more as it settles. With fewer than this the
// steps of a drag are so rough that what the next one repeats of them grows.
constexpr double k_inner_tolerance = 0.05;
constexpr int k_least_inner_iterations = 8, k_most_inner_iterations = 60;
// So many steps of a solve do without a factor of the Hessian: as many as a frame of a drag has time for. Later steps
// have one, which is renewed when it has become so old that more iterations are needed than this.
constexpr int k_cheap_steps = 2, k_old_factor_iterations = 12, k_most_iterations_with_factor = 100;
// No vertex moves farther in one step, in edge lengths.
constexpr double k_most_move = 1;
constexpr double k_sufficient_decrease = 1e-4;  // of Armijo's rule
constexpr int k_most_halvings = 8;
// The limit aims a little higher than it has to be, so that it is met in spite of its tolerance.
constexpr double k_limit_margin = 0.02;  // degrees
// Shear is reckoned from no corner sharper than this, even without a limit.
constexpr double k_least_open_angle = 15;  // degrees
// A guide that holds weighs so many times as much as one that draws.
constexpr double k_hold = 100;
// How often corners may join those that are held, or leave them, in one step.
constexpr int k_most_rounds = 4, k_most_openings = 6, k_most_joins = 6;
// After so many the rest shape is taken as far as it has come.
constexpr int k_most_steps_of_opening = 100;
// At rest no vertex moves farther in a Newton step, in edge lengths.
constexpr double k_still = 1e-3;
// Less force than this moves nothing: a net that comes at rest need not be tried.
constexpr double k_no_force = 1e-9;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Of energy and limit.
bool ask_for_the_same(const Options& a, const Options& b) {
    return a.shear_limit == b.shear_limit && a.bending_weight == b.bending_weight && a.shear_weight == b.shear_weight &&
           a.straight_rods == b.straight_rods && a.gravity == b.gravity && a.guide_mode == b.guide_mode &&
           a.guide_weight == b.guide_weight;
}

struct RigidMotion {
    Eigen::Vector3d from_centre, to_centre;
    Eigen::Quaterniond rotation;
    bool is_determined;  // by what it was fitted to: no turn about a point or a line would do as well

    Eigen::Vector3d of(const Eigen::Vector3d& x) const { return to_centre + rotation * (x - from_centre); }
};

/// The one with the least Σ weight · ‖motion(from) − to‖² (Kabsch 1976).
RigidMotion fit(const Positions& from, const Positions& to, const Eigen::VectorXd& weight) {
    RigidMotion motion{{0, 0, 0}, {0, 0, 0}, Eigen::Quaterniond::Identity(), false};
    for (Eigen::Index v = 0; v < to.cols(); ++v) {
        motion.from_centre += weight[v] * from.col(v);
        motion.to_centre += weight[v] * to.col(v);
    }
    motion.from_centre /= weight.sum();
    motion.to_centre /= weight.sum();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (Eigen::Index v = 0; v < to.cols(); ++v)
        covariance += weight[v] * (to.col(v) - motion.to_centre) * (from.col(v) - motion.from_centre).transpose();
    motion.rotation = nearest_rotation(covariance, Eigen::Quaterniond::Identity());
    // The product of the two largest singular values against the square of the largest.
    Eigen::Matrix3d minors;
    for (int k = 0; k < 3; ++k) minors.col(k) = covariance.col((k + 1) % 3).cross(covariance.col((k + 2) % 3));
    motion.is_determined = minors.norm() > k_determined * covariance.squaredNorm();
    return motion;
}

class Equilibrium : public Method {
public:
    /// What costs no energy: the net's rest shape, or that once it is a net within the limit.
    enum class RestShape { as_it_is, opened };

    explicit Equilibrium(RestShape rest_shape) : m_opens(rest_shape == RestShape::opened) {}
    void prepare(const Problem& problem) override;
    bool knows_pulls() const override { return true; }
    bool goes_from_net_to_net() const override { return true; }
    bool knows_slides() const override { return true; }
    Status start(const Problem& problem, Positions& positions, const Options& options) override;
    Status iterate(Positions& positions, TraceRow& row) override;
    std::span<const double> edge_forces() const override;

private:
    enum Stage { open = 0, net = 1, follow = 2, rest = 3 };

    Method& projection();
    Problem problem() const { return {*m_net, *m_topology, m_held, m_pulls, m_reachable}; }
    void take_pulls(std::span<const Pull> pulls);
    bool take_guide(const Problem& problem);
    CornerLimit limit() const;
    void forget_rest_shape();
    bool begin_opening();
    Status open_rest_shape(Positions& positions, TraceRow& row);
    Status begin(Positions& positions, bool same_energy);
    void choose_energy();
    std::unique_ptr<Term> closeness() const;
    double evaluate(const Positions& x, Eigen::Matrix3Xd& gradient);
    bool prepare_energy(const Positions& positions, bool same_energy);
    Stage first_stage(const Positions& positions);
    Eigen::Vector3d held_part(int vertex, const Eigen::Vector3d& move) const;
    Eigen::Vector3d free_part(int vertex, const Positions& positions) const;
    void take_held(const Positions& from, int vertex, Positions& to) const;
    void take_free(const Positions& from, int vertex, Positions& to) const;
    bool was_left(const Positions& before, const Positions& positions) const;
    void begin_walk(const Positions& positions);
    Status find_net(Positions& positions, TraceRow& row);
    Status begin_rest(Status of_projection, Positions& positions);
    Status follow_handles(Positions& positions, TraceRow& row);
    void walk(double part, Positions& x);
    bool move_handles(double part, Positions& x);
    void predict(Eigen::Matrix3Xd& moves);
    Status find_another_net(Positions& positions);
    bool begin_at_rest_shape(double nearer_than);
    bool rests_at_home() const;
    double way_left(const Positions& from) const;
    bool is_arrangement_of(const Positions& shape) const;
    Positions placed(const Positions& shape) const;
    Status stuck() const;
    Status relax(Positions& positions, TraceRow& row);
    void enter_rest(const Positions& positions);
    void watch_corners(const Positions& positions);
    void hold(const std::vector<double>& held);
    bool linearise(const Positions& positions);
    void take_step(Positions& positions, TraceRow& row);
    double gradient_norm() const;
    bool is_at_rest() const;
    void renew_factor(TraceRow& row);
    double find_move();
    double find_move_beside_corners(const Positions& positions);
    double step_along(Positions& positions, double slope, double whole);
    double error_cost() const;
    bool project(Positions& positions);
    double exact_error() const { return std::min(k_exact_error, std::sqrt(m_options.threshold) / 2); }
    bool project_lengths(Positions& positions);

    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    std::vector<int> m_held;  // the vertices that are fixed, then those that slide
    std::vector<bool> m_is_free;
    std::vector<Slide> m_slides;
    std::vector<Axes> m_axes;  // V, along which a vertex may move
    std::vector<Pull> m_pulls;
    bool m_pulls_changed = true, m_pulls_moved = true;  // in number, place or weight; in their targets
    std::shared_ptr<const Guide> m_guide;
    double m_unit = 1;  // in the guide's
    const bool m_opens;
    std::unique_ptr<Equilibrium> m_opening;  // while it is under way
    int m_opening_steps = 0;
    Positions m_rest_shape;  // empty: not known
    std::unique_ptr<FreePart> m_part;
    std::unique_ptr<Method> m_projection;
    std::unique_ptr<LengthProjection> m_lengths;  // for the net and the corners watched, whatever the handles
    std::unique_ptr<TangentNewton> m_newton;
    bool m_has_metric = false;  // of the terms as they are
    std::vector<std::unique_ptr<Term>> m_terms;
    CornerLimit m_limit;

    Options m_options;
    bool m_reachable = true, m_only_nets = false;
    const Positions* m_last_net = nullptr;  // of the problem
    Stage m_stage = net;
    int m_steps = 0;                    // Newton steps of this solve
    double m_radius = 0;                // no vertex moves farther in the next step
    bool m_is_linearised = false;       // at m_result, as m_newton is
    bool m_is_still = false;            // the last step was a whole one, and short
    bool m_is_careful = false;          // corners are let go one by one: together they led nowhere
    double m_lack = 0;                  // of the limit, at m_result
    Positions m_result;                 // where the method last left the net; empty: nowhere
    Positions m_walk_from, m_walk_to;   // of stage 2: the handles' places
    double m_walked = 0, m_stride = 1;  // parts of the way: done, and of the next step
    bool m_was_placed = false;          // the rest shape, in this solve: a walk has begun there
    Positions m_stuck_at;               // where a walk before that ended early; empty: none did
    Eigen::Matrix3Xd m_last_move;       // of the net, in the last step of stage 2
    // At m_result, in stages 2 and 3:
    double m_energy = 0;
    Eigen::Matrix3Xd m_gradient;
    double m_max_deviation = 0;
    Eigen::Matrix3Xd m_direction, m_next_gradient;
    Positions m_origin;
};

void Equilibrium::prepare(const Problem& problem) {
    const Net& of = problem.net;
    if (m_net != &of) {
        m_lengths.reset();
        m_terms.clear();
        m_result.resize(3, 0);
        forget_rest_shape();
    }
    m_net = &of;
    m_topology = &problem.topology;
    m_held.assign(problem.fixed.begin(), problem.fixed.end());
    m_is_free = free_vertices(of.vertex_count(), m_held);
    m_slides.assign(problem.slides.begin(), problem.slides.end());
    m_axes = axes_of_motion(m_is_free, m_slides);
    for (const Slide& slide : m_slides) m_held.push_back(slide.vertex);
    m_part = std::make_unique<FreePart>(of, m_is_free);
    m_projection.reset();
    m_newton.reset();
    m_last_move.setZero(3, of.vertex_count());
    m_has_metric = m_is_still = m_is_linearised = false;
}

/// Made when first asked for: most edits do without. It keeps what slides where it stands.
Method& Equilibrium::projection() {
    if (!m_projection) {
        m_projection = make_method("projection");
        m_projection->prepare(problem());
    }
    return *m_projection;
}

void Equilibrium::take_pulls(std::span<const Pull> pulls) {
    const auto same_pull = [](const Pull& a, const Pull& b) {
        return a.vertex == b.vertex && a.weight == b.weight && a.yields == b.yields;
    };
    const auto same_target = [](const Pull& a, const Pull& b) { return a.target == b.target; };
    m_pulls_moved = !std::equal(m_pulls.begin(), m_pulls.end(), pulls.begin(), pulls.end(), same_target);
    m_pulls_changed |= !std::equal(m_pulls.begin(), m_pulls.end(), pulls.begin(), pulls.end(), same_pull);
    m_pulls.assign(pulls.begin(), pulls.end());
}

/// Whether it is the one of before.
bool Equilibrium::take_guide(const Problem& problem) {
    const bool same = m_guide == problem.guide && (m_unit == problem.unit || m_guide == nullptr);
    m_guide = problem.guide;
    m_unit = problem.unit;
    return same;
}

Status Equilibrium::start(const Problem& problem, Positions& positions, const Options& options) {
    take_pulls(problem.pulls);
    const bool same_guide = take_guide(problem);
    const bool same_energy = same_guide && !m_terms.empty() && !m_pulls_changed && ask_for_the_same(m_options, options);
    if (m_options.shear_limit != options.shear_limit) forget_rest_shape();
    m_options = options;
    m_reachable = problem.reachable;
    m_only_nets = problem.only_nets;
    m_last_net = problem.last_net;
    m_max_deviation = max_deviation(*m_net, positions);
    const bool is_where_left = m_result.cols() > 0 && m_result == positions;
    if (m_reachable && same_energy && !m_pulls_moved && is_where_left && is_at_rest()) return Status::converged;
    if (m_reachable && (m_opening || (m_rest_shape.cols() == 0 && begin_opening()))) {
        m_stage = open;
        return Status::running;
    }
    return begin(positions, same_energy);
}

void Equilibrium::forget_rest_shape() {
    m_rest_shape.resize(3, 0);
    m_opening.reset();
}

CornerLimit Equilibrium::limit() const {
    if (m_options.shear_limit == 0) return CornerLimit();
    return CornerLimit(*m_net, radians(m_options.shear_limit + k_limit_margin));
}

/// False if the rest shape is a net within the limit, or shall stay as it is.
bool Equilibrium::begin_opening() {
    m_rest_shape = m_net->rest_positions();
    if (!m_opens || (max_deviation(*m_net, m_rest_shape) < m_options.threshold &&
                     limit().largest_lack(m_rest_shape) <= CornerLimit::k_tolerance))
        return false;
    m_opening = std::make_unique<Equilibrium>(RestShape::as_it_is);
    m_opening->prepare({*m_net, *m_topology, {}});
    m_opening_steps = 0;
    Options options;
    options.threshold = m_options.threshold;
    options.shear_limit = m_options.shear_limit;
    if (m_opening->start({*m_net, *m_topology, {}}, m_rest_shape, options) == Status::running) return true;
    m_opening.reset();
    return false;
}

/// One step of it. Where no such net is found, the rest shape is what it was.
Status Equilibrium::open_rest_shape(Positions& positions, TraceRow& row) {
    const Status status = m_opening->iterate(m_rest_shape, row);
    row.max_deviation = m_max_deviation;
    if (status == Status::running && ++m_opening_steps < k_most_steps_of_opening) return Status::running;
    if (!(max_deviation(*m_net, m_rest_shape) < m_options.threshold)) m_rest_shape = m_net->rest_positions();
    m_opening.reset();
    return begin(positions, false);
}

Status Equilibrium::begin(Positions& positions, bool same_energy) {
    m_steps = 0;
    m_was_placed = false;
    m_stuck_at.resize(3, 0);
    const bool can_rest = m_reachable && m_part->size() > 0 && prepare_energy(positions, same_energy);
    m_stage = can_rest ? first_stage(positions) : net;
    if (m_stage == net && m_only_nets) return Status::unreachable;
    if (m_stage == net) {
        const Status status = projection().start(problem(), positions, m_options);
        if (status == Status::converged && can_rest) m_stage = rest;
        if (m_stage == net) return status;
    }
    if (m_stage == follow) begin_walk(positions);
    if (m_stage == follow && !m_only_nets && rests_at_home()) {
        const double way = way_left(m_result), any = std::numeric_limits<double>::infinity();
        begin_at_rest_shape(is_arrangement_of(m_net->rest_positions()) ? any : way > k_fast_drag ? way : k_home);
    }
    if (m_stage != follow) m_last_move.setZero();
    if (m_stage != rest) return Status::running;
    enter_rest(positions);
    if (!is_at_rest()) return Status::running;
    m_result = positions;
    return Status::converged;
}

/// False if the systems for it would be too large.
bool Equilibrium::prepare_energy(const Positions& positions, bool same_energy) {
    try {
        if (!same_energy) choose_energy();
        if (!m_pulls.empty()) m_terms.back() = std::make_unique<PullTerm>(*m_net, m_pulls);
        if (!m_newton) m_newton = std::make_unique<TangentNewton>(*m_net, *m_topology, *m_part, m_slides);
        if (!m_lengths) watch_corners(positions);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        return false;
    }
    if (!m_has_metric) m_newton->set_metric(m_terms);
    m_has_metric = true;
    m_lengths->system().set_free(m_is_free, m_slides);
    return true;
}

Equilibrium::Stage Equilibrium::first_stage(const Positions& positions) {
    const bool is_net = m_max_deviation < m_options.threshold;
    // A handle that has moved by ever so little has left the net less exact than rest needs it.
    if (was_left(m_result, positions)) return is_net && m_result == positions ? rest : follow;
    const bool has_opened = m_rest_shape != m_net->rest_positions();
    if (was_left(m_net->rest_positions(), positions) && (has_opened || !is_net) &&
        max_deviation(*m_net, m_rest_shape) < m_options.threshold) {
        m_result = m_rest_shape;
        return follow;
    }
    if (is_net) return rest;
    if (m_last_net == nullptr || !was_left(*m_last_net, positions)) return net;
    m_result = *m_last_net;
    return max_deviation(*m_net, m_result) < m_options.threshold ? follow : net;
}

/// What of a vertex's move is the handles' to say: all of it, but along the axes of what slides.
Eigen::Vector3d Equilibrium::held_part(int vertex, const Eigen::Vector3d& move) const {
    return across(m_axes[vertex], move);
}

Eigen::Vector3d Equilibrium::free_part(int vertex, const Positions& positions) const {
    return across(k_all_axes - m_axes[vertex], positions.col(vertex));
}

void Equilibrium::take_held(const Positions& from, int vertex, Positions& to) const {
    copy_along(k_all_axes - m_axes[vertex], from.col(vertex).data(), to.col(vertex).data());
}

void Equilibrium::take_free(const Positions& from, int vertex, Positions& to) const {
    copy_along(m_axes[vertex], from.col(vertex).data(), to.col(vertex).data());
}

/// Whether what is free stands where it was in a state of before.
bool Equilibrium::was_left(const Positions& before, const Positions& positions) const {
    if (before.cols() == 0) return false;
    for (int v : m_part->vertices())
        if (positions.col(v) != before.col(v) && free_part(v, positions) != free_part(v, before)) return false;
    return true;
}

/// From m_result to where the handles stand now.
void Equilibrium::begin_walk(const Positions& positions) {
    m_walk_from = m_result;
    m_walk_to = positions;
    const double lengths = way_left(m_walk_from);
    const double stride = (lengths <= k_fast_drag ? k_fast_step : k_careful_step) / lengths;
    m_stride = lengths <= k_one_step ? 1 : std::max(stride, k_least_stride);
    m_walked = 0;
}

/// Whether the rest shape is at rest where handles do not deform it.
bool Equilibrium::rests_at_home() const {
    const bool is_guided = m_guide != nullptr && m_options.guide_mode != 0;
    return m_pulls.empty() && !is_guided && m_options.gravity == 0 && !m_options.straight_rods;
}

/// The farthest that a handle has to go from this net, in edge lengths.
double Equilibrium::way_left(const Positions& from) const {
    double longest = 0;
    for (int v : m_held) longest = std::max(longest, held_part(v, m_walk_to.col(v) - from.col(v)).norm());
    return longest / m_net->mean_length();
}

void Equilibrium::choose_energy() {
    const auto bending = m_options.straight_rods ? BendingTerm::Reference::straight : BendingTerm::Reference::rest;
    m_terms.clear();
    m_terms.push_back(
        std::make_unique<BendingTerm>(*m_net, *m_topology, m_rest_shape, m_options.bending_weight, bending));
    m_terms.push_back(std::make_unique<ShearTerm>(*m_net, m_rest_shape, m_options.shear_weight,
                                                  ShearTerm::Reference::rest,
                                                  radians(std::max(m_options.shear_limit, k_least_open_angle))));
    if (m_options.gravity > 0)
        m_terms.push_back(std::make_unique<GravityTerm>(*m_net, m_options.gravity, -Eigen::Vector3d::UnitZ()));
    if (m_guide != nullptr && m_options.guide_mode != 0) m_terms.push_back(closeness());
    if (!m_pulls.empty()) m_terms.push_back(std::make_unique<PullTerm>(*m_net, m_pulls));
    m_limit = limit();
    m_lengths.reset();
    m_has_metric = m_pulls_changed = false;
}

std::unique_ptr<Term> Equilibrium::closeness() const {
    const auto mode = static_cast<GuideMode>(m_options.guide_mode);
    const double weight = mode == GuideMode::near ? m_options.guide_weight : k_hold * m_options.guide_weight;
    const auto side = mode == GuideMode::outside ? ClosenessTerm::Side::below : ClosenessTerm::Side::both;
    return make_closeness_term(*m_net, *m_guide, m_unit, weight, side);
}

double Equilibrium::evaluate(const Positions& x, Eigen::Matrix3Xd& gradient) {
    gradient.setZero(3, x.cols());
    double energy = 0;
    for (const auto& term : m_terms) energy += term->evaluate(x, gradient);
    return energy;
}

Status Equilibrium::iterate(Positions& positions, TraceRow& row) {
    Stopwatch watch;
    const Stage stage = m_stage;
    Status status = Status::running;
    row.free_vertices = m_part->size();
    if (stage == open) return open_rest_shape(positions, row);
    if (stage == net) status = find_net(positions, row);
    if (stage == follow) status = follow_handles(positions, row);
    if (stage == rest) status = relax(positions, row);
    row.stage = stage;
    row.max_deviation = m_max_deviation;
    if (stage != net) {
        row.energy = m_energy;
        row.assembly_ms = std::max(0.0, watch.milliseconds() - row.factorisation_ms - row.line_search_ms);
    }
    if (m_stage != follow) m_result = positions;
    return status;
}

Status Equilibrium::find_net(Positions& positions, TraceRow& row) {
    const Status status = projection().iterate(positions, row);
    m_max_deviation = row.max_deviation;
    return begin_rest(status, positions);
}

/// From where `projection` has ended like this, if it has found a net.
Status Equilibrium::begin_rest(Status of_projection, Positions& positions) {
    if (of_projection != Status::converged || !m_reachable) return of_projection;
    if (!m_lengths || !m_newton) return Status::exact;
    const Positions found = positions;
    if (!project(positions)) {
        positions = found;
        m_lack = m_limit.largest_lack(positions);
        return stuck();
    }
    enter_rest(positions);
    return Status::running;
}

/// One step of the walk, and one towards rest there.
Status Equilibrium::follow_handles(Positions& positions, TraceRow& row) {
    const double before = m_walked;
    Positions x = m_result;
    walk(std::min(1.0, m_walked + m_stride), x);
    if (m_only_nets && m_walked - before < k_least_progress * std::min(m_stride, 1 - before)) {
        positions = m_result;
        return Status::unreachable;
    }
    if (m_walked == before) return find_another_net(positions);
    enter_rest(x);
    if (m_is_linearised) take_step(x, row);
    m_last_move = x - m_result;
    m_result = x;
    if (m_only_nets)
        positions = x;
    else
        for (int v : m_part->vertices()) take_free(x, v, positions);
    m_max_deviation = max_deviation(*m_net, positions);
    if (m_walked < 1) {
        m_stage = follow;
        m_steps = 0;
    }
    return Status::running;
}

/// From net to net until the handles are this part of their way: at once or, where there is no net so far, in shorter
/// steps, but not too many. Leaves in m_walked how far they have come.
void Equilibrium::walk(double part, Positions& x) {
    double stride = part - m_walked;
    for (int trial = 0; trial < k_most_trials && m_walked < part; ++trial) {
        const double next = stride < part - m_walked ? m_walked + stride : part;
        Positions y = x;
        if (move_handles(next, y)) {
            x = y;
            m_walked = next;
        } else {
            stride /= 2;
        }
    }
}

/// Takes the handles to this part of their way and makes the rest follow. False if that gives no net.
bool Equilibrium::move_handles(double part, Positions& x) {
    const std::vector<double> held = m_limit.held();
    Eigen::Matrix3Xd moves = Eigen::Matrix3Xd::Zero(3, x.cols());
    for (int v : m_held)
        moves.col(v) = held_part(v, m_walk_from.col(v) + part * (m_walk_to.col(v) - m_walk_from.col(v)) - x.col(v));
    predict(moves);
    x += moves;
    if (part == 1)
        for (int v : m_held) take_held(m_walk_to, v, x);
    if (project(x)) return true;
    hold(held);
    return false;
}

/// How free vertices follow the moves of fixed ones: as they did in the last step, as far as this one is like it, and
/// for the rest as smoothly as the energy's bound allows.
void Equilibrium::predict(Eigen::Matrix3Xd& moves) {
    double along = 0, before = 0;
    for (int v : m_held) {
        const Eigen::Vector3d last = held_part(v, m_last_move.col(v));
        along += moves.col(v).dot(last);
        before += last.squaredNorm();
    }
    const double part = before > 0 ? k_repeated * std::clamp(along / before, -k_most_repeated, k_most_repeated) : 0;
    for (int v : m_held) moves.col(v) -= part * held_part(v, m_last_move.col(v));
    m_newton->extend(moves);
    moves += part * m_last_move;
}

/// Where the way from the last net leads no farther: by the way from the rest shape, or else by `projection`.
Status Equilibrium::find_another_net(Positions& positions) {
    if (begin_at_rest_shape(std::numeric_limits<double>::infinity())) {
        m_stuck_at = positions;
        return Status::running;
    }
    if (m_stuck_at.cols() > 0) positions = m_stuck_at;
    m_stage = net;
    const Status status = projection().start(problem(), positions, m_options);
    m_max_deviation = max_deviation(*m_net, positions);
    return begin_rest(status, positions);
}

/// Walks from the rest shape in place of the last net. False if it has done so in this solve, or the rest shape is no
/// net, or handles would have as far to go as this, in edge lengths.
bool Equilibrium::begin_at_rest_shape(double nearer_than) {
    if (m_was_placed || !(max_deviation(*m_net, m_rest_shape) < m_options.threshold)) return false;
    const Positions start = placed(m_rest_shape);
    if (!(way_left(start) < nearer_than)) return false;
    m_was_placed = true;
    m_result = start;
    // As if nothing had been before, so that the end does not depend on it.
    if (!prepare_energy(m_result, false)) return false;
    m_newton->forget_multipliers();
    m_last_move.setZero();
    begin_walk(m_walk_to);
    return true;
}

/// Whether handles are to be as they are in this shape, wherever that is.
bool Equilibrium::is_arrangement_of(const Positions& shape) const { return way_left(placed(shape)) < k_home; }

/// A shape, turned and shifted to where handles are to be, what slides to where it has slid, and as far as that leaves
/// it free, to the last net.
Positions Equilibrium::placed(const Positions& shape) const {
    Positions to = m_result;
    for (int v : m_held) take_held(m_walk_to, v, to);
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(to.cols());
    for (int v : m_held) weight[v] = 1;
    if (m_held.size() < 3 || !fit(shape, to, weight).is_determined)
        weight.array() += k_free_weight / static_cast<double>(to.cols());
    const RigidMotion motion = fit(shape, to, weight);
    for (Eigen::Index v = 0; v < to.cols(); ++v) to.col(v) = motion.of(shape.col(v));
    return to;
}

void Equilibrium::enter_rest(const Positions& positions) {
    m_stage = rest;
    m_energy = evaluate(positions, m_gradient);
    m_max_deviation = max_deviation(*m_net, positions);
    linearise(positions);
    m_radius = k_most_move * m_net->mean_length();
    m_is_still = m_is_linearised && gradient_norm() < k_no_force;
    m_is_careful = false;
}

/// Per unit of length.
double Equilibrium::gradient_norm() const { return m_newton->gradient_norm() * m_net->mean_length(); }

bool Equilibrium::is_at_rest() const {
    return m_is_still && m_max_deviation < m_options.threshold && gradient_norm() < m_options.rest_tolerance &&
           m_lack <= 2 * CornerLimit::k_tolerance;
}

/// The end of a way to rest that leads no farther.
Status Equilibrium::stuck() const {
    const bool is_net = m_max_deviation < m_options.threshold && m_lack <= 2 * CornerLimit::k_tolerance;
    return is_net ? Status::exact : Status::stalled;
}

Status Equilibrium::relax(Positions& positions, TraceRow& row) {
    if (!m_is_linearised && !linearise(positions)) return stuck();
    if (is_at_rest()) return Status::converged;
    take_step(positions, row);
    if (row.step == 0) {
        if (m_is_linearised && gradient_norm() < m_options.rest_tolerance) return Status::converged;
        if (m_is_careful) return stuck();
        m_is_careful = true;
    }
    if (!linearise(positions)) return stuck();
    row.factorisation_ms += m_newton->factorisation_ms();
    return is_at_rest() ? Status::converged : Status::running;
}

/// One Newton step, within the trust region that the steps before have left.
void Equilibrium::take_step(Positions& positions, TraceRow& row) {
    ++m_steps;
    renew_factor(row);
    row.gradient_norm = gradient_norm();
    Stopwatch watch;
    m_origin = positions;
    const double slope = find_move_beside_corners(positions);
    const double whole = m_limit.part_until_short(positions, m_direction);
    row.step = step_along(positions, slope, whole);
    row.line_search_ms = watch.milliseconds();
    const double L = m_net->mean_length(), moved = row.step * m_direction.colwise().norm().maxCoeff();
    const bool was_cut = row.step < 1 || m_newton->ended_at_radius();
    if (row.step < whole)
        m_radius = moved;
    else if (was_cut)
        m_radius = std::min(2 * m_radius, k_most_move * L);
    m_is_still = !was_cut && moved < k_still * L;
    m_max_deviation = max_deviation(*m_net, positions);
}

void Equilibrium::renew_factor(TraceRow& row) {
    if (m_steps == 1 || m_newton->inner_iterations() > k_old_factor_iterations) m_newton->forget_factor();
    if (m_steps <= k_cheap_steps || m_newton->has_factor()) return;
    m_newton->factorize(m_terms);
    row.factorisation_ms = m_newton->factorisation_ms();
}

/// A move that corners at their limit do not stop early: those that would are held. While handles may still be moving,
/// what they leave of the first move is good enough. Returns its slope; with 0 none may have been found.
double Equilibrium::find_move_beside_corners(const Positions& positions) {
    for (int round = 0;; ++round) {
        const Eigen::VectorXd excess = m_limit.excess(m_lengths->system());
        if (excess.maxCoeff() > 0 && !m_newton->shorten(excess)) break;
        const double slope = round > 0 && m_steps == 1 ? m_newton->restrict(m_direction) : find_move();
        if (round == k_most_joins || m_limit.hold_blocking_ones(positions, m_direction) == 0) return slope;
        m_limit.apply(m_lengths->system());
        if (!m_newton->linearise(positions, m_gradient, *m_lengths)) break;
    }
    m_direction.setZero(3, positions.cols());
    return 0;
}

/// By the exact Hessian, or if that is indefinite, and while handles may still be moving, by a convex one. Returns the
/// slope of m_direction.
double Equilibrium::find_move() {
    const int inner = m_newton->has_factor() ? k_most_iterations_with_factor
                                             : std::min(k_most_inner_iterations, k_least_inner_iterations * m_steps);
    if (m_steps > 1) {
        const double slope =
            m_newton->find_move(m_terms, Curvature::exact, inner, k_inner_tolerance, m_radius, m_direction);
        if (!m_newton->met_negative_curvature()) return slope;
    }
    return m_newton->find_move(m_terms, Curvature::convex, inner, k_inner_tolerance, m_radius, m_direction);
}

/// Armijo backtracking from m_origin along this part of m_direction, with a projection onto the lengths after each
/// trial. Returns the part of the direction that was accepted; 0: none, and the positions stay.
double Equilibrium::step_along(Positions& positions, double slope, double whole) {
    const bool opens = m_lack > CornerLimit::k_tolerance;  // which costs energy
    const std::vector<double> held = m_limit.held();
    const double before = m_energy + m_newton->error_cost();
    double step = whole;
    for (int trial = 0; (slope < 0 || opens) && trial <= k_most_halvings; ++trial, step /= 2) {
        m_limit.set_held(held);
        m_limit.approach(held, step);
        m_limit.apply(m_lengths->system());
        positions = m_origin + step * m_direction;
        if (!project(positions)) continue;
        const double energy = evaluate(positions, m_next_gradient);
        if (!opens && !(energy + error_cost() <= before + k_sufficient_decrease * step * slope)) continue;
        m_energy = energy;
        m_gradient.swap(m_next_gradient);
        m_is_linearised = false;
        return step;
    }
    positions = m_origin;
    hold(held);
    evaluate(positions, m_gradient);
    linearise(positions);
    return 0;
}

/// λ·c of the edges at the positions last projected, by the multipliers of before.
double Equilibrium::error_cost() const {
    return dense::dot(m_newton->multipliers().data(), m_lengths->system().errors().data(), m_net->edge_count());
}

/// Onto the lengths, and out of corners that are too sharp. False if the lengths are not reached.
bool Equilibrium::project(Positions& positions) {
    for (int round = 0; round < k_most_openings; ++round) {
        if (!project_lengths(positions)) return false;
        if (m_limit.needs_more_rows(positions)) watch_corners(positions);
        if (m_limit.hold_short_ones(positions) == 0) break;
        m_limit.apply(m_lengths->system());
    }
    return max_deviation(*m_net, positions) < m_options.threshold || project_lengths(positions);
}

bool Equilibrium::project_lengths(Positions& positions) {
    double best = std::numeric_limits<double>::infinity();
    for (int k = 0, patience = k_patience; k < k_most_projections && patience > 0; ++k, --patience) {
        if (!m_lengths->project(positions)) return false;
        m_lengths->system().assemble(positions);
        const double error = m_lengths->system().errors().lpNorm<Eigen::Infinity>();
        if (error < exact_error()) break;
        if (error < best / 2) patience = k_patience;
        best = std::min(best, error);
    }
    return max_deviation(*m_net, positions) < m_options.threshold;
}

/// A system of lengths with rows for the corners that are sharp now.
void Equilibrium::watch_corners(const Positions& positions) {
    m_limit.watch(positions);
    m_lengths = std::make_unique<LengthProjection>(*m_net, *m_topology, m_limit.watched());
    m_lengths->system().set_free(m_is_free, m_slides);
    m_limit.apply(m_lengths->system());
    m_lengths->system().assemble(positions);
}

void Equilibrium::hold(const std::vector<double>& held) {
    m_limit.set_held(held);
    m_limit.apply(m_lengths->system());
}

/// With the rows of corners that push.
bool Equilibrium::linearise(const Positions& positions) {
    m_lack = m_limit.largest_lack(positions);
    m_is_linearised = m_newton->linearise(positions, m_gradient, *m_lengths);
    for (int round = 0; m_is_linearised && round < k_most_rounds; ++round) {
        const Eigen::VectorXd& multipliers = m_newton->multipliers();
        if ((m_is_careful ? m_limit.release_one(multipliers) : m_limit.release(multipliers)) == 0) break;
        m_limit.apply(m_lengths->system());
        m_is_linearised = m_newton->linearise(positions, m_gradient, *m_lengths);
    }
    return m_is_linearised;
}

std::span<const double> Equilibrium::edge_forces() const {
    if (m_stage != rest || m_newton->multipliers().size() == 0) return {};
    const Eigen::VectorXd& multipliers = m_newton->multipliers();
    return {multipliers.data(), static_cast<std::size_t>(m_net->edge_count())};
}

std::unique_ptr<Method> make() { return std::make_unique<Equilibrium>(Equilibrium::RestShape::opened); }

}  // namespace

/// The net at rest: the least of a stated energy among all nets with exact lengths, exact handles and no corner of a
/// quad sharper than Options::shear_limit. Equal lengths leave the shear free (Li et al. 2022, figure 4); here bending
/// of net lines (BendingTerm), shear (ShearTerm), soft handles (PullTerm) and weight (GravityTerm) decide it, so that
/// an edit has one answer, whatever the way to it, but for buckling: of several equilibria the one is kept that the
/// present shape leads to. The energy counts from the net's rest shape; where that is no net within the limit, it is
/// first made one, at rest without handles. In stages:
///
///   1  a net, by `projection`, if none is known near: where somebody else has moved the net, or stage 2 fails from the
///      last net and from the rest shape;
///   2  after handles have moved: in steps of an edge length at most, free vertices go on as in the step before, as far
///      as the handles do, and follow the rest of the handles' way as smoothly as the energy's bound allows; they are
///      projected onto the lengths, and make one step of stage 3. So a jump ends where a drag does. Where the way leads
///      no farther, and where it is shorter for handles that jump, it begins at the rest shape;
///   3  Newton steps for the energy among nets (TangentNewton), each projected onto the lengths and out of corners that
///      are too sharp (CornerLimit), until the gradient that the constraints leave is below Options::rest_tolerance.
///
/// What slides is free, but for the coordinates that it keeps: these walk with the handles, and moves, Newton steps and
/// projections leave them alone. At rest no force is left along its axes. Stage 1 and a shape to begin with have it
/// stand.
///
/// From the end of stage 2 on every iteration ends in a net, and the energy falls, but while corners are being opened.
/// `converged` says that lengths, limit and rest are reached; `exact` that rest is not; `stalled` that the limit is not
/// either. Where no net is found it ends as `projection` does.
constinit const MethodInfo k_equilibrium = {
    "equilibrium", "The net at rest: bending and shear at their least under exact lengths and a limit of the corners.",
    "Gould, Hribar, Nocedal: On the Solution of Equality Constrained Quadratic Programming Problems Arising in "
    "Optimization. SIAM Journal on Scientific Computing 23(4), 2001",
    in_this_build(make)};

}  // namespace chebnet
