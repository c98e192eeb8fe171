#include "edit/length_adapter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "net/measures.h"

namespace chebnet {

namespace {

constexpr double k_exact = 1e-9;  // largest dL
// Beyond one that does not do, the scale grows by this part at least, and by twice as much each time.
constexpr double k_least_growth = 0.002;
// A scale a little smaller does soon or not at all.
constexpr int k_most_iterations = 30;
// Pairs of handles hold others back from so much of the greatest strain on.
constexpr double k_strained = 0.5;

}  // namespace

LengthAdapter::LengthAdapter(const Editor& editor, const std::vector<Handle>& wanted)
    : m_editor(editor.original()),
      m_method(editor.method()),
      m_options(editor.options()),
      m_wanted(editor.handles()),
      m_smallest(m_options.length_scale) {
    want(wanted);
    EditState start = editor.state();
    start.method = k_default_method;
    start.options.threshold = std::min(m_options.threshold, k_exact);
    start.locality.reset();
    start.positions = editor.last_net();
    for (Handle& handle : start.handles)
        if (handle.is_exact()) handle.target = start.positions.col(handle.vertex);
    m_editor.set_state(std::move(start));
    m_net = m_editor.state();
    bound_scale();
    if (m_smallest > m_largest && !(deviation(m_smallest / m_largest) < m_options.threshold))
        m_status = Status::unreachable;
    else
        begin(Trial::rise, std::min(m_smallest, m_largest), m_net);
}

void LengthAdapter::want(const std::vector<Handle>& wanted) {
    std::map<int, Handle*> exact;
    for (Handle& handle : m_wanted)
        if (handle.is_exact()) exact.emplace(handle.vertex, &handle);
    for (const auto& [vertex, target, weight, slides] : wanted) {
        const auto own = exact.find(vertex);
        const std::string name = "handle " + std::to_string(vertex);
        if (own == exact.end()) throw Error(ErrorCode::index_out_of_range, "there is no exact " + name);
        if (!target.allFinite()) throw Error(ErrorCode::non_finite, "the target of " + name + " is not finite");
        own->second->target = target;
    }
}

/// By pairs of handles: no path between two is shorter than their distance, and the edge between two that are joined is
/// as long.
void LengthAdapter::bound_scale() {
    const HandleGraph& graph = m_editor.handle_graph();
    double strain = 1;
    for (int i = 0; i < graph.size(); ++i)
        for (const auto& [j, reach] : graph.neighbours(i)) {
            const double ratio = (m_wanted[i].target - m_wanted[j].target).stableNorm() / reach;
            strain = std::max(strain, ratio);
            const auto joined = m_editor.topology().neighbours(m_wanted[i].vertex);
            if (std::binary_search(joined.begin(), joined.end(), m_wanted[j].vertex))
                m_largest = std::min(m_largest, ratio * m_options.length_scale);
        }
    m_smallest = strain * m_options.length_scale;
}

/// From a net, grown to this scale, with its handles on their way.
void LengthAdapter::begin(Trial trial, double scale, const EditState& from) {
    m_trial = trial;
    m_scale = scale;
    EditState grown = from;
    grown.options.length_scale = scale;
    if (trial == Trial::dip) grown.options.max_iterations = std::min(m_options.max_iterations, k_most_iterations);
    m_editor.set_state(from);
    m_editor.set_state(std::move(grown));
    for (const Handle& handle : m_wanted)
        if (handle.is_exact()) m_editor.drag_handle(handle.vertex, handle.target);
}

AdaptReport LengthAdapter::solve(const Budget& budget) {
    Stopwatch watch;
    const int before = m_iterations;
    while (m_status == Status::running && m_iterations - before < budget.iterations &&
           (m_iterations == before || watch.milliseconds() < budget.milliseconds))
        iterate();
    m_elapsed_ms += watch.milliseconds();
    return {m_status, m_is_found ? m_net.options.length_scale : m_scale, m_iterations, m_elapsed_ms};
}

void LengthAdapter::iterate() {
    const Status status = m_editor.solve({.iterations = 1}).status;
    ++m_iterations;
    if (m_trial == Trial::rest)
        m_status = status == Status::running ? status : Status::converged;
    else if (is_there())
        end_well();
    else if (m_trial == Trial::walk && m_editor.holds_back())
        end_walk();
    else if (status != Status::running)
        end_badly();
}

CornerLimit LengthAdapter::limit() const {
    if (m_options.shear_limit == 0) return CornerLimit();
    return CornerLimit(m_editor.net(), m_options.shear_limit * std::numbers::pi / 180);
}

bool LengthAdapter::is_there() const {
    const Positions& x = m_editor.positions();
    const auto stands = [&](const Handle& handle) {
        return !handle.is_exact() || handle.holds_at(x.col(handle.vertex));
    };
    return std::all_of(m_wanted.begin(), m_wanted.end(), stands) && max_deviation(m_editor.net(), x) < k_exact &&
           limit().largest_lack(x) <= 2 * CornerLimit::k_tolerance;
}

void LengthAdapter::end_well() {
    m_is_found = true;
    m_net = m_editor.state();
    if (m_scale <= (1 + k_precision) * m_smallest) return begin_rest();
    if (m_trial == Trial::rise) return begin(Trial::walk, m_smallest, m_net);
    if (m_trial == Trial::dip) m_dip *= 2;
    begin_dip();
}

/// In the unit of a larger scale the handles stand where they are wanted.
void LengthAdapter::end_walk() {
    const double scale = m_scale * shortfall();
    if (scale < m_net.options.length_scale)
        begin(Trial::land, scale, m_editor.state());
    else
        begin_dip();
}

void LengthAdapter::end_badly() {
    if (m_trial == Trial::walk || m_trial == Trial::land) return begin_dip();
    m_smallest = m_scale;
    if (m_is_found) {
        m_dip = k_precision;
        return m_net.options.length_scale <= (1 + k_precision) * m_smallest ? begin_rest() : begin_dip();
    }
    if (m_smallest >= m_largest) {
        m_status = Status::unreachable;
        return;
    }
    const double growth = std::max(shortfall(), 1 + std::ldexp(k_least_growth, m_failures++));
    begin(Trial::rise, std::min(growth * m_smallest, m_largest), m_editor.state());
}

void LengthAdapter::begin_dip() {
    const double found = m_net.options.length_scale;
    begin(Trial::dip, std::max(found / (1 + m_dip), std::sqrt(m_smallest * found)), m_net);
}

void LengthAdapter::begin_rest() {
    m_trial = Trial::rest;
    m_editor.set_state(m_net);
}

/// By how much the handles that hold others back stand too close to them.
double LengthAdapter::shortfall() const {
    const HandleGraph& graph = m_editor.handle_graph();
    const auto distance = [](const auto& a, const auto& b) { return (a - b).stableNorm(); };
    double largest = 1, greatest_strain = 0;
    const auto each_pair = [&](const auto& visit) {
        for (int i = 0; i < graph.size(); ++i)
            for (const auto& [j, reach] : graph.neighbours(i)) {
                const double wanted = distance(m_wanted[i].target, m_wanted[j].target);
                visit(m_wanted[i].vertex, m_wanted[j].vertex, wanted, wanted / reach);
            }
    };
    each_pair([&](int, int, double, double strain) { greatest_strain = std::max(greatest_strain, strain); });
    const Positions& x = m_editor.positions();
    each_pair([&](int a, int b, double wanted, double strain) {
        if (strain >= k_strained * greatest_strain) largest = std::max(largest, wanted / distance(x.col(a), x.col(b)));
    });
    return largest;
}

EditState LengthAdapter::state() const {
    if (m_status != Status::converged)
        throw Error(ErrorCode::bad_option, "no scale of the lengths has been found with which the handles are met");
    EditState state = m_editor.state();
    state.method = m_method;
    state.options = m_options;
    state.options.length_scale = m_net.options.length_scale;
    return state;
}

}  // namespace chebnet
