#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "base/stopwatch.h"
#include "linear/dense_kernels.h"
#include "net/measures.h"
#include "solve/methods/methods.h"
#include "solve/parts/bow.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/handle_walk.h"
#include "solve/parts/net_constraints.h"
#include "solve/parts/option_names.h"
#include "solve/parts/path_extrapolation.h"
#include "solve/parts/rest_energy.h"
#include "solve/parts/tangent_newton.h"

namespace chebnet {

namespace {

// Tries of a step of the walk, at once or in shorter ones.
constexpr int k_most_trials = 8;
// Iterations within a Newton step: few while handles may still be moving, more as it settles. With fewer than this the
// steps of a drag are so rough that what the next one repeats of them grows.
constexpr double k_inner_tolerance = 0.05;
constexpr int k_least_inner_iterations = 8, k_most_inner_iterations = 60;
// So many steps of a solve do without a factor of the Hessian: as many as a frame of a drag has time for; but for the
// first of them, one of a solve before is used where there is any. Later steps have one, which is renewed when it has
// become so old that more iterations are needed than this.
constexpr int k_cheap_steps = 2, k_old_factor_iterations = 12, k_most_iterations_with_factor = 100;
// No vertex moves farther in one step, in edge lengths.
constexpr double k_most_move = 1;
constexpr double k_sufficient_decrease = 1e-4;  // of Armijo's rule
constexpr int k_most_halvings = 8;
// The limit aims a little higher than it has to be, so that it is met in spite of its tolerance.
constexpr double k_limit_margin = 0.02;  // degrees
// How often corners may join those that are held, or leave them, in one step.
constexpr int k_most_joins = 6, k_most_rounds = 4;
// After so many the rest shape is taken as far as it has come.
constexpr int k_most_steps_of_opening = 100;
// At rest no vertex moves farther in a Newton step, in edge lengths.
constexpr double k_still = 1e-3;
// A path of the descent is followed after so many steps, by so many edge lengths at most.
constexpr int k_steps_of_a_path = 3;
constexpr double k_most_along_path = 4;
// After so many steps that lower the energy by no more than this part of it, and the force hardly, none will: what is
// left is below the digits of what the net is pulled by.
constexpr int k_most_idle_steps = 5;
constexpr double k_idle_part = 1e-13, k_idle_force = 0.9;
// Less force than this moves nothing: a net that comes at rest need not be tried.
constexpr double k_no_force = 1e-9;
// By how far a net has moved while a step took off this part of the force, it is told how far it has to go.
constexpr double k_telling = 0.1;
// The most dL of a net that a solve ends with short of rest.
constexpr double k_end_deviation = 1e-12;
constexpr int k_most_refinements = 20;
// Of the bow that a flat net gets which is at rest in its plane alone, in edge lengths.
constexpr double k_first_bow = 1;
constexpr int k_most_bows = 6, k_most_loads = 20;  // that are tried
// A net has given way nowhere with less energy of bending than this.
constexpr double k_unbent = 1e-9;

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
    std::optional<RestState> rest_state() const override;

private:
    enum Stage { net = 1, follow = 2, rest = 3, open = 4 };

