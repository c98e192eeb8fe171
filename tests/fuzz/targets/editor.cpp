#include "edit/editor.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <utility>

#include "arbitrary.h"
#include "change/change.h"
#include "core/sample_nets.h"
#include "core/sample_surfaces.h"
#include "edit/exact_change.h"
#include "edit/flip.h"
#include "edit/length_adapter.h"
#include "edit/rest_search.h"
#include "require.h"
#include "soak/invariants.h"
#include "soak/rest_judge.h"

using namespace chebnet;

namespace {

Net net_of(Mesh mesh) { return Net(std::move(mesh.positions), std::move(mesh.faces)); }

constexpr int k_net_kinds = 7;

/// Small nets of many kinds: open, closed, with singular vertices, in pieces, with edges of different lengths, of any
/// scale, or of places that no mesher would choose.
Net any_net(int kind, FuzzedDataProvider& input) {
    switch (kind) {
        case 0:
            return samples::cube();
        case 1:
            return samples::ring(input.ConsumeIntegralInRange(3, 7), input.ConsumeIntegralInRange(3, 6),
                                 input.ConsumeBool());
        case 2:
            return samples::mixed_mesh();
        case 3: {
            Mesh mesh = fuzz::any_patch(input);
            mesh.positions *= std::ldexp(1.0, input.ConsumeIntegralInRange(-1074, 1023));
            return net_of(std::move(mesh));
        }
        case 4:
            return net_of(fuzz::any_patch(input));
        default:
            return samples::patch(input.ConsumeIntegralInRange(2, 8), input.ConsumeIntegralInRange(2, 6));
    }
}

/// Nets do not grow beyond this many vertices.
constexpr int k_most_vertices = 200;

/// An editor in any hands: every call, in any order, with any arguments. What is to hold is asked after each.
class Hands {
public:
    Hands(Net net, FuzzedDataProvider& input) : m_input(input), m_editor(std::move(net)) {}

    void make_calls() {
        for (int calls = 0; calls < 40 && m_input.remaining_bytes() > 0; ++calls) make_call();
    }

    /// Those as well that act on an editor from outside, or need more than a vertex and a number.
    void make_calls_of_all_kinds() {
        for (int calls = 0; calls < 40 && m_input.remaining_bytes() > 0; ++calls)
            if (m_input.ConsumeBool())
                make_call();
            else
                make_larger_call();
    }

private:
    void make_call() {
        switch (m_input.ConsumeIntegralInRange(0, 12)) {
            case 0:
                return attempt("set_handles", [&] { m_editor.set_handles(any_handles()); });
            case 1:
                return attempt("move_handle", [&] { move_any_handle(); });
            case 2:
                return attempt("set_locality",
                               [&] { m_editor.set_locality(fuzz::any_number(m_input), any_vertices()); });
            case 3:
                return attempt("set_method", [&] { m_editor.set_method(any_method()); });
            case 4:
                return attempt("set_option", [&] { set_any_option(); });
            case 5:
                return attempt("set_initialisation", [&] { m_editor.set_initialisation(any_initialisation()); });
            case 6:
                return attempt("set_positions", [&] { m_editor.set_positions(any_positions()); });
            case 7:
                return attempt("reset", [&] { m_editor.reset(); });
            case 8:
                return attempt("queries", [&] { ask(); });
            case 9:
                return attempt("move", [&] { m_editor = Editor(std::move(m_editor)); });
            case 10:
                return attempt("drag_handle", [&] { drag_any_handle(); });
            case 11:
                return attempt("release_handles", [&] { m_editor.release_handles(); });
            default:
                return solve();
        }
    }

    void make_larger_call() {
        switch (m_input.ConsumeIntegralInRange(0, 5)) {
            case 0:
                return attempt("set_guide", [&] { m_editor.set_guide(any_guide()); });
            case 1:
                return attempt("set_state", [&] { go_to_any_state(); });
            case 2:
                return attempt("drag_handle along axes",
                               [&] { drag_any_handle(m_input.ConsumeIntegralInRange(-1, 8)); });
            case 3:
                return attempt("adapt lengths", [&] { adapt_lengths(); });
            case 4:
                return attempt("flip", [&] {
                    m_editor.set_positions(flipped(m_editor.net(), m_editor.handles(), m_editor.positions()));
                });
            default:
                return attempt("change", [&] { change_net(); });
        }
    }

