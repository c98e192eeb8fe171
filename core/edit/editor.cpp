#include "edit/editor.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <tuple>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "edit/near_targets.h"
#include "net/measures.h"
#include "solve/parts/held_vertices.h"

namespace chebnet {

namespace {

/// A handle that is held back has the weight of so many edges, and no greater force than at this distance, in edge
/// lengths: as hard as a pull can be without being stiff. Where it comes so close to its target, it may be held there
/// after all.
constexpr double k_weight_in_hand = 100, k_nearly_there = 0.5;
/// How near to the reach of other handles what is in hand walks, before it is pulled on, and how often it is drawn
/// there.
constexpr double k_nearly_taut = 0.995;
constexpr int k_most_drawn = 30;
// Lines that are to be straight are held so when no vertex of them is farther from that, in edge lengths: from there on
// they go straight as nets.
constexpr double k_nearly_straight = 0.05;

void check_target(int vertex, const Eigen::Vector3d& target) {
    if (!target.allFinite())
        throw Error(ErrorCode::non_finite, "the target of handle " + std::to_string(vertex) + " is not finite");
}

void check_vertex(const Net& net, int vertex, const char* what) {
    if (vertex < 0 || vertex >= net.vertex_count())
        throw Error(ErrorCode::index_out_of_range, std::string(what) + " names vertex " + std::to_string(vertex) +
                                                       ", but vertices go from 0 to " +
                                                       std::to_string(net.vertex_count() - 1));
}

void check_handles(const Net& net, const std::vector<Handle>& handles) {
    std::vector<bool> held(static_cast<std::size_t>(net.vertex_count()), false);
    for (const Handle& handle : handles) {
        check_vertex(net, handle.vertex, "a handle");
        if (held[handle.vertex])
            throw Error(ErrorCode::repeated_vertex, "two handles hold vertex " + std::to_string(handle.vertex));
        held[handle.vertex] = true;
        check_target(handle.vertex, handle.target);
        if (!(handle.weight > 0))
            throw Error(ErrorCode::bad_option,
                        "the weight of handle " + std::to_string(handle.vertex) + " must be a number above 0");
        if (handle.slides != k_no_axes) check_slide(handle.vertex, handle.slides, handle.is_exact());
    }
}

void check_softness(const std::vector<Handle>& handles, const Method& method, const std::string& name) {
    const auto soft = std::find_if(handles.begin(), handles.end(), [](const Handle& h) { return !h.is_exact(); });
    if (soft != handles.end() && !method.knows_pulls())
        throw Error(ErrorCode::bad_option, "method " + name + " keeps every handle exactly, but handle " +
                                               std::to_string(soft->vertex) + " is soft; projection can do that");
}

void check_positions(const Net& net, const Positions& positions) {
    if (positions.cols() != net.vertex_count())
        throw Error(ErrorCode::index_out_of_range, "positions of " + std::to_string(positions.cols()) +
                                                       " vertices do not fit a net of " +
                                                       std::to_string(net.vertex_count()));
    if (!positions.allFinite()) throw Error(ErrorCode::non_finite, "a position is not finite");
}

void check_locality(const Net& net, const Locality& locality) {
    if (!(locality.radius > 0))
        throw Error(ErrorCode::bad_option, "the locality must be a number of edge lengths above 0");
    for (int origin : locality.origins) check_vertex(net, origin, "the origin of a locality");
    if (locality.held_at.size() > 0) check_positions(net, locality.held_at);
}

void snap(std::vector<Handle>& handles, Positions& positions) {
    for (Handle& handle : handles)
        if (handle.is_exact()) handle.snap(positions.col(handle.vertex));
}

/// The state in the form of Editor::state(): exact handles at their targets, no locality where everything may move.
void normalise(EditState& state) {
    snap(state.handles, state.positions);
    if (!state.locality) return;
    auto& [radius, origins, held_at] = *state.locality;
    if (!std::isfinite(radius) || origins.empty())
        state.locality.reset();
    else if (held_at.size() == 0)
        held_at = state.positions;
}

}  // namespace

Editor::Editor(Net net)
    : m_original(std::make_shared<const Net>(std::move(net))),
      m_net(m_original),
      m_unit(m_net->unit()),
      m_unit_net(std::make_unique<const Net>(m_net->scaled(1 / m_unit))),
      m_topology(std::make_unique<const Topology>(*m_net)),
      m_positions(m_net->rest_positions()),
      m_last_net(m_positions),
      m_handle_at(static_cast<std::size_t>(m_net->vertex_count()), -1),
      m_hand(m_net->vertex_count()),
      m_method_name(k_default_method),
      m_method(make_method(k_default_method)) {}

void Editor::set_handles(std::vector<Handle> handles) {
    EditState changed = state();
    changed.handles = std::move(handles);
    changed.locality.reset();
    set_state(std::move(changed));
}

void Editor::move_handle(int vertex, const Eigen::Vector3d& target) {
    check_target(vertex, target);
    const std::size_t place = place_of_handle(vertex);
    let_go();
    Handle& handle = m_handles[place];
    move(handle, target);
    if (handle.is_exact()) handle.snap(m_positions.col(vertex));
}

void Editor::move(Handle& handle, const Eigen::Vector3d& target) {
    if (m_region && m_region->is_outside(handle.vertex)) replace_region(std::nullopt);
    copy_along(k_all_axes - handle.slides, target.data(), handle.target.data());
    m_running = false;
}

void Editor::drag_handle(int vertex, const Eigen::Vector3d& target, Axes along) {
    check_target(vertex, target);
    if (along != k_all_axes && !is_part(along)) throw Error(ErrorCode::bad_option, "a hand keeps to x, y or z");
    const std::size_t place = place_of_handle(vertex);
    if (!m_method->goes_from_net_to_net()) return move_handle(vertex, target);
    if (m_hand.owner() != Hand::Owner::user) let_go();
    Handle& handle = m_handles[place];
    if (handle.is_exact()) {
        if (m_hand.take(vertex, Hand::Owner::user) && m_hand.holds_back()) hold_otherwise();
        m_hand.hold_again(false);
        keep_hand_to(along);
    }
    move(handle, target);
}

std::vector<Handle> Editor::standing_handles() const {
    std::vector<Handle> handles = m_handles;
    if (draws_handles()) return handles;
    for (int vertex : m_hand.vertices()) handles[m_handle_at[vertex]].target = m_positions.col(vertex);
    return handles;
}

/// Those that are still on their way, or held back, stay where they are; those that a solve has taken in hand are to be
/// at their targets.
void Editor::let_go() {
    if (m_hand.is_empty()) return;
    m_handles = standing_handles();
    if (draws_handles()) snap(m_handles, m_positions);
    empty_hand();
}

void Editor::empty_hand() {
    hold_back(false);
    m_hand.empty();
}

/// Held at its target by the method, rather than pulled there.
bool Editor::is_held(const Handle& handle) const {
    return handle.is_exact() && !(m_hand.holds_back() && m_hand.holds(handle.vertex));
}

/// After a solve. What is in hand may still be on its way; where it has arrived it takes its target's own digits.
void Editor::snap_held() {
    for (Handle& handle : m_handles) {
        if (!handle.is_exact()) continue;
        const int vertex = handle.vertex;
        const Axes axes = is_held(handle) ? handle.slides : axes_now(handle);
        const bool has_arrived =
            !m_hand.holds(vertex) || across(axes, m_unit_positions.col(vertex)) == across(axes, handle.target / m_unit);
        handle.follow(m_positions.col(vertex));
        if (has_arrived) copy_along(k_all_axes - axes, handle.target.data(), m_positions.col(vertex).data());
    }
}

void Editor::keep_hand_to(Axes axes) {
    if (m_hand.along() == axes) return;
    m_hand.keep_to(axes);
    if (m_hand.holds_back()) hold_otherwise();
}

void Editor::hold_back(bool on) {
    if (m_hand.holds_back() == on) return;
    m_hand.hold_back(on);
    hold_otherwise();
}

/// What is held at its place is no longer what the method knows of.
void Editor::hold_otherwise() {
    m_prepared = false;
    m_running = false;
}

bool Editor::is_nearly_there() const {
    const double near = k_nearly_there * m_unit_net->mean_length();
    return std::all_of(m_hand.vertices().begin(), m_hand.vertices().end(), [&](int vertex) {
        return (m_unit_positions.col(vertex) - goal(m_handles[m_handle_at[vertex]]) / m_unit).stableNorm() < near;
    });
}

/// After a solve has ended: whether another way of holding what is in hand is to be tried. Where the net cannot follow,
/// or has followed as far as a walk leads, it is held back, and where that is no net along the axes to which it is
/// kept, in all of them; where it has come near all the same, it is held again, once; and where even that is no net,
/// because of other handles, it is moved as by move_handle().
bool Editor::goes_on_otherwise(Status status) {
    if (m_hand.is_empty()) {
        if (!(m_may_take_in_hand && m_reachable && status == Status::unreachable)) return false;
        take_in_hand();
        return true;  // also without: by lengths alone
    }
    if (status == Status::unreachable && m_hand.holds_back()) {
        if (m_hand.along() != k_all_axes)
            keep_hand_to(k_all_axes);
        else
            empty_hand();
        return true;
    }
    if (status == Status::unreachable || m_stops_short) {
        // A core without slides says so here, before it holds anything back: one with them goes on from this state.
        m_running = false;
        if (is_part(m_hand.along())) check_slide(m_hand.vertices().front(), m_hand.along(), true);
        hold_back(true);
        return true;
    }
    if (!m_hand.holds_back()) return false;
    if (m_hand.has_held_again() || !is_nearly_there()) return goes_on_sliding();
    m_hand.hold_again(true);
    hold_back(false);
    return true;
}

/// What was held back has been pulled along the axes along which it slides, too. Once it is let go nothing does, and it
/// is not at rest there.
bool Editor::goes_on_sliding() {
    const bool slides = std::any_of(m_hand.vertices().begin(), m_hand.vertices().end(),
                                    [&](int vertex) { return m_handles[m_handle_at[vertex]].slides != k_no_axes; });
    if (m_hand.owner() != Hand::Owner::released || !slides) return false;
    let_go();
    return true;
}

const Handle* Editor::find_handle(int vertex) const {
    if (vertex < 0 || vertex >= m_net->vertex_count() || m_handle_at[vertex] < 0) return nullptr;
    return &m_handles[m_handle_at[vertex]];
}

std::size_t Editor::place_of_handle(int vertex) const {
    const Handle* handle = find_handle(vertex);
    if (handle == nullptr)
        throw Error(ErrorCode::index_out_of_range, "there is no handle at vertex " + std::to_string(vertex));
    return static_cast<std::size_t>(handle - m_handles.data());
}

void Editor::set_locality(double radius, std::span<const int> origins) {
    EditState changed = state();
    changed.locality = Locality{radius, {origins.begin(), origins.end()}, {}};
    set_state(std::move(changed));
}

void Editor::set_method(std::string_view name) {
    EditState changed = state();
    changed.method = name;
    set_state(std::move(changed));
}

void Editor::set_method(std::unique_ptr<Method> method, std::string name) {
    check_softness(m_handles, *method, name);
    let_go();
    m_method = std::move(method);
    m_method_name = std::move(name);
    m_prepared = false;
    m_running = false;
}

void Editor::set_initialisation(std::string_view text) {
    EditState changed = state();
    changed.initialisation = text;
    set_state(std::move(changed));
}

void Editor::set_option(std::string_view key, std::string_view value) {
    EditState changed = state();
    chebnet::set_option(changed.options, key, value);
    set_state(std::move(changed));
}

void Editor::set_guide(std::shared_ptr<const Guide> guide) {
    EditState changed = state();
    changed.guide = std::move(guide);
    set_state(std::move(changed));
}

void Editor::set_positions(const Positions& positions) {
    check_positions(*m_net, positions);
    if (positions.cwiseAbs().maxCoeff() > k_largest_size)
        throw Error(ErrorCode::bad_scale, "a position is farther away than any net can be");
    EditState changed = state();
    changed.positions = positions;
    changed.locality.reset();
    set_state(std::move(changed));
}

void Editor::reset() {
    EditState changed = state();
    changed.positions = m_net->rest_positions();
    for (Handle& handle : changed.handles) handle.target = changed.positions.col(handle.vertex);
    changed.locality.reset();
    set_state(std::move(changed));
}

EditState Editor::state() const {
    EditState state{standing_handles(), m_method_name, initialisation(), m_options, std::nullopt, m_guide, m_positions};
    if (m_region) {
        state.locality = Locality{m_region->radius, m_region->origins, m_positions};
        for (const Pull& pull : m_region->pulls) state.locality->held_at.col(pull.vertex) = pull.target;
    }
    return state;
}

void Editor::set_state(EditState next) {
    // All checks come before the first change.
    const EditState present = state();
    std::unique_ptr<Method> other_method = next.method == m_method_name ? nullptr : make_method(next.method);
    Initialisation other_initialisation(next.initialisation);
    check_options(next.options);
    check_handles(*m_net, next.handles);
    check_softness(next.handles, other_method ? *other_method : *m_method, next.method);
    check_positions(*m_net, next.positions);
    if (next.locality) check_locality(*m_net, *next.locality);
    // Handles that a solve is drawing are not where the form below has them.
    const bool is_present = next == present, has_present_positions = next.positions == present.positions;
    const Positions given = next.positions;
    normalise(next);
    if ((is_present || next == present) && (m_hand.is_empty() || draws_handles())) return;  // a solve under way goes on
    std::optional<Region> region = region_of(next.locality);
    let_go();

    if (next.options.length_scale != present.options.length_scale) {
        const double factor = next.options.length_scale / present.options.length_scale;
        if (has_present_positions) {
            next.locality.reset();
            next.positions = grown(next.positions, factor);
            snap(next.handles, next.positions);
        }
        m_last_net = grown(m_last_net, factor);
        set_length_scale(next.options.length_scale);
        region = region_of(next.locality);
    }
    if (other_method) {
        m_method = std::move(other_method);
        m_method_name = std::move(next.method);
        m_prepared = false;
    }
    if (next.initialisation != present.initialisation) {
        m_initialisation = std::move(other_initialisation);
        m_prepared = false;
    }
    m_options = next.options;
    m_guide = std::move(next.guide);
    if (next.positions != m_positions) m_unit_positions.resize(3, 0);
    replace_handles(std::move(next.handles));
    replace_region(std::move(region));
    m_positions = std::move(next.positions);
    // Handles that snap may leave edges with their lengths by chance, turned back on themselves.
    const auto is_net = [&](const Positions& x) { return max_deviation(*m_net, x) < m_options.threshold; };
    if (is_net(given))
        m_last_net = given;
    else if (is_net(m_positions))
        m_last_net = m_positions;
    else if (!has_present_positions)
        m_last_net = m_net->rest_positions();
    m_running = false;
}

/// The solver, whose unit grows too, knows of handles that have come closer, and of nothing else.
void Editor::set_length_scale(double scale) {
    m_net = scale == 1 ? m_original : std::make_shared<const Net>(m_original->grown(scale));
    m_unit = scale * m_original->unit();
    m_handle_graph.reset();
    m_taut_lines.forget();
}

/// About the middle of the exact handles in the last net; of all vertices, if there are none.
Positions Editor::grown(const Positions& positions, double factor) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int count = 0;
    for (int v = 0; v < m_net->vertex_count(); ++v) {
        const Handle* handle = find_handle(v);
        if (handle == nullptr || !handle->is_exact()) continue;
        sum += m_last_net.col(v);
        ++count;
    }
    const Eigen::Vector3d centre =
        count > 0 ? Eigen::Vector3d(sum / count) : Eigen::Vector3d(m_last_net.rowwise().mean());
    return chebnet::grown(positions, centre, factor);
}