    Method& projection();
    Problem problem() const { return {*m_net, *m_topology, m_walk.held().vertices(), m_pulls, m_reachable}; }
    void take_pulls(std::span<const Pull> pulls);
    bool take_guide(const Problem& problem, const Options& options);
    CornerLimit limit() const;
    void forget_rest_shape();
    bool begin_opening();
    Status open_rest_shape(Positions& positions, TraceRow& row);
    Status begin(Positions& positions, bool same_energy);
    bool is_held_as_net() const;
    Status without_rest(const Positions& positions) const;
    bool is_carried() const;
    bool prepare_energy(const Positions& positions, bool same_energy);
    void begin_walk_home();
    Stage first_stage(const Positions& positions);
    bool was_left(const Positions& before, const Positions& positions) const;
    Status find_net(Positions& positions, TraceRow& row);
    Status begin_rest(Status of_projection, Positions& positions);
    Status follow_handles(Positions& positions, TraceRow& row);
    void walk(double part, Positions& x);
    bool move_handles(double part, Positions& x);
    void add_bow(const Positions& x, Eigen::Matrix3Xd& moves);
    bool give_way(Positions& positions);
    bool find_bow(const Eigen::Vector3d& normal, Eigen::Matrix3Xd& bow);
    Status find_another_net(Positions& positions);
    bool begin_at_rest_shape(double nearer_than);
    bool is_net() const;
    Status stuck() const;
    Status step_to_rest(Positions& positions, TraceRow& row);
    Status relax(Positions& positions, TraceRow& row);
    void refine_lengths(Positions& positions);
    void enter_rest(const Positions& positions);
    bool follow_path(Positions& positions);
    bool linearise(const Positions& positions);
    void take_step(Positions& positions, TraceRow& row);
    double gradient_norm() const;
    double motion_left() const;
    bool is_at_rest() const;
    bool is_balanced() const;
    bool is_idle(double energy_before, double force_before);
    void renew_factor(TraceRow& row);
    double find_move();
    double improve_move();
    int inner_iterations() const;
    double find_move_beside_corners(const Positions& positions);
    double step_along(Positions& positions, double slope, double whole);
    double error_cost();
    bool project(Positions& positions) { return project(positions, m_options.threshold); }
    bool project(Positions& positions, double threshold) {
        m_is_linearised = false;  // the system is another one now, or one for other positions
        return m_constraints->project(positions, threshold);
    }

    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    std::vector<bool> m_is_free;
    std::vector<Slide> m_slides;
    std::vector<Pull> m_pulls;
    bool m_pulls_changed = true, m_pulls_moved = true;  // in number, place or weight; in their targets
    std::shared_ptr<const Guide> m_guide;
    double m_unit = 1;  // in that of the guide and of the options' lengths
    const bool m_opens;
    std::unique_ptr<Equilibrium> m_opening;  // while it is under way
    int m_opening_steps = 0;
    Positions m_rest_shape;  // empty: not known
    std::unique_ptr<FreePart> m_part;
    std::unique_ptr<Method> m_projection;
    std::unique_ptr<NetConstraints> m_constraints;  // whatever the handles
    RestEnergy m_rest_energy;
    std::unique_ptr<TangentNewton> m_newton;
    bool m_has_metric = false;  // of the terms as they are
    HandleWalk m_walk;          // stage 2

    Options m_options;
    bool m_reachable = true, m_only_nets = false, m_only_walks = false;
    const Positions* m_last_net = nullptr;  // of the problem
    Stage m_stage = net;
    int m_steps = 0;               // Newton steps of this solve
    double m_radius = 0;           // no vertex moves farther in the next step
    bool m_is_linearised = false;  // at m_result, as m_newton is
    bool m_is_still = false;       // the last step was a whole one, and short
    bool m_is_careful = false;     // corners are let go one by one: together they led nowhere
    double m_lack = 0;             // of the limit, at m_result
    int m_idle_steps = 0;          // one after the other
    // Of the last step: the gradient's norm before, and how far it went in edge lengths.
    double m_gradient_before = 0, m_moved = 0;
    PathExtrapolation m_path;      // of the descent in stage 3
    Positions m_result;            // where the method last left the net; empty: nowhere
    bool m_has_given_way = false;  // in this solve
    bool m_began_as_net = false;   // this solve, which walks to it all the same
    Positions m_begun;             // if so
    bool m_was_placed = false;     // the rest shape, in this solve: a walk has begun there
    Positions m_stuck_at;          // where a walk before that ended early; empty: none did
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
        m_constraints.reset();
        m_rest_energy.forget();
        m_result.resize(3, 0);
        forget_rest_shape();
    }
    m_net = &of;
    m_topology = &problem.topology;
    m_is_free = free_vertices(of.vertex_count(), problem.fixed);
    m_slides.assign(problem.slides.begin(), problem.slides.end());
    m_pulls_changed |= m_options.gravity > 0;  // the net may hang by other vertices, or by none
    m_walk.set_handles(HeldVertices(of.vertex_count(), problem.fixed, problem.slides), problem.topology);
    m_walk.forget_moves(of.vertex_count());
    m_part = std::make_unique<FreePart>(of, m_is_free);
    m_projection.reset();
    m_newton.reset();
    m_has_metric = m_is_still = m_is_linearised = false;
}

