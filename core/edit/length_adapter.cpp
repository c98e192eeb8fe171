#include "edit/length_adapter.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "net/measures.h"
#include "solve/parts/corner_limit.h"

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
    if (start.locality)
        throw Error(ErrorCode::bad_option, "with a locality edges do not grow: those beyond it stay as they are");
    start.method = k_default_method;
    start.options.threshold = std::min(m_options.threshold, k_exact);
    start.positions = editor.last_net();
    for (Handle& handle : start.handles)
        if (handle.is_exact()) handle.target = start.positions.col(handle.vertex);
    m_editor.set_state(std::move(start));
    m_net = m_editor.state();
    find_pairs();
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

/// Those of handles that do not slide and, where any does, those with one that does among all exact ones.
void LengthAdapter::find_pairs() {
    const auto add_pairs = [this](const HandleGraph& graph, bool pinned) {
        for (int i = 0; i < graph.size(); ++i)
            for (const auto& [j, reach] : graph.neighbours(i))
                if (const Pair pair{i, j, reach}; i < j && is_pinned(pair) == pinned) m_pairs.push_back(pair);
    };
    add_pairs(m_editor.handle_graph(), true);
    const auto slides = [](const Handle& handle) { return handle.slides != k_no_axes; };
    if (std::none_of(m_wanted.begin(), m_wanted.end(), slides)) return;
    std::vector<int> vertices;
    for (const Handle& handle : m_wanted) vertices.push_back(handle.is_exact() ? handle.vertex : -1);
    add_pairs(HandleGraph(m_editor.net(), m_editor.topology(), vertices), false);
}

bool LengthAdapter::is_pinned(const Pair& pair) const {
    return m_wanted[pair.a].is_pinned() && m_wanted[pair.b].is_pinned();
}

/// Of the coordinates that both hold.
double LengthAdapter::distance(const Pair& pair, const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return across(m_wanted[pair.a].slides | m_wanted[pair.b].slides, a - b).stableNorm();
}

/// By pairs of handles: no path between two is shorter than their distance, and the edge between two that are joined is
/// as long.
void LengthAdapter::bound_scale() {
    double strain = 1;
    for (const Pair& pair : m_pairs) {
        const double ratio = distance(pair, m_wanted[pair.a].target, m_wanted[pair.b].target) / pair.reach;
        strain = std::max(strain, ratio);
        const auto joined = m_editor.topology().neighbours(m_wanted[pair.a].vertex);
        if (is_pinned(pair) && std::binary_search(joined.begin(), joined.end(), m_wanted[pair.b].vertex))
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
    m_editor.change_state(std::move(grown));
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
        end_rest(status);
    else if (is_there())
        end_well();
    else if (m_trial == Trial::walk && m_editor.holds_back())
        end_walk();
    else if (status != Status::running)
        end_badly();
}

bool LengthAdapter::is_there() const {
    const Positions& x = m_editor.positions();
    const auto stands = [&](const Handle& handle) {
        return !handle.is_exact() || handle.holds_at(x.col(handle.vertex));
    };
    return std::all_of(m_wanted.begin(), m_wanted.end(), stands) &&
           max_deviation(m_editor.net(), x) < m_editor.options().threshold &&
           corner_limit(m_editor.net(), m_options).is_kept(x);
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
    // Where the last trial has come to no net, none leads on from there.
    const bool is_net = max_deviation(m_editor.net(), m_editor.positions()) < m_editor.options().threshold;
    begin(Trial::rise, std::min(growth * m_smallest, m_largest), is_net ? m_editor.state() : m_net);
}

void LengthAdapter::begin_dip() {
    const double found = m_net.options.length_scale;
    begin(Trial::dip, std::max(found / (1 + m_dip), std::sqrt(m_smallest * found)), m_net);
}

void LengthAdapter::begin_rest() {
    m_trial = Trial::rest;
    m_editor.set_state(m_net);
}

/// What was found is kept where it has come to nothing better.
void LengthAdapter::end_rest(Status status) {
    if (status == Status::running) return;
    if (!is_there()) m_editor.set_state(m_net);
    m_status = Status::converged;
}

/// By how much the handles that hold others back stand too close to them.
double LengthAdapter::shortfall() const {
    double largest = 1, greatest_strain = 0;
    const auto each_pinned = [this](const auto& visit) {
        for (const Pair& pair : m_pairs) {
            const Handle &a = m_wanted[pair.a], &b = m_wanted[pair.b];
            const double wanted = distance(pair, a.target, b.target);
            if (is_pinned(pair)) visit(a.vertex, b.vertex, wanted, wanted / pair.reach);
        }
    };
    each_pinned([&](int, int, double, double strain) { greatest_strain = std::max(greatest_strain, strain); });
    const Positions& x = m_editor.positions();
    each_pinned([&](int a, int b, double wanted, double strain) {
        if (strain >= k_strained * greatest_strain)
            largest = std::max(largest, wanted / (x.col(a) - x.col(b)).stableNorm());
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
