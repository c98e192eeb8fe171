#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "net/measures.h"
#include "solve/methods/methods.h"
#include "solve/parts/corner_limit.h"
#include "solve/parts/handle_walk.h"
#include "solve/parts/option_names.h"
#include "solve/parts/rest_descent.h"
#include "solve/parts/rest_energy.h"
#include "solve/parts/rest_shape.h"

namespace chebnet {

namespace {

// Tries of a step of the walk, at once or in shorter ones.
constexpr int k_most_trials = 8;
// The limit aims a little higher than it has to be, so that it is met in spite of its tolerance.
constexpr double k_limit_margin = 0.02 * k_degree;
// A net with less energy than this lies as its rest shape does.
constexpr double k_no_energy = 1e-6;
// The most dL of a net that stands as it is held.
constexpr double k_held_deviation = 1e-12;

constexpr Heeds k_equilibrium_heeds{.pulls = true, .slides = true, .only_nets = true};

class Equilibrium : public Method {
public:
    /// `opener`: of the rest shape, which costs no energy; null: it costs none as it is.
    explicit Equilibrium(MakeMethod opener) : m_rest_shape(opener) {}
    void prepare(const Problem& problem) override;
    Heeds heeds() const override { return k_equilibrium_heeds; }
    Status start(const Problem& problem, Positions& positions, const Options& options) override;
    Status iterate(Positions& positions, TraceRow& row) override;
    std::optional<RestState> rest_state() const override;

private:
    enum Stage { net = 1, follow = 2, rest = 3, open = 4 };

    Method& projection();
    void find_loose_pieces();
    Problem problem() const { return {*m_net, *m_topology, m_walk.held().vertices(), m_pulls, m_reachable}; }
    void take_pulls(std::span<const Pull> pulls);
    bool take_guide(const Problem& problem, const Options& options);
    CornerLimit limit() const;
    void begin_opening(Positions& positions);
    Status open_rest_shape(Positions& positions, TraceRow& row);
    Status begin(Positions& positions, bool same_energy);
    bool is_held_as_net() const;
    Status without_rest(const Positions& positions) const;
    std::vector<bool> weightless() const;
    bool prepare_energy(const Positions& positions, bool same_energy);
    void begin_as_net(const Positions& positions);
    bool has_come_home(const Positions& positions);
    void note_home();
    void begin_walk_home();
    Stage first_stage(const Positions& positions);
    bool was_left(const Positions& before, const Positions& positions) const;
    Status find_net(Positions& positions, TraceRow& row);
    Status begin_rest(Status of_projection, Positions& positions);
    Status follow_handles(Positions& positions, TraceRow& row);
    void walk(double part, Positions& x);
    bool move_handles(double part, Positions& x);
    Status find_another_net(Positions& positions);
    bool begin_at_rest_shape(double nearer_than);
    void enter_rest(const Positions& positions);
    Status relax(Positions& positions, TraceRow& row);

    const Net* m_net = nullptr;
    const Topology* m_topology = nullptr;
    std::vector<bool> m_is_free;
    std::vector<Slide> m_slides;
    std::vector<Pull> m_pulls;
    std::vector<std::vector<int>> m_loose_pieces;       // of the net, in which nothing is held
    bool m_pulls_changed = true, m_pulls_moved = true;  // in number, place or weight; in their targets
    std::shared_ptr<const Guide> m_guide;
    double m_unit = 1;  // in that of the guide and of the options' lengths
    RestShape m_rest_shape;
    std::unique_ptr<FreePart> m_part;
    std::unique_ptr<Method> m_projection;
    RestDescent m_descent;
    HandleWalk m_walk;  // stage 2

