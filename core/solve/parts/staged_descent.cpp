#include "solve/parts/staged_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/stopwatch.h"
#include "net/measures.h"
#include "solve/parts/degenerate_edges.h"
#include "solve/parts/stopping.h"

namespace chebnet {

namespace {

constexpr double k_stage_decrease = 1e-4;  // of Armijo's rule
constexpr int k_stage_halvings = 40;
// A reduced iteration must bring max dL below this part of what it was. One with all vertices free brings it to about a
// ninth: the majorizer's step is 2/3 of what is needed, and dL is quadratic.
constexpr double k_reduced_progress = 0.5;

}  // namespace

StagedDescent::StagedDescent(MakeEnergy make_energy, std::unique_ptr<DescentDirection> direction, Adjust adjust)
    : m_make_energy(make_energy), m_direction(std::move(direction)), m_adjust(adjust) {}

void StagedDescent::prepare(const Problem& problem) {
    m_net = &problem.net;
    m_topology = &problem.topology;
    m_is_free = free_vertices(m_net->vertex_count(), problem.fixed);
    m_all = std::make_unique<FreePart>(*m_net, m_is_free);
    m_direction->prepare(*m_all);
}

Status StagedDescent::start(const Problem& problem, Positions& positions, const Options& options) {
    m_options = options;
    m_adjust(m_options);
    m_reachable = problem.reachable;
    m_reduction_allowed = m_options.adaptive_reduction;
    open_degenerate_edges(*m_net, *m_topology, m_is_free, positions);
    enter_stage(m_options.adaptive_p ? 1 : 2);
    measure(positions);
    if (m_max_deviation < m_options.threshold) return Status::converged;
    if (!std::isfinite(m_total_energy)) return Status::non_finite;
    return m_all->size() == 0 ? ended(m_reachable) : Status::running;
}

Status StagedDescent::iterate(Positions& positions, TraceRow& row) {
    choose_stage();
    measure(positions);  // the exponent may have changed
    const double energy_before = m_total_energy, deviation_before = m_max_deviation;
    const bool moved = step(positions, row);
    row.energy = m_total_energy;
    row.max_deviation = m_max_deviation;

    if (m_max_deviation < m_options.threshold) return Status::converged;
    if (!std::isfinite(row.gradient_norm)) return Status::non_finite;
    const double gradient_norm = row.gradient_norm / m_energy->relative_slope(m_options.threshold);
    if (!moved || has_settled(m_options, m_reachable, energy_before, m_total_energy, gradient_norm))
        return at_minimum();
    const bool is_slow = m_max_deviation > k_reduced_progress * deviation_before;
    if (m_stage == 3 && is_slow && !m_options.reduce_once) free_all_vertices();
    return Status::running;
}

/// One step of the free vertices, or in stage 3 of those near bad edges. False if none was found that lowers the
/// energy.
bool StagedDescent::step(Positions& positions, TraceRow& row) {
    Stopwatch watch;
    reduce_if_needed();
    const FreePart& part = m_stage == 3 ? *m_reduced : *m_all;
    const Eigen::Matrix3Xd slope = gradient(part, positions);
    row.stage = m_stage;
    row.p = m_p;
    row.free_vertices = part.size();
    row.gradient_norm = slope.norm() * m_net->mean_length();
    row.assembly_ms = watch.milliseconds();

    Eigen::Matrix3Xd direction;
    const bool found = m_direction->find({*m_net, part, *m_energy, positions, m_ratios, slope}, direction, row);

    watch.restart();
    if (found && direction.allFinite())
        row.step = search_line(part, positions, direction, slope.cwiseProduct(direction).sum());
    if (row.step > 0) m_direction->accepted(row.step);
    measure(positions);
    row.line_search_ms = watch.milliseconds();
    return row.step > 0;
}

/// In stage 3, chooses the vertices to move.
void StagedDescent::reduce_if_needed() {
    if (m_stage != 3 || (m_reduced && m_options.reduce_once)) return;
    m_reduced = std::make_unique<FreePart>(*m_net, vertices_near_bad_edges());
}

/// Stages only go forward within one solve.
void StagedDescent::choose_stage() {
    int stage = m_stage;
    if (stage == 1 && m_reachable && m_max_deviation < m_options.switch_deviation) stage = 2;
    if (stage == 2 && m_reduction_allowed && m_max_deviation < m_options.reduction_deviation) stage = 3;
    if (stage != m_stage) enter_stage(stage);
}

void StagedDescent::enter_stage(int stage) {
    m_stage = stage;
    m_p = stage == 1 ? m_options.p_start : m_options.p_end;
    m_energy = m_make_energy(m_p, m_options);
    m_reduced.reset();
    m_direction->restart();
}

/// The energy can fall no further with this stage's exponent and free vertices.
Status StagedDescent::at_minimum() {
    if (!m_reachable) return Status::unreachable;
    if (m_stage == 2 || (m_stage == 3 && m_options.reduce_once)) return Status::stalled;
    if (m_stage == 3)
        free_all_vertices();
    else
        enter_stage(2);
    return Status::running;
}

void StagedDescent::free_all_vertices() {
    m_reduction_allowed = false;
    enter_stage(2);
}

/// Section 3.3: the ends of edges with dL > ε_4 and their rings of neighbours.
std::vector<bool> StagedDescent::vertices_near_bad_edges() const {
    const double active_deviation = m_options.active_fraction * m_options.threshold;
    std::vector<bool> reached(m_is_free.size(), false);
    std::vector<int> front;
    const auto reach = [&](int v) {
        if (reached[v]) return;
        reached[v] = true;
        front.push_back(v);
    };
    for (int e = 0; e < m_net->edge_count(); ++e)
        if (deviation(m_ratios[e]) > active_deviation)
            for (int side = 0; side < 2; ++side) reach(m_net->edges()(side, e));
    for (int ring = 0; ring < m_options.active_rings; ++ring) {
        std::vector<int> previous;
        previous.swap(front);
        for (int v : previous)
            for (int n : m_topology->neighbours(v)) reach(n);
    }
    for (std::size_t v = 0; v < reached.size(); ++v) reached[v] = reached[v] && m_is_free[v];
    return reached;
}

/// Of the energy with respect to the part's vertices, 3×nodes.
Eigen::Matrix3Xd StagedDescent::gradient(const FreePart& part, const Positions& positions) const {
    Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, part.size());
    for (const FreePart::Edge& edge : part.edges()) {
        const double L = m_net->rest_lengths()[edge.index], r = m_ratios[edge.index];
        const Eigen::Vector3d u =
            (positions.col(m_net->edges()(0, edge.index)) - positions.col(m_net->edges()(1, edge.index))) / (r * L);
        const Eigen::Vector3d force = m_energy->slope(r) / L * u;
        if (edge.node_a >= 0) sum.col(edge.node_a) += force;
        if (edge.node_b >= 0) sum.col(edge.node_b) -= force;
    }
    return sum;
}

