#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/stopwatch.h"
#include "net/measures.h"
#include "solve/methods/methods.h"
#include "solve/parts/arap_step.h"
#include "solve/parts/degenerate_edges.h"
#include "solve/parts/held_vertices.h"
#include "solve/parts/laplacian_part.h"
#include "solve/parts/length_projection.h"
#include "solve/parts/option_names.h"
#include "solve/parts/spring_descent.h"
#include "solve/parts/stopping.h"

namespace chebnet {

namespace {

// Stage 1: at least as many iterations as keep up with a slow drag, at most as many as a cold start can use; one more
// for each edge length that a handle has jumped.
constexpr int k_least_rigid_iterations = 2, k_most_rigid_iterations = 8;
// Part of its way to the rigid shape that the net goes in each of them. Without it, the shear and the small folds that
// a drag has left on its path would never go away.
constexpr double k_forgetting = 0.05;
// Projection takes over below this max dL. Each time that it fails, the net is made smoother, to a part of this max dL:
// by the springs of stage 2, which go on where they were until they have made so many iterations, then by stage 4.
constexpr double k_projection_deviation = 1e-4;
constexpr double k_round_part = 0.01;
constexpr int k_most_spring_iterations = 150;
// Where pulls resist, they give way until they are no more than a part of an edge's strength, each time by this
// factor.
constexpr double k_yielding = 0.1;
constexpr double k_least_pull = 1e-4;
// Stage 3: this many projections must halve the smallest max dL so far.
constexpr int k_patience = 2;

// Of coordinates that come and go between units.
constexpr double k_rounding = 1e-14;

constexpr double k_unknown = std::numeric_limits<double>::infinity();

constexpr Heeds k_projection_heeds{.pulls = true, .slides = true};

class Projection : public Method {
public:
    void prepare(const Problem& problem) override;
    Heeds heeds() const override { return k_projection_heeds; }
    Status start(const Problem& problem, Positions& positions, const Options& options) override;
    Status iterate(Positions& positions, TraceRow& row) override;

private:
    enum Stage { rigid = 1, springs = 2, exact = 3, newton = 4 };

    Problem without_slides() const { return {*m_net, *m_topology, m_held.vertices(), m_pulls, m_reachable}; }
    void take_pulls(std::span<const Pull> pulls);
    int rigid_iterations(const Positions& positions) const;
    double largest_pull() const;
    bool is_drawn(const Positions& positions) const;
    void take_over_shape(const Positions& positions);
    double strongest_pull() const;
    bool can_yield() const { return strongest_pull() > k_least_pull; }
    void yield(const Positions& positions);
    bool has_lengths();
    void loosen_lengths();
    void enter(Stage stage, Positions& positions);
    Status move_rigidly(Positions& positions, TraceRow& row);
    Status relax_springs(Positions& positions, TraceRow& row);
    Status relax_by_newton(Positions& positions, TraceRow& row);
    bool is_near() const { return m_max_deviation < m_near; }
    Status project(Positions& positions, TraceRow& row);
    bool measure(const Positions& positions);
    void give_up_projecting(Positions& positions);

    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    HeldVertices m_held;
    std::vector<bool> m_is_free, m_is_loose;  // m_is_loose: free, and does not slide
    std::vector<Slide> m_slides;
    std::vector<Pull> m_pulls;
    std::unique_ptr<LaplacianPart> m_part;
    std::unique_ptr<ArapStep> m_arap;
    std::unique_ptr<SpringDescent> m_springs;
    std::unique_ptr<LengthProjection> m_lengths;  // for the net, whatever the handles
    bool m_lengths_too_large = false;
    std::unique_ptr<Method> m_newton;
    bool m_newton_prepared = false;
    double m_yield = 1;   // part of their weights with which the pulls act in stages 2 and 3
    double m_pulled = 0;  // how far the targets of pulls have moved since stage 1 has heeded them