void Editor::replace_handles(std::vector<Handle> handles) {
    const auto same_kind = [](const Handle& a, const Handle& b) {
        return a.vertex == b.vertex && a.is_exact() == b.is_exact() && a.slides == b.slides;
    };
    const bool same_set = std::equal(handles.begin(), handles.end(), m_handles.begin(), m_handles.end(), same_kind);
    for (const Handle& handle : m_handles) m_handle_at[handle.vertex] = -1;
    m_handles = std::move(handles);
    for (std::size_t i = 0; i < m_handles.size(); ++i) m_handle_at[m_handles[i].vertex] = static_cast<int>(i);
    if (!same_set) {
        m_prepared = false;
        m_handle_graph.reset();
        m_taut_lines.forget();
        m_taut.clear();
    }
}

void Editor::replace_region(std::optional<Region> region) {
    const bool same_outside = region && m_region ? region->outside == m_region->outside : !region && !m_region;
    if (!same_outside) m_prepared = false;
    m_region = std::move(region);
}

std::optional<Region> Editor::region_of(const std::optional<Locality>& locality) const {
    if (!locality) return std::nullopt;
    Region region = region_around(*m_original, *m_topology, locality->held_at, locality->origins, locality->radius);
    for (Region::BorderVertex& vertex : region.border) vertex.distance *= m_unit / m_original->unit();
    return region;
}