    /// A call other than solve().
    template <class Call>
    void attempt(const char* name, Call call) {
        note(name);
        const invariants::Snapshot before(m_editor);
        try {
            call();
        } catch (const Error& error) {
            note(error.what());
            fuzz::require_readable(error);
            judge(invariants::of_refused_call(before, invariants::Snapshot(m_editor)));
        }
        judge(invariants::of_state(m_editor));
    }

    void solve() {
        const Budget budget{m_input.ConsumeIntegralInRange(0, 12)};
        const Positions before = m_editor.positions();
        note("solve with a budget of " + std::to_string(budget.iterations));
        const SolveReport report = m_editor.solve(budget);
        note(std::string("  ") + to_string(report.status) + " after " + std::to_string(report.iterations));
        judge(invariants::of_solve(m_editor, report, budget, before));
        judge(m_rest.of_solve(m_editor, report));
    }

    void ask() {
        const auto handles = m_editor.handles();
        if (std::any_of(handles.begin(), handles.end(), [](const Handle& handle) { return handle.is_exact(); }))
            require(flipped(m_editor.net(), handles, m_editor.positions()).allFinite(), "flipped out of bounds");
        for (const float mobility : m_editor.mobility(3, any_vertices()))
            require(mobility >= 0 && mobility <= 1, "a mobility is out of range");
        for (const UnreachablePair& pair : m_editor.unreachable_pairs())
            require(pair.vertex_a != pair.vertex_b && pair.distance >= 0 && pair.reach >= 0, "an odd pair");
        for (const Ball& ball : m_editor.reach(any_vertex()))
            require(ball.centre.allFinite() && ball.radius >= 0, "an odd ball");
        if (m_editor.method() == k_default_method) search_rest();
    }

    /// What is found has all that the net has; the editor stays as it is.
    void search_rest() {
        RestSearch search(m_editor);
        const RestSearchReport report = search.solve({.iterations = 60});
        note(std::string("  search: ") + to_string(report.status));
        require(report.done >= 0 && report.done <= 1, "an odd part of a search is done");
        if (report.status != Status::converged) return;
        const EditState found = search.state();
        require(report.energy < report.energy_before, "what is found has no less energy");
        require(invariants::reckoned_deviation(m_editor.net(), found.positions) < 1e-6, "what is found is no net");
        for (const Handle& handle : found.handles)
            require(!handle.is_exact() || handle.holds_at(found.positions.col(handle.vertex)),
                    "what is found leaves a handle");
    }

    /// To one of before, or the present one, with something changed. What it says is then the state.
    void go_to_any_state() {
        m_states.push_back(m_editor.state());
        EditState state = m_states[m_input.ConsumeIntegralInRange<std::size_t>(0, m_states.size() - 1)];
        change_any_part_of(state);
        m_editor.set_state(std::move(state));
        const EditState now = m_editor.state();
        m_editor.set_state(now);
        require(m_editor.state() == now, "a state that an editor is set to is not its state");
    }

    void change_any_part_of(EditState& state) {
        switch (m_input.ConsumeIntegralInRange(0, 7)) {
            case 0:
                state.handles = any_handles();
                break;
            case 1:
                state.method = any_method();
                break;
            case 2:
                state.initialisation = any_initialisation();
                break;
            case 3:
                state.options.length_scale = fuzz::any_number(m_input);
                break;
            case 4:
                state.locality = {fuzz::any_number(m_input), any_vertices(),
                                  m_input.ConsumeBool() ? any_positions() : Positions()};
                break;
            case 5:
                state.guide = any_guide();
                break;
            case 6:
                state.positions = any_positions();
                break;
            default:
                break;
        }
    }

    /// Lets edges grow until some of the handles are met.
    void adapt_lengths() {
        std::vector<Handle> wanted;
        for (const Handle& handle : m_editor.handles())
            if (m_input.ConsumeBool()) wanted.push_back({handle.vertex, any_target(handle.vertex)});
        LengthAdapter adapter(m_editor, wanted);
        AdaptReport report;
        for (int calls = 0; calls < 4 && report.status == Status::running; ++calls)
            report = adapter.solve({m_input.ConsumeIntegralInRange(1, 20)});
        note(std::string("  ") + to_string(report.status) + " at " + std::to_string(report.scale));
        require(std::isfinite(report.scale) && report.scale > 0, "an odd scale");
        m_editor.set_state(adapter.state());  // refused unless it has converged
        require(invariants::reckoned_deviation(m_editor.net(), m_editor.positions()) < 1e-6,
                "edges that have grown have not their length");
        for (Handle handle : wanted) {
            handle.slides = slides_of(handle.vertex);
            require(handle.holds_at(m_editor.positions().col(handle.vertex)), "a handle that was wanted is not met");
        }
    }

