#include "edit/editor.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.h"
#include "net/measures.h"

namespace chebnet {

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
    change_state(std::move(changed));
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

Holds Editor::holds() const {
    return {m_handles,
            m_handle_at,
            m_hand,
            m_region ? &*m_region : nullptr,
            m_method->heeds().slides,
            m_options.gravity * m_net->edge_count()};
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
    change_state(std::move(changed));
}

void Editor::set_method(std::string_view name) {
    EditState changed = state();
    changed.method = name;
    change_state(std::move(changed));
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
    change_state(std::move(changed));
}

void Editor::set_option(std::string_view key, std::string_view value) {
    EditState changed = state();
    chebnet::set_option(changed.options, key, value);
    change_state(std::move(changed));
}

void Editor::set_guide(std::shared_ptr<const Guide> guide) {
    EditState changed = state();
    changed.guide = std::move(guide);
    change_state(std::move(changed));
}

void Editor::set_positions(const Positions& positions) {
    check_positions(*m_net, positions);
    if (positions.cwiseAbs().maxCoeff() > k_largest_size)
        throw Error(ErrorCode::bad_scale, "a position is farther away than any net can be");
    EditState changed = state();
    changed.positions = positions;
    changed.locality.reset();
    change_state(std::move(changed));
}

void Editor::reset() {
    EditState changed = state();
    changed.positions = m_net->rest_positions();
    for (Handle& handle : changed.handles) handle.target = changed.positions.col(handle.vertex);
    changed.locality.reset();
    change_state(std::move(changed));
}

EditState Editor::state() const {
    EditState state{standing_handles(), m_method_name, initialisation(), m_options, std::nullopt, m_guide, m_positions};
    if (m_region) {
        state.locality = Locality{m_region->radius, m_region->origins, m_positions};
        for (const Pull& pull : m_region->pulls) state.locality->held_at.col(pull.vertex) = pull.target;
    }
    return state;
}

void Editor::set_state(EditState next) { go_to(std::move(next), false); }

void Editor::change_state(EditState changed) { go_to(std::move(changed), true); }

void Editor::go_to(EditState next, bool lets_net_grow) {
    // All checks come before the first change.
    const EditState present = state();
    std::unique_ptr<Method> other_method = next.method == m_method_name ? nullptr : make_method(next.method);
    Initialisation other_initialisation(next.initialisation);
    check_state(*m_net, next, other_method ? *other_method : *m_method);
    // Handles that a solve is drawing are not where the form below has them.
    const bool is_present = next == present, has_present_positions = next.positions == present.positions;
    const bool has_other_lengths = next.options.length_scale != present.options.length_scale;
    const Positions given = next.positions;
    normalise(next);
    if ((is_present || next == present) && (m_hand.is_empty() || draws_handles())) return;  // a solve under way goes on
    std::optional<Region> region = region_of(next.locality);
    let_go();

    if (has_other_lengths) {
        go_to_lengths(next, lets_net_grow && has_present_positions);
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
    note_last_net(given, has_present_positions && (lets_net_grow || !has_other_lengths));
    m_running = false;
}

/// To those of another state, whose net grows with them if it is to.
void Editor::go_to_lengths(EditState& next, bool net_grows) {
    const double factor = next.options.length_scale / m_options.length_scale;
    if (net_grows) {
        next.locality.reset();
        next.positions = grown(next.positions, factor);
        snap(next.handles, next.positions);
    }
    m_last_net = grown(m_last_net, factor);
    set_length_scale(next.options.length_scale);
}

/// Among these positions and those of the moment, in which handles have snapped: that may leave edges with their
/// lengths by chance, turned back on themselves. If neither is a net, the last one is the one of before, or else the
/// net at rest.
void Editor::note_last_net(const Positions& given, bool or_one_before) {
    const auto is_net = [&](const Positions& x) { return max_deviation(*m_net, x) < m_options.threshold; };
    if (is_net(given))
        m_last_net = given;
    else if (is_net(m_positions))
        m_last_net = m_positions;
    else if (!or_one_before)
        m_last_net = m_net->rest_positions();
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

Eigen::VectorXd Editor::edge_forces() const {
    const std::optional<RestState> state = rest_state();
    return state ? chebnet::edge_forces(*state) : Eigen::VectorXd::Zero(m_net->edge_count());
}

const HandleGraph& Editor::handle_graph() const {
    if (m_handle_graph) return *m_handle_graph;
    std::vector<int> vertices;
    for (const Handle& handle : m_handles) vertices.push_back(handle.is_pinned() ? handle.vertex : -1);
    return m_handle_graph.emplace(*m_net, *m_topology, vertices);
}

std::vector<UnreachablePair> Editor::unreachable_pairs() const {
    return chebnet::unreachable_pairs(holds(), handle_graph(), *m_topology, m_positions, m_options.threshold);
}

std::vector<Ball> Editor::reach(int vertex) const {
    return reach_of(static_cast<int>(place_of_handle(vertex)), holds(), handle_graph(), m_positions);
}

Eigen::VectorXf Editor::mobility(double radius, std::span<const int> origins) const {
    check_locality(*m_net, {radius, {origins.begin(), origins.end()}, {}});
    if (origins.empty() || !std::isfinite(radius)) return Eigen::VectorXf::Ones(m_net->vertex_count());
    return chebnet::mobility(*m_original, *m_topology, origins, radius);
}

double Editor::handle_error() const {
    double largest = 0;
    for (const Handle& handle : m_handles)
        if (handle.is_exact() && !m_hand.holds(handle.vertex))
            largest = std::max(largest, (m_positions.col(handle.vertex) - handle.target).norm());
    return largest;
}

}  // namespace chebnet