/// Along which its vertex may move now: held back, along those of the hand, too.
Axes Editor::axes_now(const Handle& handle) const {
    if (!handle.is_exact()) return k_all_axes;
    const Axes axes = is_held(handle) ? handle.slides : handle.slides | m_hand.along();
    const bool can_slide = m_method->knows_slides() && !(m_region && m_region->is_outside(handle.vertex));
    if (is_part(axes) && !can_slide) return is_held(handle) ? k_no_axes : k_all_axes;
    return axes;
}

std::vector<Slide> Editor::slides() const {
    std::vector<Slide> slides;
    for (const Handle& handle : m_handles)
        if (const Axes axes = axes_now(handle); is_part(axes)) slides.push_back({handle.vertex, axes});
    return slides;
}

/// Exact handles that do not slide, what they pull straight, and what lies outside the region that may move.
std::vector<int> Editor::fixed_vertices() const {
    std::vector<int> vertices;
    for (const TautVertex& taut : m_taut) vertices.push_back(taut.vertex);
    for (const Handle& handle : m_handles)
        if (axes_now(handle) == k_no_axes) vertices.push_back(handle.vertex);
    if (!m_region) return vertices;
    vertices.insert(vertices.end(), m_region->outside.begin(), m_region->outside.end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

/// In the solver's unit. Pulls at one vertex are joined into one; a fixed vertex cannot be pulled.
void Editor::collect_pulls() {
    m_pulls.clear();
    if (m_region)
        for (const Pull& pull : m_region->pulls) {
            const Handle* handle = find_handle(pull.vertex);
            if (handle == nullptr || !is_held(*handle))
                m_pulls.push_back({pull.vertex, pull.target / m_unit, pull.weight});
        }
    const auto of_region = static_cast<std::ptrdiff_t>(m_pulls.size());  // ascending by vertex
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        const Handle& handle = m_handles[i];
        const Eigen::Vector3d target = m_near_targets.col(static_cast<Eigen::Index>(i));
        if (is_held(handle) || (m_region && m_region->is_outside(handle.vertex))) continue;
        Pull own{handle.vertex, target, handle.weight};
        if (handle.is_exact()) {
            own.weight = k_weight_in_hand;
            own.yields = k_nearly_there * m_unit_net->mean_length();
        }
        const auto other = std::lower_bound(m_pulls.begin(), m_pulls.begin() + of_region, handle.vertex,
                                            [](const Pull& pull, int vertex) { return pull.vertex < vertex; });
        if (other == m_pulls.begin() + of_region || other->vertex != handle.vertex) {
            m_pulls.push_back(own);
            continue;
        }
        other->weight += own.weight;
        other->target += own.weight / other->weight * (target - other->target);
        other->yields = own.yields;
    }
}

Problem Editor::problem() const {
    return {*m_unit_net, *m_topology,        m_fixed,  m_pulls,           m_reachable, &m_unit_last_net, m_guide,
            m_unit,      !m_hand.is_empty(), m_slides, m_may_take_in_hand};
}

void Editor::prepare() {
    m_fixed = fixed_vertices();
    m_slides = slides();
    m_method->prepare(problem());
    m_initialisation.prepare(*m_unit_net, HeldVertices(m_net->vertex_count(), m_fixed, m_slides).vertices());
    m_prepared = true;
}

/// Decides where the handles are to be for the solver, which is at their targets unless those are too far.
void Editor::draw_targets_near() {
    const auto count = static_cast<Eigen::Index>(m_handles.size());
    const double farthest = k_farthest_target * m_net->mean_length();
    Eigen::Matrix3Xd targets(3, count), rest(3, count);
    bool is_far = false;
    for (Eigen::Index i = 0; i < count; ++i) {
        rest.col(i) = m_net->rest_positions().col(m_handles[i].vertex);
        targets.col(i) = goal(m_handles[i]);
        // A soft handle only draws, in its direction from however far.
        if (!m_handles[i].is_exact()) targets.col(i) = drawn_near(targets.col(i), rest.col(i), farthest);
        is_far |= m_handles[i].is_exact() && (targets.col(i) - rest.col(i)).cwiseAbs().maxCoeff() > farthest;
    }
    const std::vector<UnreachablePair> pairs = unreachable_pairs();
    m_stops_short =
        !pairs.empty() && !m_hand.holds_back() && !m_hand.is_empty() && !m_region && draw_within_reach(targets);
    m_reachable = (pairs.empty() || m_stops_short) && !is_far;
    if (!m_reachable) targets = near_targets(handle_graph(), m_net->mean_length(), targets, rest);
    // What is held back may be pulled anywhere.
    const auto both_held = [this](const UnreachablePair& pair) {
        const Handle* b = find_handle(pair.vertex_b);
        return is_held(*find_handle(pair.vertex_a)) && (b == nullptr || is_held(*b));
    };
    if (m_hand.holds_back()) m_reachable = std::none_of(pairs.begin(), pairs.end(), both_held);
    m_near_targets = targets / m_unit;
}

/// Takes what is in hand to a place that its distances from other handles allow, a little less far than they do. False
/// if there is none, as far as a few rounds tell.
bool Editor::draw_within_reach(Eigen::Matrix3Xd& targets) const {
    for (int round = 0; round < k_most_drawn; ++round) {
        bool is_within = true;
        for (int vertex : m_hand.vertices())
            for (const auto& [other, distance] : handle_graph().neighbours(m_handle_at[vertex])) {
                auto target = targets.col(m_handle_at[vertex]);
                if ((target - targets.col(other)).stableNorm() <= distance) continue;
                target = drawn_near(target, targets.col(other), k_nearly_taut * distance);
                is_within = false;
            }
        if (is_within) return true;
    }
    return false;
}

/// Of lines that exact handles pull straight, once the net has come near to that. False if that has not changed.
bool Editor::find_taut_lines() {
    std::vector<TautVertex> taut;
    if (m_method->goes_from_net_to_net() && m_reachable && !m_region) {
        std::vector<int> vertices;
        for (const Handle& handle : m_handles)
            vertices.push_back(handle.is_pinned() && axes_now(handle) == k_no_axes ? handle.vertex : -1);
        std::vector<bool> has_handle(m_handle_at.size());
        for (std::size_t v = 0; v < has_handle.size(); ++v) has_handle[v] = m_handle_at[v] >= 0;
        taut =
            m_taut_lines.find(*m_net, *m_topology, handle_graph(), std::move(vertices), m_unit * m_near_targets,
                              std::move(has_handle), m_positions, m_last_net, k_nearly_straight * m_net->mean_length());
    }
    if (taut == m_taut) return false;
    m_taut = std::move(taut);
    m_prepared = false;
    return true;
}

/// What stands where the solver has left it has the solver's own digits.
Positions Editor::in_unit(const Positions& positions) const {
    Positions x = positions / m_unit;
    for (Eigen::Index i = 0; i < m_unit_positions.size(); ++i)
        if (positions.data()[i] == m_unit * m_unit_positions.data()[i]) x.data()[i] = m_unit_positions.data()[i];
    return x;
}

/// The positions of the moment in the solver's unit. Vertices that were far handles once may be anywhere, and are taken
/// as near as the targets of handles are; but for a net that has gone after one.
void Editor::load_positions() {
    const double farthest = k_farthest_target + m_unit_net->rest_positions().lpNorm<Eigen::Infinity>();
    m_unit_last_net = in_unit(m_last_net);
    m_unit_positions = in_unit(m_positions);
    if (max_deviation(*m_unit_net, m_unit_positions) >= m_options.threshold)
        m_unit_positions = m_unit_positions.cwiseMax(-2 * farthest).cwiseMin(2 * farthest);
    for (std::size_t i = 0; i < m_handles.size(); ++i) {
        const Handle& handle = m_handles[i];
        double* position = m_unit_positions.col(handle.vertex).data();
        if (is_held(handle))
            copy_along(k_all_axes - handle.slides, m_near_targets.col(static_cast<Eigen::Index>(i)).data(), position);
        else
            copy_along(k_all_axes - axes_now(handle), Eigen::Vector3d(handle.target / m_unit).data(), position);
    }
    const Eigen::Matrix3Xd places = places_of(m_taut, m_near_targets);
    for (std::size_t i = 0; i < m_taut.size(); ++i)
        m_unit_positions.col(m_taut[i].vertex) = places.col(static_cast<Eigen::Index>(i));
}

void Editor::store_positions() {
    const Positions kept = m_region ? Positions(m_positions(Eigen::all, m_region->outside)) : Positions();
    m_positions = m_unit * m_unit_positions;
    if (m_region) m_positions(Eigen::all, m_region->outside) = kept;
    snap_held();
}

/// Adds what the initialisation does to the trace.
Status Editor::begin_solve(Trace& trace) {
    const Stopwatch watch;
    draw_targets_near();
    find_taut_lines();
    if (!m_prepared) prepare();
    collect_pulls();
    load_positions();
    // What a hand drags is led from net to net, not to where something else would begin.
    if (m_hand.is_empty() && max_deviation(*m_unit_net, m_unit_positions) >= m_options.threshold) {
        const double prepared_ms = watch.milliseconds();
        for (TraceRow& row : m_initialisation.apply(m_unit_positions)) {
            row.total_ms += prepared_ms;
            trace.push_back(row);
        }
    }
    return m_method->start(problem(), m_unit_positions, m_options);
}

Status Editor::iterate(TraceRow& row) {
    const Status status = m_method->iterate(m_unit_positions, row);
    if (status != Status::non_finite && m_unit_positions.allFinite()) return status;
    load_positions();
    return Status::non_finite;
}

Eigen::VectorXd Editor::edge_forces() const {
    const std::optional<RestState> state = rest_state();
    return state ? chebnet::edge_forces(*state) : Eigen::VectorXd::Zero(m_net->edge_count());
}

SolveReport Editor::solve(const Budget& budget) {
    try {
        return go_on(budget);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::too_large) throw;
        refuse_size(error.what());
    } catch (const std::bad_alloc&) {
        refuse_size("there is not enough memory");
    }
}