/// Made when first asked for: most edits do without. It keeps what slides where it stands.
Method& Equilibrium::projection() {
    if (!m_projection) {
        auto projection = make_method("projection");
        projection->prepare(problem());
        m_projection = std::move(projection);
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

/// Whether it is the one of before, and in the same unit if that matters.
bool Equilibrium::take_guide(const Problem& problem, const Options& options) {
    const bool has_lengths = problem.guide != nullptr || options.rod_curvature != 0;
    const bool same = m_guide == problem.guide && (m_unit == problem.unit || !has_lengths);
    m_guide = problem.guide;
    m_unit = problem.unit;
    return same;
}

Status Equilibrium::start(const Problem& problem, Positions& positions, const Options& options) {
    take_pulls(problem.pulls);
    const bool same_guide = take_guide(problem, options);
    const bool same_energy =
        same_guide && m_rest_energy.is_chosen() && !m_pulls_changed && RestEnergy::is_the_same(m_options, options);
    if (!same_energy) m_rest_energy.forget();  // also where handles out of reach keep this solve from choosing another
    if (m_options.shear_limit != options.shear_limit) forget_rest_shape();
    m_options = options;
    m_reachable = problem.reachable;
    m_only_nets = problem.only_nets;
    m_only_walks = problem.only_walks;
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
    return CornerLimit(*m_net, (m_options.shear_limit + k_limit_margin) * std::numbers::pi / 180);
}

/// False if the rest shape is a net within the limit, or shall stay as it is.
bool Equilibrium::begin_opening() {
    m_rest_shape = m_net->rest_positions();
    if (!m_opens || (max_deviation(*m_net, m_rest_shape) < m_options.threshold &&
                     limit().largest_lack(m_rest_shape) <= CornerLimit::k_tolerance))
        return false;
    auto opening = std::make_unique<Equilibrium>(RestShape::as_it_is);
    opening->prepare({*m_net, *m_topology, {}});
    Options options;
    options.threshold = m_options.threshold;
    options.shear_limit = m_options.shear_limit;
    if (opening->start({*m_net, *m_topology, {}}, m_rest_shape, options) != Status::running) return false;
    m_opening = std::move(opening);
    m_opening_steps = 0;
    return true;
}

/// One step of it. Where no such net is found, the rest shape is what it was.
Status Equilibrium::open_rest_shape(Positions& positions, TraceRow& row) {
    const Status status = m_opening->iterate(m_rest_shape, row);
    row.stage = open;
    row.max_deviation = m_max_deviation;
    if (status == Status::running && ++m_opening_steps < k_most_steps_of_opening) return Status::running;
    if (!(max_deviation(*m_net, m_rest_shape) < m_options.threshold)) m_rest_shape = m_net->rest_positions();
    m_opening.reset();
    return begin(positions, false);
}

Status Equilibrium::begin(Positions& positions, bool same_energy) {
    m_steps = 0;
    m_was_placed = false;
    m_has_given_way = false;
    m_stuck_at.resize(3, 0);
    const bool can_rest = m_reachable && m_part->size() > 0 && prepare_energy(positions, same_energy);
    m_stage = can_rest ? first_stage(positions) : net;
    if (m_stage == net && m_reachable && is_held_as_net()) return without_rest(positions);
    if (m_stage == net && m_only_nets) return Status::unreachable;
    if (m_stage == net) {
        const Status status = projection().start(problem(), positions, m_options);
        if (status == Status::converged && can_rest) m_stage = rest;
        if (m_stage == net) return status == Status::converged ? without_rest(positions) : status;
    }
    if (m_stage == follow) {
        m_began_as_net = m_max_deviation < m_options.threshold;
        if (m_began_as_net) m_begun = positions;
        m_walk.begin(m_result, positions, m_net->mean_length());
        if (!m_only_nets) begin_walk_home();
    } else {
        m_walk.forget_moves(m_net->vertex_count());
    }
    if (m_stage != rest) return Status::running;
    enter_rest(positions);
    if (!is_at_rest()) return Status::running;
    m_result = positions;
    return Status::converged;
}

/// Whether nothing may move, and nothing has to. What a hand moves within the threshold would creep off the lengths,
/// and end where no net is near.
bool Equilibrium::is_held_as_net() const {
    return m_part->size() == 0 && m_max_deviation < (m_only_nets ? k_end_deviation : m_options.threshold);
}

/// Of a net where the systems for rest are too large, or nothing may move.
Status Equilibrium::without_rest(const Positions& positions) const {
    if (m_part->size() > 0) return Status::exact;
    return limit().largest_lack(positions) <= 2 * CornerLimit::k_tolerance ? Status::converged : Status::stalled;
}

/// Where handles are at home, or jump to where the rest shape is nearer than the last net, the walk begins at the rest
/// shape: at home that is the answer.
void Equilibrium::begin_walk_home() {
    if (!RestEnergy::is_least_at_rest_shape(m_options, m_pulls, m_guide.get())) return;
    if (m_walk.ends_as_in(m_net->rest_positions(), m_result))
        begin_at_rest_shape(std::numeric_limits<double>::infinity());
    else
        begin_at_rest_shape(m_walk.is_jump() ? m_walk.length() : HandleWalk::k_same);
}

/// Whether something keeps each piece of the net from falling for ever: at its height, or drawn towards a place.
bool Equilibrium::is_carried() const {
    if (m_options.gravity == 0) return true;
    constexpr int z = 2;
    std::vector<bool> carries(m_is_free.size());
    for (std::size_t v = 0; v < carries.size(); ++v) carries[v] = !m_is_free[v];
    for (const Slide& slide : m_slides) carries[slide.vertex] = !has_axis(slide.along, z);
    for (const Pull& pull : m_pulls) carries[pull.vertex] = true;
    const auto has_carrier = [&](const std::vector<int>& piece) {
        return std::any_of(piece.begin(), piece.end(), [&](int v) { return carries[v]; });
    };
    const std::vector<std::vector<int>> pieces = m_topology->components();
    return std::all_of(pieces.begin(), pieces.end(), has_carrier);
}

/// False if the systems for it would be too large.
bool Equilibrium::prepare_energy(const Positions& positions, bool same_energy) {
    try {
        if (!same_energy) {
            Options options = m_options;
            if (!is_carried()) options.gravity = 0;
            m_rest_energy.choose(*m_net, *m_topology, m_rest_shape, options, m_pulls, m_guide.get(), m_unit);
            m_constraints.reset();
            m_has_metric = m_pulls_changed = false;
        }
        m_rest_energy.move_pulls(*m_net, m_pulls);
        if (!m_newton) m_newton = std::make_unique<TangentNewton>(*m_net, *m_topology, *m_part, m_slides);
        if (!m_constraints)
            m_constraints =
                std::make_unique<NetConstraints>(*m_net, *m_topology, limit(), m_is_free, m_slides, m_pulls, positions);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        return false;
    }
    if (!m_has_metric) m_newton->set_metric(m_rest_energy.terms());
    m_has_metric = true;
    m_constraints->set_free(m_is_free, m_slides, m_pulls);
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
    if (m_last_net != nullptr && *m_last_net != positions && was_left(*m_last_net, positions) &&
        max_deviation(*m_net, *m_last_net) < m_options.threshold) {
        m_result = *m_last_net;
        return follow;
    }
    return is_net ? rest : net;
}

/// Whether what is free stands where it was in a state of before.
bool Equilibrium::was_left(const Positions& before, const Positions& positions) const {
    if (before.cols() == 0) return false;
    for (int v : m_part->vertices())
        if (!m_walk.held().stands_the_same(v, before, positions)) return false;
    return true;
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
    if (of_projection != Status::converged) return of_projection;
    if (!m_reachable) return Status::exact;  // no handle that is drawn from afar comes to rest
    if (!m_constraints || !m_newton) return without_rest(positions);
    const Positions found = positions;
    if (!project(positions)) {
        positions = found;
        m_lack = m_constraints->lack(positions);
        return stuck();
    }
    enter_rest(positions);
    return Status::running;
}

/// One step of the walk, and one towards rest there.
Status Equilibrium::follow_handles(Positions& positions, TraceRow& row) {
    const double before = m_walk.walked();
    Positions x = m_result;
    walk(m_walk.next(), x);
    if (m_only_nets && m_walk.is_nearly_stuck_since(before)) {
        positions = m_result;
        return Status::unreachable;
    }
    if (m_walk.walked() == before) return find_another_net(positions);
    enter_rest(x);
    if (m_is_linearised) take_step(x, row);
    m_walk.note_move(x - m_result);
    m_result = x;
    // What began as a net stays it until the walk has come to another one there.
    const bool waits = m_began_as_net && m_walk.walked() < 1;
    if (m_only_nets)
        positions = x;
    else if (!waits)
        for (int v : m_part->vertices()) m_walk.held().take_free(v, x.col(v), positions);
    m_max_deviation = max_deviation(*m_net, positions);
    if (m_walk.walked() < 1) {
        m_stage = follow;
        m_steps = 0;
    }
    return Status::running;
}

/// From net to net until the handles are this part of their way: at once or, where there is no net so far, in shorter
/// steps, but not too many.
void Equilibrium::walk(double part, Positions& x) {
    double stride = part - m_walk.walked();
    for (int trial = 0; trial < k_most_trials && m_walk.walked() < part; ++trial) {
        const double next = stride < part - m_walk.walked() ? m_walk.walked() + stride : part;
        Positions y = x;
        if (move_handles(next, y)) {
            x = y;
            m_walk.go_to(next);
        } else {
            stride /= 2;
        }
    }
}

/// Takes the handles to this part of their way. What is free follows as in the last step, as far as this one is like
/// it, and for the rest as smoothly as the energy's bound allows. False if that gives no net.
bool Equilibrium::move_handles(double part, Positions& x) {
    const std::vector<double> held = m_constraints->held();
    Eigen::Matrix3Xd moves = m_walk.moves_to(part, x);
    const double repeated = m_walk.take_off_repeated(moves);
    m_newton->extend(moves);
    moves += repeated * m_walk.last_move();
    add_bow(x, moves);
    x += moves;
    if (part == 1) m_walk.held().take_held(m_walk.end(), x);
    if (project(x)) return true;
    m_constraints->hold(held);
    return false;
}

/// Handles that squeeze a flat net make it bow out of its plane, in the shape in which an even load bends it.
void Equilibrium::add_bow(const Positions& x, Eigen::Matrix3Xd& moves) {
    const auto normal = normal_of_flat(*m_net, x);
    if (!normal) return;
    Eigen::Matrix3Xd load(3, x.cols()), bow;
    load.colwise() = *normal;
    m_newton->give_way(load, bow);
    moves += part_of_bow(*m_net, x, moves, bow, m_options.gravity > 0) * bow;
}

/// Where the way from the last net leads no farther: by the way from the rest shape, or else, if it was to end where
/// all edges had their lengths, from there, or else by `projection`; none of the two if only walks are asked for.
Status Equilibrium::find_another_net(Positions& positions) {
    if (begin_at_rest_shape(std::numeric_limits<double>::infinity())) {
        m_stuck_at = positions;
        return Status::running;
    }
    if (m_only_walks) {
        if (m_stuck_at.cols() > 0) positions = m_stuck_at;
        return Status::unreachable;
    }
    if (m_began_as_net) {
        positions = m_result = m_begun;
        m_began_as_net = false;
        enter_rest(positions);
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
    const Positions start = m_walk.placed(m_rest_shape, m_result);
    if (!(m_walk.way_left(start) < nearer_than)) return false;
    m_was_placed = true;
    m_result = start;
    // As if nothing had been before, so that the end does not depend on it.
    if (!prepare_energy(m_result, false)) return false;
    m_newton->forget_multipliers();
    m_walk.forget_moves(m_net->vertex_count());
    m_walk.begin(m_result, m_walk.end(), m_net->mean_length());
    return true;
}

void Equilibrium::enter_rest(const Positions& positions) {
    m_stage = rest;
    m_energy = m_rest_energy.evaluate(positions, m_gradient);
    m_max_deviation = max_deviation(*m_net, positions);
    linearise(positions);
    m_radius = k_most_move * m_net->mean_length();
    m_is_still = m_is_linearised && gradient_norm() < k_no_force;
    m_is_careful = false;
    m_idle_steps = 0;
    m_path.clear();
    m_gradient_before = 0;
}

/// Per unit of length.
double Equilibrium::gradient_norm() const { return m_newton->gradient_norm() * m_net->mean_length(); }

bool Equilibrium::is_at_rest() const { return m_is_still && is_balanced(); }

/// A net without a force but of what keeps it one: corners that are held before they come to their limit do not.
bool Equilibrium::is_balanced() const {
    return m_is_linearised && is_net() && gradient_norm() < m_options.rest_tolerance &&
           m_constraints->excess().maxCoeff() <= CornerLimit::k_tolerance;
}

/// With exact lengths, and no corner beyond the limit.
bool Equilibrium::is_net() const {
    return m_max_deviation < m_options.threshold && m_lack <= 2 * CornerLimit::k_tolerance;
}

/// The end of a way to rest that leads no farther.
Status Equilibrium::stuck() const { return is_net() ? Status::exact : Status::stalled; }

Status Equilibrium::relax(Positions& positions, TraceRow& row) {
    if (m_steps == 0) give_way(positions);
    const Status status = step_to_rest(positions, row);
    if (status != Status::running && give_way(positions)) return Status::running;
    if (status == Status::exact) refine_lengths(positions);
    return status;
}

/// Where a net is nearly taut lengths are come to slowly, and a step ends as near to them as the threshold asks for.
/// Those of a net that stays are to be nearer.
void Equilibrium::refine_lengths(Positions& positions) {
    for (int round = 0; round < k_most_refinements && m_max_deviation >= k_end_deviation; ++round) {
        Positions x = positions;
        project(x, k_end_deviation);
        const double deviation = max_deviation(*m_net, x);
        if (!(deviation < m_max_deviation) || m_constraints->lack(x) > 2 * CornerLimit::k_tolerance) break;
        positions = x;
        m_max_deviation = deviation;
    }
    if (m_is_linearised) return;
    m_energy = m_rest_energy.evaluate(positions, m_gradient);
    linearise(positions);
}

/// A net that is pressed as it stands, flat or with straight lines, is without a force that would bend it, however hard
/// it is pressed. Where it would lose energy by bending it is given a first bow. False if it stays.
bool Equilibrium::give_way(Positions& positions) {
    if (m_has_given_way || !m_is_linearised) return false;
    const auto normal = normal_of_flat(*m_net, positions);
    Eigen::Matrix3Xd bow;
    if (!(normal ? find_bow(*normal, bow)
                 : m_steps > 0 && m_rest_energy.values().front() < k_unbent &&
                       m_newton->find_buckling(m_rest_energy.terms(), k_most_loads, bow)))
        return false;
    m_has_given_way = true;
    const bool is_up = !normal || normal->dot(bow.rowwise().sum()) >= 0, hangs = normal && m_options.gravity > 0;
    const double height = (is_up == hangs ? -1 : 1) * k_first_bow * m_net->mean_length();
    const std::vector<double> held = m_constraints->held();
    Positions bent = positions + height / bow.colwise().norm().maxCoeff() * bow;
    if (!project(bent)) {
        m_constraints->hold(held);
        linearise(positions);
        return false;
    }
    positions = bent;
    enter_rest(positions);
    return true;
}

/// Out of the plane of a flat net, which takes nothing from lengths to first order.
bool Equilibrium::find_bow(const Eigen::Vector3d& normal, Eigen::Matrix3Xd& bow) {
    Eigen::Matrix3Xd load(3, m_net->vertex_count());
    load.colwise() = normal;
    m_newton->give_way(load, bow);
    return m_newton->find_negative_curvature(m_rest_energy.terms(), k_most_bows, bow);
}

Status Equilibrium::step_to_rest(Positions& positions, TraceRow& row) {
    if (!m_is_linearised && !linearise(positions)) return stuck();
    if (is_at_rest()) return Status::converged;
    const double energy = m_energy;
    take_step(positions, row);
    if (row.step == 0) {
        if (is_balanced()) return Status::converged;
        if (m_is_careful) return stuck();
        m_is_careful = true;
    }
    if (!linearise(positions)) return stuck();
    row.factorisation_ms += m_newton->factorisation_ms();
    if (is_at_rest()) return Status::converged;
    if (is_idle(energy, row.gradient_norm)) return stuck();
    if (row.step > 0 && gradient_norm() < row.gradient_norm) {
        m_path.add(positions);
        if (!follow_path(positions)) return stuck();
    }
    return Status::running;
}

/// Whether a step was one too many of those that gain nothing. Opening corners costs energy.
bool Equilibrium::is_idle(double energy_before, double force_before) {
    const bool gains = m_lack > CornerLimit::k_tolerance || gradient_norm() < k_idle_force * force_before ||
                       m_energy < energy_before - k_idle_part * std::abs(energy_before);
    m_idle_steps = gains ? 0 : m_idle_steps + 1;
    return m_idle_steps == k_most_idle_steps;
}

/// A descent follows a valley of the energy whose floor is bent, in steps that leave it and come back by turns; those
/// that came back, with less of a gradient, lie on the floor. From the last of them along it, twice as far each time,
/// while the energy falls. False if there the net cannot be linearised.
bool Equilibrium::follow_path(Positions& positions) {
    if (m_steps < k_steps_of_a_path || !m_path.is_known() || m_lack > CornerLimit::k_tolerance) return true;
    const std::vector<double> held = m_constraints->held();
    double least = m_energy + m_newton->error_cost(), taken = 0;
    for (double t = 1;; t *= 2) {
        m_path.go(t, m_origin);
        if (m_path.farthest(m_origin) > k_most_along_path * m_net->mean_length() || !project(m_origin)) break;
        const double energy = m_rest_energy.evaluate(m_origin, m_next_gradient) + error_cost();
        if (!(energy < least)) break;
        least = energy;
        taken = t;
    }
    m_constraints->hold(held);
    if (taken > 0) {
        m_path.go(taken, positions);
        project(positions);
        m_is_still = false;
    } else {
        m_path.clear();
    }
    m_energy = m_rest_energy.evaluate(positions, m_gradient);
    m_max_deviation = max_deviation(*m_net, positions);
    return linearise(positions);
}

/// One Newton step, within the trust region that the steps before have left.
void Equilibrium::take_step(Positions& positions, TraceRow& row) {
    ++m_steps;
    renew_factor(row);
    row.gradient_norm = m_gradient_before = gradient_norm();
    Stopwatch watch;
    m_origin = positions;
    const double slope = find_move_beside_corners(positions);
    const double whole = m_constraints->part_until_short(positions, m_direction);
    row.step = step_along(positions, slope, whole);
    row.line_search_ms = watch.milliseconds();
    const double L = m_net->mean_length(), moved = row.step * m_direction.colwise().norm().maxCoeff();
    const bool was_cut = row.step < 1 || m_newton->ended_at_radius();
    if (row.step == 0)
        m_radius /= 1 << k_most_halvings;
    else if (row.step < whole)
        m_radius = moved;
    else if (was_cut)
        m_radius = std::min(2 * m_radius, k_most_move * L);
    m_is_still = !was_cut && moved < k_still * L;
    m_moved = moved / L;
    m_max_deviation = max_deviation(*m_net, positions);
}

void Equilibrium::renew_factor(TraceRow& row) {
    if (m_steps == 1 || m_newton->inner_iterations() > k_old_factor_iterations) m_newton->put_factor_away();
    if (m_steps == 2 && m_newton->take_last_factor()) return;
    if (m_steps <= k_cheap_steps || m_newton->uses_factor()) return;
    m_newton->factorize(m_rest_energy.terms());
    row.factorisation_ms = m_newton->factorisation_ms();
}

/// A move that corners near their limit allow as a whole: those that would come beyond it are brought to it and no
/// farther. While handles may still be moving, what they leave of the first move is good enough. Returns its slope;
/// with 0 none may have been found.
double Equilibrium::find_move_beside_corners(const Positions& positions) {
    for (int round = 0;; ++round) {
        const Eigen::VectorXd excess = m_constraints->excess();
        if (excess.maxCoeff() > 0 && !m_newton->shorten(excess)) break;
        const double slope = round == 0 ? find_move() : m_steps == 1 ? m_newton->restrict(m_direction) : improve_move();
        if (round == k_most_joins || !m_constraints->hold_blocking_ones(positions, m_direction)) return slope;
        if (!m_newton->linearise(positions, m_gradient, m_constraints->lengths())) break;
    }
    m_direction.setZero(3, positions.cols());
    return 0;
}

/// By the exact Hessian, or if that is indefinite, and while handles may still be moving, by a convex one. Returns the
/// slope of m_direction.
double Equilibrium::find_move() {
    if (m_steps > 1) {
        const double slope = m_newton->find_move(m_rest_energy.terms(), Curvature::exact, inner_iterations(),
                                                 k_inner_tolerance, m_radius, m_direction);
        if (!m_newton->met_negative_curvature()) return slope;
    }
    return m_newton->find_move(m_rest_energy.terms(), Curvature::convex, inner_iterations(), k_inner_tolerance,
                               m_radius, m_direction);
}

/// The same from m_direction, which was found with fewer corners held; anew where it was cut short.
double Equilibrium::improve_move() {
    if (m_newton->ended_at_radius() || m_newton->met_negative_curvature()) return find_move();
    const int inner = m_newton->uses_factor() ? k_most_iterations_with_factor : k_least_inner_iterations;
    const double slope = m_newton->improve_move(m_rest_energy.terms(), Curvature::exact, inner, m_radius, m_direction);
    return m_newton->met_negative_curvature() ? find_move() : slope;
}

int Equilibrium::inner_iterations() const {
    return m_newton->uses_factor() ? k_most_iterations_with_factor
                                   : std::min(k_most_inner_iterations, k_least_inner_iterations * m_steps);
}

/// Armijo backtracking from m_origin along this part of m_direction, turning where the net turns, with a projection
/// onto the lengths after each trial. Returns the part of the direction that was accepted; 0: none, and the positions
/// stay.
double Equilibrium::step_along(Positions& positions, double slope, double whole) {
    const bool opens = m_lack > CornerLimit::k_tolerance;  // which costs energy
    const std::vector<double> held = m_constraints->held();
    const double before = m_energy + m_newton->error_cost();
    double step = whole;
    m_newton->begin_way(m_origin, m_direction);
    for (int trial = 0; (slope < 0 || opens) && trial <= k_most_halvings; ++trial, step /= 2) {
        m_constraints->hold_closer(held, step);
        m_newton->go(step, positions);
        if (!project(positions)) continue;
        const double energy = m_rest_energy.evaluate(positions, m_next_gradient);
        if (!opens && !(energy + error_cost() <= before + k_sufficient_decrease * step * slope)) continue;
        m_energy = energy;
        m_gradient.swap(m_next_gradient);
        return step;
    }
    positions = m_origin;
    m_constraints->hold(held);
    m_constraints->release_early_ones();
    m_rest_energy.evaluate(positions, m_gradient);
    linearise(positions);
    return 0;
}

/// λ·c of the edges at the positions last projected, by the multipliers of before.
double Equilibrium::error_cost() {
    const Eigen::VectorXd& errors = m_constraints->lengths().system().errors();
    return dense::dot(m_newton->multipliers().data(), errors.data(), m_net->edge_count());
}

/// With the rows of corners that push.
bool Equilibrium::linearise(const Positions& positions) {
    m_lack = m_constraints->lack(positions);
    m_is_linearised = m_newton->linearise(positions, m_gradient, m_constraints->lengths());
    for (int round = 0; m_is_linearised && round < k_most_rounds; ++round) {
        if (!m_constraints->release(m_newton->multipliers(), m_is_careful)) break;
        m_is_linearised = m_newton->linearise(positions, m_gradient, m_constraints->lengths());
    }
    return m_is_linearised;
}

/// As far again as the last step went, by what it left of the gradient over what it took off. One that took off next to
/// nothing says nothing.
double Equilibrium::motion_left() const {
    const double left = gradient_norm(), taken = m_gradient_before - left;
    if (left < k_no_force) return 0;
    return m_is_linearised && taken > k_telling * m_gradient_before ? m_moved * left / taken
                                                                    : std::numeric_limits<double>::infinity();
}

std::optional<RestState> Equilibrium::rest_state() const {
    const bool has_net = m_stage == follow || m_stage == rest;
    if (!has_net || !m_newton || m_newton->multipliers().size() == 0) return std::nullopt;
    return RestState{{gradient_norm(), m_lack, motion_left()},
                     m_is_linearised,
                     *m_net,
                     m_result,
                     m_rest_energy,
                     m_gradient,
                     m_pulls,
                     m_constraints->system(),
                     m_newton->multipliers()};
}

std::unique_ptr<Method> make_equilibrium() { return std::make_unique<Equilibrium>(Equilibrium::RestShape::opened); }

constexpr std::array k_equilibrium_stages{"Finding a net", "To the handles", "To rest", "Opening corners"};
// The tolerances where a net is found by `projection`.
constexpr auto k_equilibrium_options =
    joined(k_tolerances, std::array{"shear_limit", "bending_weight", "shear_weight", "tip_weight", "straight_rods",
                                    "rod_curvature", "warp_stiffness", "weft_stiffness", "square_corners", "gravity",
                                    "guide_mode", "guide_weight", "rest_tolerance"});

}  // namespace

/// The net at rest: the least of a stated energy among all nets with exact lengths, exact handles and no corner of a
/// quad sharper than Options::shear_limit. Equal lengths leave the shear free (Li et al. 2022, figure 4); here bending
/// of net lines (BendingTerm), shear (ShearTerm), tips (TipTerm), soft handles (PullTerm) and weight (GravityTerm)
/// decide it, so that an edit has one answer, whatever the way to it, but for buckling: of several equilibria the one
/// is kept that the present shape leads to. The energy counts from the net's rest shape; where that is no net within
/// the limit, it is first made one, at rest without handles. Rods may also be straight or bent when free, and corners
/// square. In stages:
///
///   1  a net, by `projection`, if none is known near: where somebody else has moved the net, or stage 2 fails from the
///      last net and from the rest shape;
///   2  after handles have moved: in steps of an edge length at most, in which handles joined by edges turn together
///      (TurnedHandles), free vertices go on as in the step before, as far as the handles do, and follow the rest of
///      the handles' way as smoothly as the energy's bound allows; they are projected onto the lengths, and make one
///      step of stage 3. So a jump ends where a drag does. Where the way leads no farther, and where it is shorter for
///      handles that jump, it begins at the rest shape;
///   3  Newton steps for the energy among nets (TangentNewton), each turning the net where it turns (TurnedMove),
///      projected onto the lengths and out of corners that are too sharp (CornerLimit), until the gradient that the
///      constraints leave is below Options::rest_tolerance. Where they follow a valley, they are carried on along it
///      (PathExtrapolation). A flat net that would lose energy by bending out of its plane, towards which nothing
///      pushes it to first order, is not at rest: it leaves the plane.
///
/// Before all of them, as stage 4, the rest shape is opened where it has corners that are too sharp.
///
/// What slides is free, but for the coordinates that it keeps: these walk with the handles, and moves, Newton steps and
/// projections leave them alone. At rest no force is left along its axes. Stage 1 and a shape to begin with have it
/// stand.
///
/// From the end of stage 2 on every iteration ends in a net, and the energy falls, but while corners are being opened.
/// `converged` says that lengths, limit and rest are reached; `exact` that rest is not; `stalled` that the limit is not
/// either. Where no net is found it ends as `projection` does.
constinit const MethodInfo k_equilibrium = {
    "equilibrium",
    "The net at rest: bending and shear at their least under exact lengths and a limit of the corners.",
    "Gould, Hribar, Nocedal: On the Solution of Equality Constrained Quadratic Programming Problems Arising in "
    "Optimization. SIAM Journal on Scientific Computing 23(4), 2001",
    k_equilibrium_stages,
    k_equilibrium_options,
    in_this_build(make_equilibrium),
    true};

}  // namespace chebnet
