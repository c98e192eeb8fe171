#include "edit/editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "net/error.h"
#include "net/measures.h"
#include "solve/stopwatch.h"

namespace chebnet {

namespace {

void check_target(int vertex, const Eigen::Vector3d& target) {
    if (!target.allFinite())
        throw Error(ErrorCode::non_finite, "the target of handle " + std::to_string(vertex) + " is not finite");
}

void check_handles(const Net& net, const std::vector<Handle>& handles) {
    std::vector<bool> held(static_cast<std::size_t>(net.vertex_count()), false);
    for (const Handle& handle : handles) {
        if (handle.vertex < 0 || handle.vertex >= net.vertex_count())
            throw Error(ErrorCode::index_out_of_range, "a handle names vertex " + std::to_string(handle.vertex) +
                                                           ", but vertices go from 0 to " +
                                                           std::to_string(net.vertex_count() - 1));
        if (held[handle.vertex])
            throw Error(ErrorCode::repeated_vertex, "two handles hold vertex " + std::to_string(handle.vertex));
        held[handle.vertex] = true;
        check_target(handle.vertex, handle.target);
    }
}

}  // namespace

Editor::Editor(Net net)
    : m_net(std::make_unique<const Net>(std::move(net))),
      m_topology(std::make_unique<const Topology>(*m_net)),
      m_positions(m_net->rest_positions()),
      m_method_name(k_default_method),
      m_method(make_method(k_default_method)) {}

void Editor::set_handles(std::vector<Handle> handles) {
    check_handles(*m_net, handles);
    const auto same_vertex = [](const Handle& a, const Handle& b) { return a.vertex == b.vertex; };
    const bool same_set = std::equal(handles.begin(), handles.end(), m_handles.begin(), m_handles.end(), same_vertex);
    m_handles = std::move(handles);
    if (!same_set) {
        m_prepared = false;
        m_handle_distances.clear();
    }
    snap_handles();
    restart();
}

void Editor::move_handle(int vertex, const Eigen::Vector3d& target) {
    check_target(vertex, target);
    const auto handle =
        std::find_if(m_handles.begin(), m_handles.end(), [&](const Handle& h) { return h.vertex == vertex; });
    if (handle == m_handles.end())
        throw Error(ErrorCode::index_out_of_range, "there is no handle at vertex " + std::to_string(vertex));
    handle->target = target;
    snap_handles();
    restart();
}

void Editor::set_method(std::string_view name) { set_method(make_method(name), std::string(name)); }

void Editor::set_method(std::unique_ptr<Method> method, std::string name) {
    m_method = std::move(method);
    m_method_name = std::move(name);
    m_prepared = false;
    restart();
}

void Editor::set_initialisation(std::string_view text) {
    m_initialisation = Initialisation(text);
    m_prepared = false;
    restart();
}

void Editor::set_option(std::string_view key, std::string_view value) {
    chebnet::set_option(m_options, key, value);
    restart();
}

void Editor::set_positions(const Positions& positions) {
    if (positions.cols() != m_net->vertex_count())
        throw Error(ErrorCode::index_out_of_range, "positions of " + std::to_string(positions.cols()) +
                                                       " vertices do not fit a net of " +
                                                       std::to_string(m_net->vertex_count()));
    if (!positions.allFinite()) throw Error(ErrorCode::non_finite, "a position is not finite");
    m_positions = positions;
    snap_handles();
    restart();
}

void Editor::reset() {
    m_positions = m_net->rest_positions();
    for (Handle& handle : m_handles) handle.target = m_positions.col(handle.vertex);
    restart();
}

void Editor::snap_handles() {
    for (const Handle& handle : m_handles) m_positions.col(handle.vertex) = handle.target;
}

void Editor::prepare() {
    std::vector<int> vertices;
    for (const Handle& handle : m_handles) vertices.push_back(handle.vertex);
    m_method->prepare(*m_net, *m_topology, vertices);
    m_initialisation.prepare(*m_net, vertices);
    m_prepared = true;
}

Status Editor::begin_solve() {
    if (!m_prepared) prepare();
    m_iterations = 0;
    m_elapsed_ms = 0;
    m_reachable = unreachable_pairs().empty();
    if (max_deviation(*m_net, m_positions) >= m_options.threshold) m_initialisation.apply(m_positions);
    return m_method->start(m_positions, m_options, m_reachable);
}

SolveReport Editor::solve(const Budget& budget) {
    Stopwatch watch;
    SolveReport report;
    report.status = m_running ? Status::running : begin_solve();
    while (report.status == Status::running) {
        if (m_iterations >= m_options.max_iterations) {
            report.status = m_reachable ? Status::max_iterations : Status::unreachable;
            break;
        }
        const bool budget_spent = report.iterations >= budget.iterations || watch.milliseconds() >= budget.milliseconds;
        if (budget_spent && report.iterations > 0) break;
        TraceRow row;
        report.status = m_method->iterate(m_positions, row);
        row.iteration = ++m_iterations;
        row.total_ms = m_elapsed_ms + watch.milliseconds();
        report.factorisation_ms += row.factorisation_ms;
        report.trace.push_back(row);
        ++report.iterations;
    }
    m_running = report.status == Status::running;
    report.max_deviation = max_deviation(*m_net, m_positions);
    report.milliseconds = watch.milliseconds();
    m_elapsed_ms += report.milliseconds;
    return report;
}

void Editor::measure_handle_distances() const {
    if (!m_handle_distances.empty() || m_handles.empty()) return;
    for (const Handle& from : m_handles) {
        const std::vector<double> distances = m_topology->distances_from(from.vertex);
        std::vector<double>& row = m_handle_distances.emplace_back();
        for (const Handle& to : m_handles) row.push_back(distances[to.vertex]);
    }
}

std::vector<UnreachablePair> Editor::unreachable_pairs() const {
    measure_handle_distances();
    std::vector<UnreachablePair> pairs;
    for (std::size_t i = 0; i < m_handles.size(); ++i)
        for (std::size_t j = i + 1; j < m_handles.size(); ++j) {
            const double distance = (m_handles[i].target - m_handles[j].target).norm();
            const double reach = m_handle_distances[i][j];
            // A path pulled straight has the same ratio in all its edges, so this is the deviation nothing can avoid.
            const bool off = !(deviation(distance / reach) < m_options.threshold);
            if (off && (distance > reach || are_joined(m_handles[i].vertex, m_handles[j].vertex)))
                pairs.push_back({m_handles[i].vertex, m_handles[j].vertex, distance, reach});
        }
    const auto strain = [](const UnreachablePair& pair) { return std::abs(std::log(pair.distance / pair.reach)); };
    std::stable_sort(pairs.begin(), pairs.end(),
                     [&](const UnreachablePair& a, const UnreachablePair& b) { return strain(a) > strain(b); });
    return pairs;
}

bool Editor::are_joined(int a, int b) const {
    const std::span<const int> neighbours = m_topology->neighbours(a);
    return std::binary_search(neighbours.begin(), neighbours.end(), b);
}

double Editor::handle_error() const {
    double largest = 0;
    for (const Handle& handle : m_handles)
        largest = std::max(largest, (m_positions.col(handle.vertex) - handle.target).norm());
    return largest;
}

}  // namespace chebnet