    Axes slides_of(int vertex) const {
        const auto held = std::ranges::find(m_editor.handles(), vertex, &Handle::vertex);
        return held->slides;
    }

    /// Goes on with a net that has other faces, as exact as the one before.
    void change_net() {
        const std::vector<ChangeInfo>& table = change_table();
        const ChangeInfo& info = table[m_input.ConsumeIntegralInRange<std::size_t>(0, table.size() - 1)];
        note(info.name);
        const ChangePlace place{any_vertices(), any_edges()};
        ChangedMesh changed = info.make(m_editor.net(), place);
        const Faces faces = changed.mesh.faces;
        ExactChangeOptions options;
        if (m_input.ConsumeBool()) options.length = m_editor.net().mean_length();
        options.held = any_vertices();
        ExactChange exact(std::move(changed), std::move(options));
        ExactChangeReport report;
        for (int calls = 0; calls < 4 && report.status == Status::running; ++calls)
            report = exact.solve({m_input.ConsumeIntegralInRange(1, 20)});
        require(exact.positions().allFinite(), "a changed net is not finite");
        if (report.status != Status::converged || exact.positions().cols() > k_most_vertices) return;
        m_editor = Editor(Net(exact.positions(), faces));
        m_rest = {};
        m_states.clear();
    }

    // ------------------------------------------------------------------------------------------------------ arguments

    /// Most often one that exists, and rather one that is held.
    int any_vertex() {
        if (!m_editor.handles().empty() && m_input.ConsumeBool())
            return m_editor.handles()[m_input.ConsumeIntegralInRange<std::size_t>(0, m_editor.handles().size() - 1)]
                .vertex;
        return m_input.ConsumeIntegralInRange(-1, m_editor.net().vertex_count());
    }

    std::vector<int> any_vertices() {
        std::vector<int> vertices;
        for (int count = m_input.ConsumeIntegralInRange(0, 3); count > 0; --count) vertices.push_back(any_vertex());
        return vertices;
    }

    std::vector<int> any_edges() {
        std::vector<int> edges;
        for (int count = m_input.ConsumeIntegralInRange(0, 8); count > 0; --count)
            edges.push_back(m_input.ConsumeIntegralInRange(-1, m_editor.net().edge_count()));
        return edges;
    }

    /// None, the one of before, the net's own faces as they rest, a plane, or one that no surface should be.
    std::shared_ptr<const Guide> any_guide() {
        const Net& net = m_editor.net();
        switch (m_input.ConsumeIntegralInRange(0, 4)) {
            case 0:
                return nullptr;
            case 1:
                return m_editor.guide();
            case 2:
                return std::make_shared<const Guide>(Surface({net.rest_positions(), net.faces()}));
            case 3:
                return std::make_shared<const Guide>(Surface(samples::plane(3, 5 * net.mean_length())));
            default:
                return std::make_shared<const Guide>(Surface(fuzz::any_patch(m_input)));
        }
    }

    /// At rest, not far from it, or anywhere.
    Eigen::Vector3d any_target(int vertex) {
        const int kind = m_input.ConsumeIntegralInRange(0, 3);
        if (kind == 0) return {fuzz::any_number(m_input), fuzz::any_number(m_input), fuzz::any_number(m_input)};
        Eigen::Vector3d target = m_editor.net().rest_positions().col(vertex);
        if (kind == 1) return target;
        for (double& x : target) x += m_editor.net().mean_length() * m_input.ConsumeFloatingPointInRange(-2.0, 2.0);
        return target;
    }

    std::vector<Handle> any_handles() {
        std::vector<Handle> handles;
        for (int count = m_input.ConsumeIntegralInRange(0, 5); count > 0; --count) {
            const int vertex = m_input.ConsumeIntegralInRange(0, m_editor.net().vertex_count() - 1);
            handles.push_back({vertex, any_target(vertex)});
            const int kind = m_input.ConsumeIntegralInRange(0, 3);
            if (kind == 0) handles.back().weight = fuzz::any_number(m_input);
            if (kind == 1) handles.back().slides = m_input.ConsumeIntegralInRange(-1, 8);
        }
        return handles;
    }

