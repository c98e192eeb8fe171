#include "solve/projection.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "net/measures.h"
#include "solve/arap.h"
#include "solve/degenerate_edges.h"
#include "solve/gauss_newton.h"
#include "solve/laplacian_part.h"
#include "solve/length_projection.h"
#include "solve/spring_descent.h"
#include "solve/stopping.h"
#include "solve/stopwatch.h"

namespace chebnet {

namespace {

// Stage 1: at least as many iterations as keep up with a slow drag, at most as many as a cold start can use; one more
// for each edge length that a handle has jumped.
constexpr int k_least_rigid_iterations = 2, k_most_rigid_iterations = 8;
// Part of its way to the rigid shape that the net goes in each of them. Without it, the shear and the small folds that
// a drag has left on its way would stay for ever.
constexpr double k_forgetting = 0.05;
// Projection takes over below this max dL. Each time that it fails, the net is made smoother, to a part of this max dL:
// by the springs of stage 2, which go on where they were until they have made so many iterations, then by stage 4.
constexpr double k_projection_deviation = 1e-4;
constexpr double k_round_part = 0.01;
constexpr int k_most_spring_iterations = 150;
// Stage 3: this many projections must halve the smallest max dL so far.
constexpr int k_patience = 2;

class Projection : public Method {
public:
    void prepare(const Net& net, const Topology& topology, std::span<const int> handle_vertices) override;
    Status start(Positions& positions, const Options& options, bool reachable) override;
    Status iterate(Positions& positions, TraceRow& row) override;

private:
    enum Stage { rigid = 1, springs = 2, exact = 3, newton = 4 };

    int rigid_iterations(const Positions& positions) const;
    void take_over_shape(const Positions& positions);
    void enter(Stage stage, Positions& positions);
    Status move_rigidly(Positions& positions, TraceRow& row);
    Status relax_springs(Positions& positions, TraceRow& row);
    Status relax_by_newton(Positions& positions, TraceRow& row);
    bool is_near() const;
    Status project(Positions& positions, TraceRow& row);
    bool measure(const Positions& positions);
    void give_up_projecting(Positions& positions);

    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    std::vector<int> m_handles;
    std::vector<bool> m_is_free;
    std::unique_ptr<LaplacianPart> m_part;
    std::unique_ptr<ArapStep> m_arap;
    std::unique_ptr<SpringDescent> m_springs;
    std::unique_ptr<LengthProjection> m_lengths;  // for the net, whatever the handles
    std::unique_ptr<Method> m_newton;
    bool m_newton_prepared = false;

