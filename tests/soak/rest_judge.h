#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <tuple>

#include "../core/first_order.h"
#include "invariants.h"
#include "solve/pull.h"

namespace chebnet::invariants {

/// By how much a diagonal is shorter at most than the limit of its corners allows with rest lengths, in edge lengths;
/// and what the other two edges reach, but for a tenth.
inline double reckoned_lack(const Net& net, const Positions& x, double limit) {
    const Topology topology(net);
    double largest = 0;
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> q = net.faces()[f];
        if (q.size() != 4) continue;
        double side[4], sum = 0;
        for (int k = 0; k < 4; ++k) sum += side[k] = net.rest_lengths()[topology.edge_between(q[k], q[(k + 1) % 4])];
        for (int k = 0; k < 4; ++k) {
            const double a = side[k], b = side[(k + 1) % 4];
            const double reach = std::min(a + b, side[(k + 2) % 4] + side[(k + 3) % 4]);
            const double least = std::min(std::hypot(a - b, 2 * std::sqrt(a * b) * std::sin(limit / 2)), 0.9 * reach);
            largest = std::max(largest, (least - (x.col(q[k]) - x.col(q[(k + 2) % 4])).stableNorm()) / (sum / 4));
        }
    }
    return largest;
}

/// What method `equilibrium` promises with `converged` beside lengths: that no corner is sharper than the limit, and
/// that no force is left which the net could follow. For one editor.
class RestJudge {
public:
    /// After a solve.
    Violations of_solve(const Editor& editor, const SolveReport& report) {
        if (editor.method() != "equilibrium" || report.status != Status::converged) return {};
        Violations violations;
        const Options& options = editor.options();
        const double L = editor.net().mean_length(), size = editor.positions().lpNorm<Eigen::Infinity>();
        const double digits = 1e-15 * size / L;  // of a coordinate, in edge lengths
        const double lack = reckoned_lack(editor.net(), editor.positions(), options.shear_limit);
        if (!(lack <= 2.1e-4 + digits)) violations.push_back(text("a corner is sharper than the limit", lack));

        // A hand that is held back pulls by a force of the editor's own.
        if (editor.holds_back() || !has_rest_shape(editor)) return violations;
        ++m_judged;
        std::vector<Handle> holding = editor.handles();
        // Of a soft handle that is to pull harder than that, it is known that it does not.
        for (Handle& handle : holding)
            if (!handle.is_exact()) handle.weight = std::min(handle.weight, k_most_pull);
        for (const TautVertex& taut : editor.taut_vertices()) {
            const Eigen::Vector3d a = holding[taut.end_a].target, b = holding[taut.end_b].target,
                                  x = editor.positions().col(taut.vertex);
            if (!((a - x).norm() + (x - b).norm() <= (1 + 1e-12) * (a - b).norm() + 1e-12 * size))
                violations.push_back(text("what is taut is not straight", (x - a).norm()));
            holding.push_back({taut.vertex, x});
        }
        const samples::Resting resting{editor.net(),   holding,        options,           editor.guide().get(),
                                       region(editor), &*m_rest_shape, weightless(editor)};
        const double gradient = samples::first_order(resting, editor.positions()).gradient;
        const double stiffness = 30 * (options.bending_weight + options.shear_weight + options.guide_weight);
        const double noise = stiffness * digits * std::sqrt(static_cast<double>(editor.positions().size()));
        if (!(gradient <= 1.1 * options.rest_tolerance + noise))
            violations.push_back(text("a force is left in a net said to be at rest", gradient));
        return violations;
    }

    /// How often the forces were reckoned again.
    int judged() const { return m_judged; }

private:
    static std::string text(const char* otherwise, double by) {
        char number[40];
        std::snprintf(number, sizeof number, " (by %.3g)", by);
        return otherwise + std::string(number);
    }

    static const Region* region(const Editor& editor) { return editor.region() ? &*editor.region() : nullptr; }

    /// V, what lies in pieces of the net of which nothing stays at its height, or is drawn somewhere: no piece falls
    /// for ever.
    static std::vector<bool> weightless(const Editor& editor) {
        const GuideMode mode = editor.options().guide_mode;
        if (editor.guide() && (mode == GuideMode::near || mode == GuideMode::on)) return {};
        std::vector<bool> carries(static_cast<std::size_t>(editor.net().vertex_count()), false);
        for (const Handle& handle : editor.handles())
            carries[handle.vertex] = !has_axis(handle.slides, editor.options().y_up ? 1 : 2);
        if (const Region* held = region(editor)) {
            for (int v : held->outside) carries[v] = true;
            for (const Pull& pull : held->pulls) carries[pull.vertex] = true;
        }
        std::vector<bool> falls(carries.size(), false);
        for (const std::vector<int>& piece : editor.topology().components())
            if (std::ranges::none_of(piece, [&](int v) { return carries[v]; }))
                for (int v : piece) falls[v] = true;
        return falls;
    }

    /// The shape from which energy counts: that of the net without handles, which is opened where its corners are too
    /// sharp. Not known where that does not come to an end without energy.
    bool has_rest_shape(const Editor& editor) {
        const auto key =
            std::tuple(editor.options().threshold, editor.options().shear_limit, editor.net().mean_length());
        if (m_key == key) return m_rest_shape.has_value();
        m_key = key;
        Options options;
        options.threshold = editor.options().threshold;
        options.shear_limit = editor.options().shear_limit;
        options.max_iterations = 1000;
        Editor alone(editor.net());
        EditState state = alone.state();
        state.options = options;
        alone.set_state(std::move(state));
        const SolveReport report = alone.solve();
        const double energy = report.trace.empty() ? 0 : report.trace.back().energy;
        m_rest_shape.reset();
        if (report.status == Status::converged && energy < 1e-12) m_rest_shape = alone.positions();
        return m_rest_shape.has_value();
    }

    std::optional<std::tuple<double, double, double>> m_key;  // of the rest shape
    std::optional<Positions> m_rest_shape;
    int m_judged = 0;
};

}  // namespace chebnet::invariants