double StagedDescent::energy(const FreePart& part, const Positions& positions) const {
    double sum = 0;
    for (const FreePart::Edge& edge : part.edges()) {
        const auto difference =
            positions.col(m_net->edges()(0, edge.index)) - positions.col(m_net->edges()(1, edge.index));
        const double r = difference.norm() / m_net->rest_lengths()[edge.index];
        sum += r > 0 ? m_energy->value(r) : std::numeric_limits<double>::infinity();
    }
    return sum;
}

/// Armijo backtracking from the full step. Returns the step; 0 if none is accepted, and then the positions stay.
double StagedDescent::search_line(const FreePart& part, Positions& positions, const Eigen::Matrix3Xd& direction,
                                  double slope) const {
    const double before = energy(part, positions);
    const Positions origin = positions;
    double step = 1;
    for (int halving = 0; halving <= k_stage_halvings; ++halving, step /= 2) {
        for (int i = 0; i < part.size(); ++i) {
            const int v = part.vertices()[i];
            positions.col(v) = origin.col(v) + step * direction.col(i);
        }
        if (energy(part, positions) <= before + k_stage_decrease * step * slope) return step;
    }
    positions = origin;
    return 0;
}

/// Updates what is known of the present positions.
void StagedDescent::measure(const Positions& positions) {
    m_ratios = edge_ratios(*m_net, positions);
    m_max_deviation = max_deviation(m_ratios);
    m_total_energy = 0;
    for (const FreePart::Edge& edge : m_all->edges()) m_total_energy += m_energy->value(m_ratios[edge.index]);
}

}  // namespace chebnet