    Options m_options;
    bool m_reachable = true;
    Stage m_stage = rigid;
    int m_left = 0;          // iterations of stage 1 or 3 at most
    int m_springs_left = 0;  // iterations of stage 2 in all
    double m_max_deviation = 0;
    int m_round = 0;    // of making the net smooth and projecting it
    double m_near = 0;  // max dL below which projection takes over in this round
    double m_best = 0;  // smallest max dL of this stage 3, counted in halvings
    Positions m_shape;  // the copy that ARAP moves; empty: it starts from the net
    Positions m_shape_before;
    Positions m_result;  // where the method last left the net
    Positions m_smooth;  // where stage 3 began
    double m_smooth_deviation = 0;
};

void Projection::prepare(const Problem& problem) {
    const Net& net = problem.net;
    if (m_net != &net) {
        m_lengths.reset();
        m_lengths_too_large = false;
    }
    m_net = &net;
    m_topology = &problem.topology;
    m_is_free = free_vertices(net.vertex_count(), problem.fixed);
    m_slides.assign(problem.slides.begin(), problem.slides.end());
    m_held = HeldVertices(net.vertex_count(), problem.fixed, problem.slides);
    m_is_loose = free_vertices(net.vertex_count(), m_held.vertices());
    m_part = std::make_unique<LaplacianPart>(net, m_is_free);
    m_arap = std::make_unique<ArapStep>(*m_part);
    m_springs = std::make_unique<SpringDescent>(*m_part, m_slides);
    m_newton = k_gauss_newton.make();
    m_newton_prepared = false;
    m_shape.resize(3, 0);
}

void Projection::take_pulls(std::span<const Pull> pulls) {
    const auto same = [](const Pull& a, const Pull& b) { return a.vertex == b.vertex && a.weight == b.weight; };
    const std::span<const Pull> before = m_pulls;
    if (!std::equal(before.begin(), before.end(), pulls.begin(), pulls.end(), same))
        m_pulled = k_unknown;
    else
        for (std::size_t i = 0; i < pulls.size(); ++i)
            m_pulled = std::max(m_pulled, (pulls[i].target - before[i].target).norm());
    m_pulls.assign(pulls.begin(), pulls.end());
}

Status Projection::start(const Problem& problem, Positions& positions, const Options& options) {
    take_pulls(problem.pulls);
    m_options = options;
    m_reachable = problem.reachable;
    open_degenerate_edges(*m_net, *m_topology, m_is_loose, positions);
    m_max_deviation = max_deviation(*m_net, positions);
    take_over_shape(positions);
    m_result = positions;
    if (m_max_deviation < options.threshold && (m_pulled == 0 || !is_drawn(positions))) return Status::converged;
    if (m_pulled == k_unknown) m_pulled = largest_pull();
    if (m_part->part().size() == 0) return ended(m_reachable);
    m_round = 0;
    m_near = k_projection_deviation;
    m_springs_left = k_most_spring_iterations;
    m_yield = 1;
    m_part->scale_pulls(1);
    m_part->set_pulls(m_pulls);
    enter(rigid, positions);
    return Status::running;
}

/// The copy goes on from where it was, unless the net was changed from outside meanwhile.
void Projection::take_over_shape(const Positions& positions) {
    bool moved = m_shape.cols() == 0;
    for (int v = 0; v < m_net->vertex_count() && !moved; ++v) moved = !m_held.stands_the_same(v, positions, m_result);
    if (moved) {
        m_shape = positions;
        m_shape_before = m_net->rest_positions();
    } else {
        m_shape_before = m_shape;
    }
    m_held.take_held(positions, m_shape);
}

double Projection::largest_pull() const {
    double largest = 0;
    for (const Pull& pull : m_pulls)
        largest = std::max(largest, (pull.target - m_shape_before.col(pull.vertex)).norm());
    return largest;
}

/// Whether a pull would have the net elsewhere, wherever the copy is.
bool Projection::is_drawn(const Positions& positions) const {
    return std::any_of(m_pulls.begin(), m_pulls.end(),
                       [&](const Pull& pull) { return !pull.target.isApprox(positions.col(pull.vertex), k_rounding); });
}

int Projection::rigid_iterations(const Positions& positions) const {
    const double jump = std::max(m_pulled, m_held.farthest(m_shape_before, positions));
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
            if (m_round == 0) m_springs->start(positions, m_shape);
            break;
        case exact:
            if (!has_lengths()) return enter(newton, positions);
            m_left = k_patience;
            m_smooth = positions;
            m_best = m_smooth_deviation = m_max_deviation;
            loosen_lengths();
            break;
        case newton:
            if (!m_newton_prepared) m_newton->prepare(without_slides());
            m_newton_prepared = true;
            m_newton->start(without_slides(), positions, m_options);
            break;
    }
}

double Projection::strongest_pull() const {
    double strongest = 0;
    for (const Pull& pull : m_part->pulls()) strongest = std::max(strongest, pull.weight);
    return strongest;
}

/// Lets the pulls weaken: what is left of them decides among nets with exact lengths, which is all they may.
void Projection::yield(const Positions& positions) {
    m_yield *= k_yielding / std::max(1.0, strongest_pull());
    m_part->scale_pulls(m_yield);
    m_springs_left = k_most_spring_iterations;
    m_springs->start(positions, m_shape);
}

/// Whether the net's lengths can be projected on: not where so many edges meet that their system would be too large.
bool Projection::has_lengths() {
    if (m_lengths || m_lengths_too_large) return !m_lengths_too_large;
    try {
        m_lengths = std::make_unique<LengthProjection>(*m_net, *m_topology);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        m_lengths_too_large = true;
    }
    return !m_lengths_too_large;
}

/// Moves of stage 3 are measured in the metric 1 + w, so that pulls give way last.
void Projection::loosen_lengths() {
    m_lengths->set_free(m_is_free, m_slides);
    for (const Pull& pull : m_part->pulls()) m_lengths->set_mobility(pull.vertex, 1 / (1 + pull.weight));
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
    m_held.take_held(m_shape_before, m_shape);
    row.energy = m_arap->energy(m_shape);
    row.step = 1;
    for (int v : m_part->part().vertices()) {
        const Eigen::Vector3d moved = positions.col(v) + m_shape.col(v) - m_shape_before.col(v);
        const Eigen::Vector3d nearer = moved + k_forgetting * (m_shape.col(v) - moved);
        m_held.take_free(v, nearer, positions);
    }
    const bool done = measure(positions);
    if (done && m_pulled == 0) return Status::converged;
    if (--m_left > 0) return Status::running;
    m_pulled = 0;
    if (done) return Status::converged;
    enter(springs, positions);
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
    const bool to_the_end = m_reachable && !can_yield();
    const bool settled = !moved || has_settled(m_options, to_the_end, energy_before, row.energy, row.gradient_norm);
    if (!m_reachable) return settled ? Status::unreachable : Status::running;
    const bool near = is_near();
    m_springs_left = settled ? 0 : m_springs_left - 1;
    if (m_springs_left == 0 && !near && can_yield())
        yield(positions);
    else if (m_springs_left == 0 || near)
        enter(exact, positions);
    return Status::running;
}

Status Projection::relax_by_newton(Positions& positions, TraceRow& row) {
    const Status status = m_newton->iterate(positions, row);
    m_max_deviation = row.max_deviation;
    if (status == Status::running && is_near() && m_lengths) enter(exact, positions);
    return status;
}

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
    m_near *= k_round_part;
    enter(m_springs_left > 0 ? springs : newton, positions);
}