/// The method starts a new solve at the next call. Handles that this one was drawing are at their targets again.
void Editor::refuse_size(const std::string& reason) {
    if (draws_handles()) give_up_by_hand();
    m_prepared = false;
    m_running = false;
    const std::string way_out = m_method_name == "projection" ? "make it coarser" : "projection needs less";
    throw Error(ErrorCode::too_large, "a net of " + std::to_string(m_net->vertex_count()) +
                                          " vertices is too large for method " + m_method_name + ": " + reason + "; " +
                                          way_out);
}

SolveReport Editor::go_on(const Budget& budget) {
    Stopwatch watch;
    SolveReport report;
    bool has_moved = m_running;  // since the method began
    if (!m_running) {
        m_iterations = 0;
        m_elapsed_ms = 0;
        // What is pressed together would come out crumpled where it is made a net by its lengths alone.
        m_may_take_in_hand = m_hand.is_empty() && !m_region;
        m_by_hand.reset();
        m_net_before = m_last_net;
        report.status = begin_solve(report.trace);
    }
    for (;;) {
        if (report.status != Status::running) {
            if (has_moved) store_positions();
            const bool found_rest = report.status == Status::converged;
            const bool goes_on = draws_handles() ? goes_on_by_hand(report) : goes_on_otherwise(report.status);
            if (!goes_on && (found_rest || !find_taut_lines())) break;
            report.status = begin_solve(report.trace);
            has_moved = false;
            continue;
        }
        if (m_iterations >= m_options.max_iterations) {
            report.status = m_reachable ? Status::max_iterations : Status::unreachable;
            if (draws_handles()) continue;
            break;
        }
        const bool budget_spent = report.iterations >= budget.iterations || watch.milliseconds() >= budget.milliseconds;
        if (budget_spent && report.iterations > 0) break;
        TraceRow row;
        report.status = iterate(row);
        has_moved = true;
        row.iteration = ++m_iterations;
        if (report.status == Status::running && draws_handles()) report.status = status_by_hand();
        if (draws_handles()) row.max_deviation = deviation_with_hand_at_targets();
        row.total_ms = m_elapsed_ms + watch.milliseconds();
        report.factorisation_ms += row.factorisation_ms;
        report.trace.push_back(row);
        ++report.iterations;
    }
    m_running = report.status == Status::running;
    store_positions();
    if (m_running)
        show_found_net();
    else
        take_better_net(report);
    if (const std::optional<RestState> state = rest_state()) report.to_rest = state->left;
    report.max_deviation = max_deviation(*m_net, m_positions);
    if (report.max_deviation < m_options.threshold) m_last_net = m_positions;
    if (keeps_lengths(report.status) && !(report.max_deviation < m_options.threshold))
        report.status = Status::unreachable;  // the net is exact, but only where the handles were drawn near
    if (!m_running && m_hand.owner() == Hand::Owner::released) let_go();
    report.milliseconds = watch.milliseconds();
    m_elapsed_ms += report.milliseconds;
    return report;
}

