#include "solve/parts/rest_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/stopwatch.h"
#include "linear/dense_kernels.h"
#include "linear/ordered_dot.h"
#include "net/measures.h"
#include "solve/parts/bow.h"

namespace chebnet {

namespace {

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
constexpr double k_least_decrease = 1e-4;  // of Armijo's rule
constexpr int k_most_shortenings = 8;
// How often corners may join those that are held, or leave them, in one step.
constexpr int k_most_joins = 6, k_most_rounds = 4;
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
// Of a force, the part along a move that is more than rounding.
constexpr double k_rising = 1e-6;
// By how far a net has moved while a step took off this part of the force, it is told how far it has to go.
constexpr double k_telling = 0.1;
// The most dL of a net that a solve ends with short of rest.
constexpr double k_end_deviation = 1e-12;
constexpr int k_most_refinements = 20, k_most_beginnings = 4;
// Of the bow that a flat net gets which is at rest in its plane alone, in edge lengths.
constexpr double k_first_bow = 1;
constexpr int k_most_bows = 6, k_most_loads = 20;  // that are tried
// A net has given way nowhere with less energy of bending than this.
constexpr double k_unbent = 1e-9;

/// V, what lies in pieces of a net without anything held, sliding or pulled. Empty where that is all of it.
std::vector<bool> loose_vertices(const Topology& topology, const std::vector<bool>& is_free,
                                 std::span<const Slide> slides, std::span<const Pull> pulls) {
    std::vector<bool> holds(is_free.size());
    for (std::size_t v = 0; v < holds.size(); ++v) holds[v] = !is_free[v];
    for (const Slide& slide : slides) holds[slide.vertex] = true;
    for (const Pull& pull : pulls) holds[pull.vertex] = true;
    std::vector<bool> is_loose = topology.in_pieces_without(holds);
    if (std::find(is_loose.begin(), is_loose.end(), false) == is_loose.end()) is_loose.clear();
    return is_loose;
}

}  // namespace

void RestDescent::set_net(const Net& net, const Topology& topology) {
    m_net = &net;
    m_topology = &topology;
    m_constraints.reset();
    m_rest_energy.forget();
}

void RestDescent::forget_handles() {
    m_newton.reset();
    m_has_metric = m_is_still = m_is_linearised = false;
}

bool RestDescent::has_energy_of(const Options& options) const {
    return m_rest_energy.is_chosen() && RestEnergy::is_the_same(m_options, options);
}

void RestDescent::choose_energy(const Positions& rest_shape, const Options& options, std::span<const Pull> pulls,
                                const Guide* guide, double unit, const std::vector<bool>& weightless,
                                RestEnergy::Limit is, CornerLimit limit) {
    m_rest_energy.choose(*m_net, *m_topology, rest_shape, options, pulls, guide, unit, weightless, is);
    m_is_guided = RestEnergy::is_guided(options, guide);
    m_limit = is == RestEnergy::Limit::is_kept ? std::move(limit) : CornerLimit();
    m_constraints.reset();
    m_has_metric = false;
}

void RestDescent::prepare(const FreePart& part, const std::vector<bool>& is_free, std::span<const Slide> slides,
                          std::span<const Pull> pulls, const Positions& positions) {
    take_pulls(pulls);
    if (!m_newton) {
        m_newton = std::make_unique<TangentNewton>(*m_net, *m_topology, part, slides);
        m_is_loose = loose_vertices(*m_topology, is_free, slides, pulls);
    }
    m_newton->find_free_motions(m_is_guided, pulls, m_options);
    if (!m_constraints)
        m_constraints =
            std::make_unique<NetConstraints>(*m_net, *m_topology, m_limit, is_free, slides, pulls, positions);
    if (!m_has_metric) m_newton->set_metric(m_rest_energy.terms());
    m_has_metric = true;
    m_constraints->set_free(is_free, slides, pulls);
}

void RestDescent::add_bow(const Positions& positions, Eigen::Matrix3Xd& moves) {
    const auto normal = normal_of_flat(*m_net, positions, up_axis(m_options));
    if (!normal) return;
    Eigen::Matrix3Xd bow;
    give_way_to(*normal, bow);
    moves += part_of_bow(*m_net, positions, moves, bow, rises_along(positions, bow)) * bow;
}

/// How what is free gives way to an even load, by the energy's bound; pieces that nothing holds would fly off, and bear
/// none.
void RestDescent::give_way_to(const Eigen::Vector3d& load, Eigen::Matrix3Xd& moves) const {
    Eigen::Matrix3Xd loads(3, m_net->vertex_count());
    loads.colwise() = load;
    for (std::size_t v = 0; v < m_is_loose.size(); ++v)
        if (m_is_loose[v]) loads.col(static_cast<Eigen::Index>(v)).setZero();
    m_newton->give_way(loads, moves);
}

/// Whether the energy rises along a move from there, by more than rounding tells.
bool RestDescent::rises_along(const Positions& positions, const Eigen::Matrix3Xd& move) {
    m_rest_energy.evaluate(positions, m_next_gradient);
    const double slope = ordered_dot(m_next_gradient, move),
                 force = std::sqrt(ordered_dot(m_next_gradient, m_next_gradient));
    return slope > std::max(k_no_force / m_net->mean_length(), k_rising * force) * std::sqrt(ordered_dot(move, move));
}

bool RestDescent::project(Positions& positions) {
    const std::vector<double> held = m_constraints->held();
    if (project(positions, m_options.threshold)) return true;
    m_constraints->hold(held);
    return false;
}

/// The system of lengths is another one then, or one for other positions.
bool RestDescent::project(Positions& positions, double threshold) {
    m_is_linearised = false;
    return m_constraints->project(positions, threshold);
}

void RestDescent::begin_solve(bool is_as_left) {
    m_pulls_are_known = is_as_left;
    m_steps = 0;
    m_has_given_way = false;
    m_beginnings = 0;
    if (m_newton) m_newton->find_whole_tension(false);
    if (m_constraints) m_constraints->set_patient(false);
}

void RestDescent::enter(const Positions& positions) {
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

Status RestDescent::relax(Positions& positions, TraceRow& row) {
    if (m_pulls_walk) return follow_pulls(positions, row);
    if (m_steps == 0) give_way(positions);
    const Status status = step_to_rest(positions, row);
    if (status != Status::running && give_way(positions)) return Status::running;
    return status == Status::exact && goes_on_beside_taut_lines(positions) ? Status::running : status;
}

/// Where a net would end short of rest: from now on lines that are nearly straight have all of their tension, and
/// lengths are come to however slowly, since what hard pulled edges lack hides what a step gains. It begins anew from
/// the exact lengths, as often as steps have left them. False if that leads no farther.
bool RestDescent::goes_on_beside_taut_lines(Positions& positions) {
    const bool is_new = m_beginnings == 0, has_left_lengths = m_max_deviation >= k_end_deviation;
    m_newton->find_whole_tension(true);
    m_constraints->set_patient(true);
    refine_lengths(positions);
    if (!is_new && (!has_left_lengths || m_beginnings == k_most_beginnings)) return false;
    ++m_beginnings;
    m_radius = k_most_move * m_net->mean_length();
    m_is_careful = false;
    m_idle_steps = 0;
    return linearise(positions);
}

Status RestDescent::step_to_rest(Positions& positions, TraceRow& row) {
    if (!m_is_linearised && !linearise(positions)) return stuck();
    if (is_at_rest()) return Status::converged;
    const double energy = m_energy;
    take_step(positions, row);
    if (m_pulls_walk) return Status::running;
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
bool RestDescent::is_idle(double energy_before, double force_before) {
    const bool gains = m_lack > CornerLimit::k_tolerance || gradient_norm() < k_idle_force * force_before ||
                       m_energy < energy_before - k_idle_part * std::abs(energy_before);
    m_idle_steps = gains ? 0 : m_idle_steps + 1;
    return m_idle_steps == k_most_idle_steps;
}

/// A descent follows a valley of the energy whose floor is bent, in steps that leave it and come back by turns; those
/// that came back, with less of a gradient, lie on the floor. From the last of them along it, twice as far each time,
/// while the energy falls. False if there the net cannot be linearised.
bool RestDescent::follow_path(Positions& positions) {
    if (m_steps < k_steps_of_a_path || !m_path.is_known() || m_lack > CornerLimit::k_tolerance) return true;
    std::vector<double> held = m_constraints->held();
    double least = m_energy + m_newton->error_cost();
    bool leads_on = false;
    for (double t = 1;; t *= 2) {
        m_path.go(t, m_origin);
        if (m_path.farthest(m_origin) > k_most_along_path * m_net->mean_length() ||
            !project(m_origin, m_options.threshold))
            break;
        const double energy = m_rest_energy.evaluate(m_origin, m_next_gradient) + error_cost();
        if (!(energy < least)) break;
        least = energy;
        leads_on = true;
        m_farthest = m_origin;
        held = m_constraints->held();
    }
    m_constraints->hold(held);
    if (leads_on) {
        positions = m_farthest;
        m_is_still = false;
    } else {
        m_path.clear();
    }
    m_energy = m_rest_energy.evaluate(positions, m_gradient);
    m_max_deviation = max_deviation(*m_net, positions);
    return linearise(positions);
}

/// One Newton step, within the trust region that the steps before have left.
void RestDescent::take_step(Positions& positions, TraceRow& row) {
    if (m_pulls_wait) begin_pull_walk(positions);
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
        m_radius /= 1 << k_most_shortenings;
    else if (row.step < whole)
        m_radius = moved;
    else if (was_cut)
        m_radius = std::min(2 * m_radius, k_most_move * L);
    m_is_still = !was_cut && moved < k_still * L;
    m_moved = moved / L;
    m_max_deviation = max_deviation(*m_net, positions);
}

void RestDescent::renew_factor(TraceRow& row) {
    if (m_steps == 1 || m_newton->inner_iterations() > k_old_factor_iterations) m_newton->put_factor_away();
    if (m_steps == 2 && m_newton->take_last_factor()) return;
    if (m_steps <= k_cheap_steps || m_newton->uses_factor()) return;
    m_newton->factorize(m_rest_energy.terms());
    row.factorisation_ms = m_newton->factorisation_ms();
}

/// A move that corners near their limit allow as a whole: those that would come beyond it are brought to it and no
/// farther. While handles may still be moving, what they leave of the first move is good enough. Returns its slope;
/// with 0 none may have been found.
double RestDescent::find_move_beside_corners(const Positions& positions) {
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
double RestDescent::find_move() {
    if (m_steps > 1) {
        const double slope = m_newton->find_move(m_rest_energy.terms(), Curvature::exact, inner_iterations(),
                                                 k_inner_tolerance, m_radius, m_direction);
        if (!m_newton->met_negative_curvature()) return slope;
    }
    return m_newton->find_move(m_rest_energy.terms(), Curvature::convex, inner_iterations(), k_inner_tolerance,
                               m_radius, m_direction);
}

/// The same from m_direction, which was found with fewer corners held; anew where it was cut short.
double RestDescent::improve_move() {
    if (m_newton->ended_at_radius() || m_newton->met_negative_curvature()) return find_move();
    const int inner = m_newton->uses_factor() ? k_most_iterations_with_factor : k_least_inner_iterations;
    const double slope = m_newton->improve_move(m_rest_energy.terms(), Curvature::exact, inner, m_radius, m_direction);
    return m_newton->met_negative_curvature() ? find_move() : slope;
}

int RestDescent::inner_iterations() const {
    return m_newton->uses_factor() ? k_most_iterations_with_factor
                                   : std::min(k_most_inner_iterations, k_least_inner_iterations * m_steps);
}

/// Armijo backtracking from m_origin along this part of m_direction, turning where the net turns, with a projection
/// onto the lengths after each trial. Returns the part of the direction that was accepted; 0: none, and the positions
/// stay.
double RestDescent::step_along(Positions& positions, double slope, double whole) {
    const bool opens = m_lack > CornerLimit::k_tolerance;  // which costs energy
    const std::vector<double> held = m_constraints->held();
    const double before = m_energy + m_newton->error_cost();
    double step = whole;
    m_newton->begin_way(m_origin, m_direction);
    for (int trial = 0; (slope < 0 || opens) && trial <= k_most_shortenings; ++trial, step /= 2) {
        m_constraints->hold_closer(held, step);
        m_newton->go(step, positions);
        if (!project(positions, m_options.threshold)) continue;
        const double energy = m_rest_energy.evaluate(positions, m_next_gradient);
        if (!opens && !(energy + error_cost() <= before + k_least_decrease * step * slope)) continue;
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
double RestDescent::error_cost() {
    const Eigen::VectorXd& errors = m_constraints->lengths().system().errors();
    return dense::dot(m_newton->multipliers().data(), errors.data(), m_net->edge_count());
}

/// With the rows of corners that push.
bool RestDescent::linearise(const Positions& positions) {
    m_lack = m_constraints->lack(positions);
    m_is_linearised = m_newton->linearise(positions, m_gradient, m_constraints->lengths());
    for (int round = 0; m_is_linearised && round < k_most_rounds; ++round) {
        if (!m_constraints->release(m_newton->multipliers(), m_is_careful)) break;
        m_is_linearised = m_newton->linearise(positions, m_gradient, m_constraints->lengths());
    }
    return m_is_linearised;
}

/// A net that is pressed as it stands, flat or with straight lines, is without a force that would bend it, however hard
/// it is pressed. Where it would lose energy by bending it is given a first bow. False if it stays.
bool RestDescent::give_way(Positions& positions) {
    if (m_has_given_way || !m_is_linearised) return false;
    const auto normal = normal_of_flat(*m_net, positions, up_axis(m_options));
    Eigen::Matrix3Xd bow;
    if (!(normal ? find_bow(*normal, bow)
                 : m_steps > 0 && m_rest_energy.values().front() < k_unbent &&
                       m_newton->find_buckling(m_rest_energy.terms(), k_most_loads, bow)))
        return false;
    m_has_given_way = true;
    if (normal && normal->dot(bow.rowwise().sum()) < 0) bow = -bow;
    const double side = normal && rises_along(positions, bow) ? -1 : 1;
    const double height = side * k_first_bow * m_net->mean_length();
    Positions bent = positions + height / bow.colwise().norm().maxCoeff() * bow;
    if (!project(bent)) {
        linearise(positions);
        return false;
    }
    positions = bent;
    enter(positions);
    return true;
}

/// Out of the plane of a flat net, which takes nothing from lengths to first order.
bool RestDescent::find_bow(const Eigen::Vector3d& normal, Eigen::Matrix3Xd& bow) {
    give_way_to(normal, bow);
    return m_newton->find_negative_curvature(m_rest_energy.terms(), k_most_bows, bow);
}

/// Where a net is nearly taut lengths are come to slowly, and a step ends as near to them as the threshold asks for.
/// Those of a net that stays are to be nearer.
void RestDescent::refine_lengths(Positions& positions) {
    for (int round = 0; round < k_most_refinements && m_max_deviation >= k_end_deviation; ++round) {
        Positions x = positions;
        project(x, k_end_deviation);
        const double deviation = max_deviation(*m_net, x);
        if (!(deviation < m_max_deviation) || m_constraints->lack(x) > CornerLimit::k_kept) break;
        positions = x;
        m_max_deviation = deviation;
    }
    if (m_is_linearised) return;
    m_energy = m_rest_energy.evaluate(positions, m_gradient);
    linearise(positions);
}

/// Per unit of length.
double RestDescent::gradient_norm() const { return m_newton->gradient_norm() * m_net->mean_length(); }

/// A net without a force but of what keeps it one: corners that are held before they come to their limit do not.
bool RestDescent::is_balanced() const {
    return m_is_linearised && is_net() && gradient_norm() < m_options.rest_tolerance &&
           m_constraints->excess().maxCoeff() <= CornerLimit::k_tolerance;
}

/// With exact lengths, and no corner beyond the limit.
bool RestDescent::is_net() const { return m_max_deviation < m_options.threshold && m_lack <= CornerLimit::k_kept; }

/// The end of a way to rest that leads no farther.
Status RestDescent::stuck() const { return is_net() ? Status::exact : Status::stalled; }

/// As far again as the last step went, by what it left of the gradient over what it took off. One that took off next to
/// nothing says nothing.
double RestDescent::motion_left() const {
    const double left = gradient_norm(), taken = m_gradient_before - left;
    if (left < k_no_force) return 0;
    return m_is_linearised && taken > k_telling * m_gradient_before ? m_moved * left / taken
                                                                    : std::numeric_limits<double>::infinity();
}

Status RestDescent::end_at(const Positions& positions) {
    m_lack = m_constraints->lack(positions);
    m_max_deviation = max_deviation(*m_net, positions);
    return stuck();
}

std::optional<RestState> RestDescent::state(const Positions& positions, std::span<const Pull> pulls) const {
    if (!is_prepared() || m_newton->multipliers().size() == 0) return std::nullopt;
    return RestState{{gradient_norm(), m_lack, motion_left()},
                     m_is_linearised,
                     *m_net,
                     positions,
                     m_rest_energy,
                     m_gradient,
                     m_pulls_walk ? pulls_on_their_way() : pulls,
                     m_constraints->system(),
                     m_newton->multipliers()};
}

}  // namespace chebnet