    Options m_options;
    bool m_reachable = true;
    Stage m_stage = rigid;
    int m_left = 0;          // iterations of stage 1 or 3 at most
    int m_springs_left = 0;  // iterations of stage 2 in all
    double m_max_deviation = 0;
    int m_round = 0;    // of making the net smooth and projecting it
    double m_best = 0;  // smallest max dL of this stage 3, counted in halvings
    Positions m_shape;  // the copy that ARAP moves; empty: it starts from the net
    Positions m_shape_before;
    Positions m_result;  // where the method last left the net
    Positions m_smooth;  // where stage 3 began
    double m_smooth_deviation = 0;
};

void Projection::prepare(const Net& net, const Topology& topology, std::span<const int> handle_vertices) {
    if (m_net != &net) m_lengths.reset();
    m_net = &net;
    m_topology = &topology;
    m_handles.assign(handle_vertices.begin(), handle_vertices.end());
    m_is_free = free_vertices(net.vertex_count(), handle_vertices);
    m_part = std::make_unique<LaplacianPart>(net, m_is_free);
    m_arap = std::make_unique<ArapStep>(*m_part);
    m_springs = std::make_unique<SpringDescent>(*m_part);
    if (m_lengths) m_lengths->set_free(m_is_free);
    m_newton = make_gauss_newton();
    m_newton_prepared = false;
    m_shape.resize(3, 0);
}

Status Projection::start(Positions& positions, const Options& options, bool reachable) {
    m_options = options;
    m_reachable = reachable;
    open_degenerate_edges(*m_net, *m_topology, m_is_free, positions);
    m_max_deviation = max_deviation(*m_net, positions);
    take_over_shape(positions);
    m_result = positions;
    if (m_max_deviation < options.threshold) return Status::converged;
    if (!std::isfinite(m_max_deviation)) return Status::non_finite;
    if (m_part->part().size() == 0) return ended(reachable);
    m_round = 0;
    m_springs_left = k_most_spring_iterations;
    enter(rigid, positions);
    return Status::running;
}

/// The copy goes on from where it was, unless somebody else has moved the net meanwhile.
void Projection::take_over_shape(const Positions& positions) {
    bool moved = m_shape.cols() == 0;
    for (int v = 0; v < m_net->vertex_count() && !moved; ++v)
        moved = m_is_free[v] && positions.col(v) != m_result.col(v);
    if (moved) {
        m_shape = positions;
        m_shape_before = m_net->rest_positions();
    } else {
        m_shape_before = m_shape;
    }
    for (int v : m_handles) m_shape.col(v) = positions.col(v);
}

int Projection::rigid_iterations(const Positions& positions) const {
    double jump = 0;
    for (int v : m_handles) jump = std::max(jump, (positions.col(v) - m_shape_before.col(v)).norm());
    const double iterations = k_least_rigid_iterations + std::floor(jump / m_net->mean_length());
    return static_cast<int>(std::min<double>(iterations, k_most_rigid_iterations));
}

void Projection::enter(Stage stage, Positions& positions) {
    m_stage = stage;
    switch (stage) {
        case rigid:
            m_left = rigid_iterations(positions);
            break;
        case springs:
            if (m_round == 0) m_springs->start(positions);
            break;
        case exact:
            m_left = k_patience;
            m_smooth = positions;
            m_best = m_smooth_deviation = m_max_deviation;
            if (!m_lengths) {
                m_lengths = std::make_unique<LengthProjection>(*m_net, *m_topology);
                m_lengths->set_free(m_is_free);
            }
            break;
        case newton:
            if (!m_newton_prepared) m_newton->prepare(*m_net, *m_topology, m_handles);
            m_newton_prepared = true;
            m_newton->start(positions, m_options, m_reachable);
            break;
    }
}

Status Projection::iterate(Positions& positions, TraceRow& row) {
    Status status = Status::running;
    const Stage stage = m_stage;
    if (stage == newton) {
        status = relax_by_newton(positions, row);
    } else {
        Stopwatch watch;
        row.free_vertices = m_part->part().size();
        if (stage == rigid) status = move_rigidly(positions, row);
        if (stage == springs) status = relax_springs(positions, row);
        if (stage == exact) status = project(positions, row);
        row.max_deviation = m_max_deviation;
        row.assembly_ms = watch.milliseconds() - row.factorisation_ms;
    }
    row.stage = stage;
    m_result = positions;
    return status;
}

Status Projection::move_rigidly(Positions& positions, TraceRow& row) {
    m_shape_before = m_shape;
    m_arap->iterate(m_shape);
    row.energy = m_arap->energy(m_shape);
    row.step = 1;
    for (int v : m_part->part().vertices()) {
        const Eigen::Vector3d moved = positions.col(v) + m_shape.col(v) - m_shape_before.col(v);
        positions.col(v) = moved + k_forgetting * (m_shape.col(v) - moved);
    }
    if (measure(positions)) return Status::converged;
    if (--m_left == 0) enter(springs, positions);
    return Status::running;
}

Status Projection::relax_springs(Positions& positions, TraceRow& row) {
    const double unit = m_net->mean_length();
    const double energy_before = m_springs->energy() / (unit * unit);
    row.gradient_norm = m_springs->gradient_norm() / unit;
    const bool moved = m_springs->iterate(positions);
    row.energy = m_springs->energy() / (unit * unit);
    row.step = m_springs->step();
    if (measure(positions)) return Status::converged;
    const bool settled = !moved || has_settled(m_options, m_reachable, energy_before, row.energy, row.gradient_norm);
    if (!m_reachable) return settled ? Status::unreachable : Status::running;
    m_springs_left = settled ? 0 : m_springs_left - 1;
    if (m_springs_left == 0 || is_near()) enter(exact, positions);
    return Status::running;
}

Status Projection::relax_by_newton(Positions& positions, TraceRow& row) {
    const Status status = m_newton->iterate(positions, row);
    m_max_deviation = row.max_deviation;
    if (status == Status::running && is_near()) enter(exact, positions);
    return status;
}

/// Whether projection may take over.
bool Projection::is_near() const { return m_max_deviation < k_projection_deviation * std::pow(k_round_part, m_round); }

Status Projection::project(Positions& positions, TraceRow& row) {
    const bool solved = m_lengths->project(positions);
    row.energy = m_lengths->squared_error();
    row.factorisation_ms = m_lengths->factorisation_ms();
    row.step = solved ? 1 : 0;
    if (measure(positions)) return Status::converged;
    if (m_max_deviation < m_best / 2) {
        m_best = m_max_deviation;
        m_left = k_patience;
    } else {
        --m_left;
    }
    if (!solved || !std::isfinite(m_max_deviation) || m_left == 0) give_up_projecting(positions);
    return Status::running;
}

/// Whether the net is good enough.
bool Projection::measure(const Positions& positions) {
    m_max_deviation = max_deviation(*m_net, positions);
    return m_max_deviation < m_options.threshold;
}

void Projection::give_up_projecting(Positions& positions) {
    positions = m_smooth;
    m_max_deviation = m_smooth_deviation;
    ++m_round;
    enter(m_springs_left > 0 ? springs : newton, positions);
}

}  // namespace

std::unique_ptr<Method> make_projection() { return std::make_unique<Projection>(); }

}  // namespace chebnet