const HandleGraph& Editor::handle_graph() const {
    if (m_handle_graph) return *m_handle_graph;
    std::vector<int> vertices;
    for (const Handle& handle : m_handles) vertices.push_back(handle.is_pinned() ? handle.vertex : -1);
    return m_handle_graph.emplace(*m_net, *m_topology, vertices);
}

std::vector<UnreachablePair> Editor::unreachable_pairs() const {
    const HandleGraph& graph = handle_graph();
    std::vector<UnreachablePair> pairs;
    for (int i = 0; i < graph.size(); ++i)
        for (const auto& [j, reach] : graph.neighbours(i)) {
            if (j < i) continue;
            const Handle &a = m_handles[i], &b = m_handles[j];
            const UnreachablePair pair{a.vertex, b.vertex, (a.target - b.target).stableNorm(), reach};
            if (is_out_of_reach(pair)) pairs.push_back(pair);
        }
    if (m_region) add_worst_of_border(pairs);
    const auto strain = [](const UnreachablePair& pair) {
        return std::max(pair.distance / pair.reach, pair.reach / pair.distance);
    };
    // Those of one strain, in the order of their vertices.
    std::sort(pairs.begin(), pairs.end(), [&](const UnreachablePair& a, const UnreachablePair& b) {
        return std::tuple(-strain(a), a.vertex_a, a.vertex_b) < std::tuple(-strain(b), b.vertex_a, b.vertex_b);
    });
    return pairs;
}