    Options m_options;
    bool m_reachable = true, m_only_nets = false, m_only_walks = false;
    bool m_goes_home = false;     // though it is a net where it was left
    bool m_rests_at_home = true;  // where a hand last took the net with all handles at home: whether in its rest shape
    Positions m_asked;            // where the solve began, while the rest shape is being opened
    Positions m_last_net;         // of the problem, which need not last as long as a solve; empty: not known
    Stage m_stage = net;
    Positions m_result;           // where the method last left the net; empty: nowhere
    bool m_began_as_net = false;  // this solve, or the walk home, which walk to another one all the same
    Positions m_begun;            // if so
    bool m_was_placed = false;    // the rest shape, in this solve: a walk has begun there
    Positions m_stuck_at;         // where a walk before that ended early; empty: none did
    RestEnergy::Limit m_limit_is = RestEnergy::Limit::is_kept;
    double m_max_deviation = 0;  // of what iterate() has left
};

void Equilibrium::prepare(const Problem& problem) {
    const Net& of = problem.net;
    if (m_net != &of) {
        m_descent.set_net(of, problem.topology);
        m_result.resize(3, 0);
        m_rests_at_home = true;
        m_rest_shape.forget();
    }
    m_net = &of;
    m_topology = &problem.topology;
    m_is_free = free_vertices(of.vertex_count(), problem.fixed);
    m_slides.assign(problem.slides.begin(), problem.slides.end());
    m_pulls_changed |= m_options.gravity > 0;  // the net may hang by other vertices, or by none
    m_walk.set_handles(HeldVertices(of.vertex_count(), problem.fixed, problem.slides), problem.topology);
    m_walk.forget_moves(of.vertex_count());
    m_part = std::make_unique<FreePart>(of, m_is_free);
    find_loose_pieces();
    m_projection.reset();
    m_descent.forget_handles();
}

void Equilibrium::find_loose_pieces() {
    std::vector<bool> has_hold(m_is_free.size());
    for (std::size_t v = 0; v < has_hold.size(); ++v) has_hold[v] = !m_is_free[v];
    for (const Slide& slide : m_slides) has_hold[slide.vertex] = true;
    const std::vector<bool> is_loose = m_topology->in_pieces_without(has_hold);
    m_loose_pieces.clear();
    for (std::vector<int>& piece : m_topology->components())
        if (is_loose[piece.front()]) m_loose_pieces.push_back(std::move(piece));
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
    // Whether it has to be opened, and how exactly that is done, depends on both.
    const bool same_rest_shape =
        m_options.shear_limit == options.shear_limit && m_options.threshold == options.threshold;
    const auto limit_is = problem.limit_gives_way ? RestEnergy::Limit::gives_way : RestEnergy::Limit::is_kept;
    const bool same_energy =
        same_guide && same_rest_shape && !m_pulls_changed && m_limit_is == limit_is && m_descent.has_energy_of(options);
    if (!same_energy)
        m_descent.forget_energy();  // also where handles out of reach keep this solve from choosing another
    if (!same_rest_shape) m_rest_shape.forget();
    m_options = options;
    m_limit_is = limit_is;
    m_descent.set_options(options);
    const bool is_taken = !m_only_nets && problem.only_nets, is_let_go = m_only_nets && !problem.only_nets;
    m_reachable = problem.reachable;
    m_only_nets = problem.only_nets;
    m_only_walks = problem.only_walks;
    m_last_net = problem.last_net != nullptr ? *problem.last_net : Positions();
    m_max_deviation = max_deviation(*m_net, positions);
    const bool is_net_as_left =
        m_reachable && m_result.cols() > 0 && m_result == positions && m_max_deviation < options.threshold;
    if (is_taken && same_energy) note_home();
    m_goes_home = is_let_go && is_net_as_left && same_energy && m_rests_at_home && m_descent.energy() > k_no_energy &&
                  has_come_home(positions);
    if (is_net_as_left && same_energy && !m_pulls_moved && !m_goes_home && m_descent.is_at_rest())
        return Status::converged;
    if (m_reachable && !m_rest_shape.is_known()) m_rest_shape.begin(*m_net, *m_topology, m_options, limit());
    if (m_reachable && m_rest_shape.is_opening()) {
        begin_opening(positions);
        return Status::running;
    }
    return begin(positions, same_energy);
}

/// Meanwhile a hand has the last net, and what it asks for waits.
void Equilibrium::begin_opening(Positions& positions) {
    m_stage = open;
    m_asked = positions;
    if (m_only_nets && m_last_net.cols() > 0 && max_deviation(*m_net, m_last_net) < m_options.threshold)
        positions = m_last_net;
}

CornerLimit Equilibrium::limit() const { return corner_limit(*m_net, m_options, k_limit_margin); }

Status Equilibrium::open_rest_shape(Positions& positions, TraceRow& row) {
    m_rest_shape.open(row);
    row.stage = open;
    row.max_deviation = max_deviation(*m_net, positions);
    if (m_rest_shape.is_opening()) return Status::running;
    const Status status = begin(m_asked, false);
    const bool has_to_walk = status == Status::running && m_stage == follow && m_only_nets;
    if (!has_to_walk) positions = m_asked;
    return status;
}

Status Equilibrium::begin(Positions& positions, bool same_energy) {
    m_descent.begin_solve(was_left(m_result, positions));
    m_was_placed = false;
    m_stuck_at.resize(3, 0);
    const bool can_rest = m_reachable && m_part->size() > 0 && prepare_energy(positions, same_energy);
    m_stage = !can_rest ? net : m_goes_home ? follow : first_stage(positions);
    if (m_stage == net && m_reachable && is_held_as_net()) return without_rest(positions);
    if (m_stage == net && m_only_nets) return Status::unreachable;
    if (m_stage == net) {
        const Status status = projection().start(problem(), positions, m_options);
        if (status == Status::converged && can_rest) m_stage = rest;
        if (m_stage == net) return status == Status::converged ? without_rest(positions) : status;
    }
    if (m_stage == follow) {
        m_began_as_net = false;
        if (m_max_deviation < m_options.threshold) begin_as_net(positions);
        m_walk.begin(m_result, positions, m_net->mean_length());
        if (!m_only_nets) begin_walk_home();
    } else {
        m_walk.forget_moves(m_net->vertex_count());
    }
    if (m_stage != rest) return Status::running;
    enter_rest(positions);
    if (!m_descent.is_at_rest()) {
        if (!m_loose_pieces.empty()) m_descent.follow_lone_pulls(m_loose_pieces, m_pulls, positions);
        m_max_deviation = m_descent.deviation();
        m_result = positions;
        return Status::running;
    }
    m_result = positions;
    return Status::converged;
}

/// Whether nothing may move, and nothing has to. What a hand moves within the threshold would creep off the lengths,
/// and end where no net is near.
bool Equilibrium::is_held_as_net() const {
    return m_part->size() == 0 && m_max_deviation < (m_only_nets ? k_held_deviation : m_options.threshold);
}

/// Of a net where the systems for rest are too large, or nothing may move.
Status Equilibrium::without_rest(const Positions& positions) const {
    if (m_part->size() > 0) return Status::exact;
    return limit().is_kept(positions) ? Status::converged : Status::stalled;
}

/// These stay until a walk has come to another net.
void Equilibrium::begin_as_net(const Positions& positions) {
    m_began_as_net = true;
    m_begun = positions;
}

/// Whether handles are where the rest shape has them and is the answer.
bool Equilibrium::has_come_home(const Positions& positions) {
    if (!RestEnergy::is_least_at_rest_shape(m_options, m_pulls, m_guide.get())) return false;
    if (!m_rest_shape.is_known() || m_rest_shape.is_opening()) return false;
    m_walk.begin(positions, positions, m_net->mean_length());
    return m_walk.ends_as_in(m_net->rest_positions(), positions);
}

/// Before a hand leads the net away. What it finds at home it is to leave there: the rest shape, but no other shape
/// that somebody has pushed the net into.
void Equilibrium::note_home() {
    if (m_result.cols() > 0 && has_come_home(m_result)) m_rests_at_home = m_descent.energy() <= k_no_energy;
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

/// V, what lies in pieces of the net that nothing keeps from falling for ever: at its height, or drawn towards a place.
std::vector<bool> Equilibrium::weightless() const {
    const bool is_drawn =
        m_guide && m_options.guide_mode != GuideMode::off && m_options.guide_mode != GuideMode::outside;
    if (m_options.gravity == 0 || is_drawn) return {};
    std::vector<bool> carries(m_is_free.size());
    for (std::size_t v = 0; v < carries.size(); ++v) carries[v] = !m_is_free[v];
    for (const Slide& slide : m_slides) carries[slide.vertex] = !has_axis(slide.along, up_axis(m_options));
    for (const Pull& pull : m_pulls) carries[pull.vertex] = true;
    return m_topology->in_pieces_without(carries);
}

/// False if the systems for it would be too large.
bool Equilibrium::prepare_energy(const Positions& positions, bool same_energy) {
    try {
        if (!same_energy) {
            m_descent.choose_energy(m_rest_shape.positions(), m_options, m_pulls, m_guide.get(), m_unit, weightless(),
                                    m_limit_is, limit());
            m_pulls_changed = false;
        }
        m_descent.prepare(*m_part, m_is_free, m_slides, m_pulls, positions);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        return false;
    }
    return true;
}

Equilibrium::Stage Equilibrium::first_stage(const Positions& positions) {
    const bool is_net = m_max_deviation < m_options.threshold;
    // A handle that has moved by ever so little has left the net less exact than rest needs it.
    if (was_left(m_result, positions)) return is_net && m_result == positions ? rest : follow;
    const bool has_opened = m_rest_shape.positions() != m_net->rest_positions();
    if (was_left(m_net->rest_positions(), positions) && (has_opened || !is_net) &&
        max_deviation(*m_net, m_rest_shape.positions()) < m_options.threshold) {
        m_result = m_rest_shape.positions();
        return follow;
    }
    if (m_last_net.cols() > 0 && m_last_net != positions && was_left(m_last_net, positions) &&
        max_deviation(*m_net, m_last_net) < m_options.threshold) {
        m_result = m_last_net;
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
        row.energy = m_descent.energy();
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
    if (!m_descent.is_prepared()) return without_rest(positions);
    const Positions found = positions;
    if (!m_descent.project(positions)) {
        positions = found;
        return m_descent.end_at(positions);
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
    if (m_descent.is_linearised()) m_descent.take_step(x, row);
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
        m_descent.begin_steps();
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
    Eigen::Matrix3Xd moves = m_walk.moves_to(part, x);
    const double repeated = m_walk.take_off_repeated(moves);
    m_descent.extend(moves);
    moves += repeated * m_walk.last_move();
    m_descent.add_bow(x, moves);
    x += moves;
    if (part == 1) m_walk.held().take_held(m_walk.end(), x);
    return m_descent.project(x);
}

/// Where the way from the last net leads no farther: by the way from the rest shape, or else, if it was to end where
/// all edges had their lengths, from there, or else by `projection`; none of the two if only walks are asked for.
Status Equilibrium::find_another_net(Positions& positions) {
    if (begin_at_rest_shape(std::numeric_limits<double>::infinity())) {
        if (max_deviation(*m_net, positions) < m_options.threshold)
            begin_as_net(positions);
        else
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
    if (m_was_placed || !(max_deviation(*m_net, m_rest_shape.positions()) < m_options.threshold)) return false;
    const Positions start = m_walk.placed(m_rest_shape.positions(), m_result);
    if (!(m_walk.way_left(start) < nearer_than)) return false;
    m_was_placed = true;
    // As if nothing had been before, so that the end does not depend on it.
    if (!prepare_energy(start, false)) {
        prepare_energy(m_result, false);  // more corners are sharp in the rest shape than here
        return false;
    }
    m_result = start;
    m_descent.forget_pulls();
    m_descent.forget_multipliers();
    m_walk.forget_moves(m_net->vertex_count());
    m_walk.begin(m_result, m_walk.end(), m_net->mean_length());
    return true;
}

void Equilibrium::enter_rest(const Positions& positions) {
    m_stage = rest;
    m_descent.enter(positions);
    m_max_deviation = m_descent.deviation();
}

Status Equilibrium::relax(Positions& positions, TraceRow& row) {
    const Status status = m_descent.relax(positions, row);
    m_max_deviation = m_descent.deviation();
    return status;
}

std::optional<RestState> Equilibrium::rest_state() const {
    const bool has_net = m_stage == follow || m_stage == rest;
    return has_net ? m_descent.state(m_result, m_pulls) : std::nullopt;
}

std::unique_ptr<Method> make_opener() { return std::make_unique<Equilibrium>(nullptr); }

std::unique_ptr<Method> make_equilibrium() { return std::make_unique<Equilibrium>(make_opener); }

constexpr std::array k_equilibrium_stages{"Finding a net", "To the handles", "To rest", "Opening corners"};
// The tolerances where a net is found by `projection`.
constexpr auto k_equilibrium_options =
    joined(k_tolerances, std::array{"shear_limit", "bending_weight", "shear_weight", "tip_weight", "straight_rods",
                                    "rod_curvature", "warp_stiffness", "weft_stiffness", "square_corners", "gravity",
                                    "y_up", "guide_mode", "guide_weight", "rest_tolerance"});

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
///      handles that jump, it begins at the rest shape; so it does once a hand has let go of handles that are home.
///      Where the limit is to give way, it is a term that pushes back (PenaltyTerm);
///   3  Newton steps for the energy among nets with these lengths and no sharper corners, until the gradient that the
///      constraints leave is below Options::rest_tolerance (RestDescent). What stiff soft handles pull towards comes
///      there in steps of an edge length at most, with one Newton step each (PullWalk). A flat net that would lose
///      energy by bending out of its plane, towards which nothing pushes it to first order, is not at rest: it leaves
///      the plane.
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
    k_equilibrium_heeds};

}  // namespace chebnet