    std::string any_method() {
        const auto table = method_table();
        const auto choice = m_input.ConsumeIntegralInRange<std::size_t>(0, table.size());
        return choice < table.size() ? table[choice].name : "none";
    }

    std::string any_initialisation() {
        const char* name = m_input.PickValueInArray({"naive", "arap", "local_global", "none"});
        const int iterations = m_input.ConsumeIntegralInRange(-1, 6);
        return iterations < 0 ? name : std::string(name) + ":" + std::to_string(iterations);
    }

    void move_any_handle() {
        const int vertex = any_vertex();
        m_editor.move_handle(vertex, any_target(std::clamp(vertex, 0, m_editor.net().vertex_count() - 1)));
    }

    void drag_any_handle(Axes along = k_all_axes) {
        const int vertex = any_vertex();
        m_editor.drag_handle(vertex, any_target(std::clamp(vertex, 0, m_editor.net().vertex_count() - 1)), along);
    }

    void set_any_option() {
        const auto table = option_table();
        const OptionInfo& info = table[m_input.ConsumeIntegralInRange<std::size_t>(0, table.size() - 1)];
        double value = m_input.PickValueInArray({info.smallest, info.largest, 0.0});
        if (value == 0) value = fuzz::any_number(m_input);
        if (info.kind == OptionKind::integer) value = std::round(value);
        char text[64];
        std::snprintf(text, sizeof text, "%.17g", value);
        note(std::string(info.name) + " = " + text);
        m_editor.set_option(info.name, text);
    }

    Positions any_positions() {
        Positions positions = m_editor.net().rest_positions();
        if (m_input.ConsumeIntegralInRange(0, 15) == 0) positions.conservativeResize(3, positions.cols() - 1);
        const int kind = m_input.ConsumeIntegralInRange(0, 3);
        if (kind == 0) positions *= fuzz::any_number(m_input);  // may overflow: then it is to be refused
        if (kind == 1)
            for (int changes = m_input.ConsumeIntegralInRange(1, 4); changes > 0; --changes)
                positions.reshaped()[m_input.ConsumeIntegralInRange<Eigen::Index>(0, positions.size() - 1)] =
                    fuzz::any_number(m_input);
        if (kind == 2)
            for (double& x : positions.reshaped())
                x += m_editor.net().mean_length() * m_input.ConsumeFloatingPointInRange(-1.0, 1.0);
        return positions;
    }

    // ------------------------------------------------------------------------------------------------------- judgement

    void note(std::string line) { m_story.push_back(std::move(line)); }

    void require(bool holds, const char* otherwise) const {
        if (!holds) judge({otherwise});
    }

    void judge(const invariants::Violations& violations) const {
        if (violations.empty()) return;
        for (const std::string& line : m_story) std::fprintf(stderr, "%s\n", line.c_str());
        for (const std::string& violation : violations) std::fprintf(stderr, "VIOLATED: %s\n", violation.c_str());
        std::fprintf(stderr, "(method %s, begins %s, threshold %g, %td handles, %d vertices, mean edge %g)\n",
                     m_editor.method().c_str(), m_editor.initialisation().c_str(), m_editor.options().threshold,
                     std::ssize(m_editor.handles()), m_editor.net().vertex_count(), m_editor.net().mean_length());
        std::abort();
    }

    FuzzedDataProvider& m_input;
    Editor m_editor;
    invariants::RestJudge m_rest;
    std::vector<EditState> m_states;   // of the net, in which it once was
    std::vector<std::string> m_story;  // told when something is violated
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider input(data, size);
    std::optional<Net> net;
    // Inputs that were kept before there were larger calls go on meaning what they did.
    const int choice = input.ConsumeIntegralInRange(0, 2 * k_net_kinds - 1);
    try {
        net = any_net(choice % k_net_kinds, input);
    } catch (const Error& error) {
        fuzz::require_readable(error);
        return 0;
    }
    Hands hands(std::move(*net), input);
    if (choice >= k_net_kinds)
        hands.make_calls_of_all_kinds();
    else
        hands.make_calls();
    return 0;
}