void Editor::add_worst_of_border(std::vector<UnreachablePair>& pairs) const {
    UnreachablePair worst{0, 0, 0, 1};
    for (const auto& [vertex, origin, reach] : m_region->border) {
        const Handle* handle = find_handle(origin);
        if (handle == nullptr || !handle->is_pinned()) continue;
        const double distance = (handle->target - m_positions.col(vertex)).stableNorm();
        if (distance * worst.reach > worst.distance * reach) worst = {origin, vertex, distance, reach};
    }
    const auto is_worst = [&](const UnreachablePair& pair) {
        return std::max(pair.vertex_a, pair.vertex_b) == std::max(worst.vertex_a, worst.vertex_b) &&
               std::min(pair.vertex_a, pair.vertex_b) == std::min(worst.vertex_a, worst.vertex_b);
    };
    if (is_out_of_reach(worst) && std::none_of(pairs.begin(), pairs.end(), is_worst)) pairs.push_back(worst);
}

bool Editor::is_out_of_reach(const UnreachablePair& pair) const {
    // At best a path pulled straight has the same ratio in all its edges: no net has a smaller deviation.
    const bool off = !(deviation(pair.distance / pair.reach) < m_options.threshold);
    return off && (pair.distance > pair.reach || are_joined(pair.vertex_a, pair.vertex_b));
}