std::unique_ptr<Method> make_projection() { return std::make_unique<Projection>(); }

constexpr std::array k_projection_stages{"Rigid start", "Springs", "Exact lengths", "Newton steps"};

}  // namespace

/// A good start, then exact lengths (our own; no paper has it as a whole). In stages:
///
///   1  ARAP iterations on a copy of the net that remembers its rest shape; the net takes over how the copy moves, and
///      goes a small part of its way to the copy, so that frame after frame of a drag bends it no more than one large
///      step would (Sorkine & Alexa 2007);
///   2  quasi-Newton descent on springs, smooth and cheap, until max dL is small (Liu et al. 2017, SpringDescent);
///   3  projection onto the lengths, which converges quadratically (Goldenthal et al. 2007, LengthProjection); where it
///      does not come closer, the net goes back and becomes smoother first, by stage 2, which goes on where it was, and
///      when that has had its share of iterations by
///   4  Gauss–Newton steps (gauss_newton), each as costly as one of the paper's, which go on to the end if need be.
///
/// What slides keeps its coordinates in all of them but the last, which holds it where it stands: stage 1 takes back
/// what the copy would change of them, stage 2 descends and stage 3 projects in the others.
///
/// Where so many edges meet at a vertex that the system of stage 3 would be too large, stage 4 takes its place at once.
///
/// Pulls act on the copy in stage 1, which so decides where their vertices are to be; the net's are drawn there by
/// springs of their own, which become weaker where lengths and pulls cannot agree, and give way last in stage 3.
/// Stage 4 ignores them.
///
/// Stages 1 to 3 use two systems of fixed pattern: the net's Laplacian, factored once for a set of handles and weights
/// of pulls, and the projection's, analysed once for a net. They allocate nothing once they have run.
constinit const MethodInfo k_projection = {
    "projection",
    "A rigid start, springs, then projection onto the exact lengths: our own way to go fast and bend little.",
    "Sorkine, Alexa 2007; Liu, Bouaziz, Kavan 2017; Goldenthal, Harmon, Fattal, Bercovier, Grinspun: Efficient "
    "Simulation of Inextensible Cloth. ACM Transactions on Graphics 26(3), 2007",
    k_projection_stages,
    k_tolerances,
    in_this_build(make_projection),
    k_projection_heeds};

}  // namespace chebnet