std::vector<Ball> Editor::reach(int vertex) const {
    const std::size_t place = place_of_handle(vertex);
    if (!m_handles[place].is_pinned()) return {};
    std::vector<Ball> balls;
    for (const auto& [other, radius] : handle_graph().neighbours(static_cast<int>(place)))
        balls.push_back({m_handles[other].vertex, m_handles[other].target, radius});
    if (m_region)
        for (const auto& [held, origin, distance] : m_region->border)
            if (origin == vertex) balls.push_back({held, m_positions.col(held), distance});
    return balls;
}

Eigen::VectorXf Editor::mobility(double radius, std::span<const int> origins) const {
    check_locality(*m_net, {radius, {origins.begin(), origins.end()}, {}});
    if (origins.empty() || !std::isfinite(radius)) return Eigen::VectorXf::Ones(m_net->vertex_count());
    return chebnet::mobility(*m_original, *m_topology, origins, radius);
}

bool Editor::are_joined(int a, int b) const {
    const std::span<const int> neighbours = m_topology->neighbours(a);
    return std::binary_search(neighbours.begin(), neighbours.end(), b);
}

double Editor::handle_error() const {
    double largest = 0;
    for (const Handle& handle : m_handles)
        if (handle.is_exact() && !m_hand.holds(handle.vertex))
            largest = std::max(largest, (m_positions.col(handle.vertex) - handle.target).norm());
    return largest;
}

}  // namespace chebnet
