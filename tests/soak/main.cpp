// Edits nets at random, far beyond what a hand would do, and judges every result from outside; see invariants.h.
// Prints what became of the edits, and of each violation how to repeat it. Exit code 1 if there was one.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "edits.h"
#include "invariants.h"
#include "net/measures.h"
#include "nets.h"
#include "rest_judge.h"
#include "solve/method.h"

namespace chebnet::soak {
namespace {

/// Of one edit, before it is left to come to its end.
constexpr int k_most_frames = 60;

struct Plan {
    int edits = 2000;
    int sequence = 20;  // edits of one net, from rest on, each where the one before has left it
    std::uint64_t seed = 1;
    int vertices = 1000;
    std::vector<std::string> methods = {"equilibrium", "projection", "li2022"};
    std::vector<std::string> only;
    std::string show;
};

using Counts = std::map<Status, int>;

/// All there are, in their order: the compiler sees to it that to_string() knows each.
std::vector<Status> statuses() {
    std::vector<Status> all;
    for (Status status{}; to_string(status) != std::string_view("unknown");
         status = Status(static_cast<int>(status) + 1))
        all.push_back(status);
    return all;
}

struct Tally {
    std::map<std::string, Counts> statuses;  // by "method, edit"
    Counts all;
    int converged = 0, below_1 = 0, below_5 = 0;  // edits, and those of them with a corner as acute in degrees
    int judged_at_rest = 0;                       // those of them by `equilibrium` whose rest was reckoned again
    int homecomings = 0, strays = 0;              // edits back to rest, and those of them that did not converge
    std::vector<double> milliseconds;
    double worst_ratio = 0, worst_ms = 0;
    std::string worst_net;
    int violations = 0;
};

void count_angles(const Editor& editor, Tally& tally) {
    const double degrees = corner_angle_range(editor.net(), editor.positions()).smallest * 180 / EIGEN_PI;
    ++tally.converged;
    if (degrees < 1) ++tally.below_1;
    if (degrees < 5) ++tally.below_5;
}

void count(const Editor& editor, const EditKind& edit, const std::string& method, const SolveReport& report,
           Tally& tally) {
    ++tally.statuses[method + ", " + edit.name][report.status];
    ++tally.all[report.status];
    if (report.status == Status::converged) count_angles(editor, tally);
    if (std::string_view(edit.name) != "go home") return;
    ++tally.homecomings;
    if (report.status != Status::converged) ++tally.strays;
}

void count_times(std::vector<double> times, const std::string& net, Tally& tally) {
    tally.milliseconds.insert(tally.milliseconds.end(), times.begin(), times.end());
    std::sort(times.begin(), times.end());
    const double median = times[times.size() / 2], worst = times.back();
    if (worst > tally.worst_ms) tally.worst_ms = worst, tally.worst_net = net;
    if (median > 0) tally.worst_ratio = std::max(tally.worst_ratio, worst / median);
}

/// What `after` puts elsewhere than they are.
std::vector<Handle> going(const Editor& editor, std::vector<Handle> after) {
    std::erase_if(after, [&](const Handle& handle) {
        return std::ranges::any_of(editor.handles(), [&](const Handle& before) { return before == handle; });
    });
    return after;
}

/// Brings handles there in some manner, judging each frame. Returns the report of the last.
SolveReport edit(Editor& editor, std::vector<Handle> handles, const Manner& manner, invariants::RestJudge& rest,
                 invariants::Violations& violations) {
    const auto frame = [&](const Budget& budget) {
        const Positions before = editor.positions();
        SolveReport report = editor.solve(budget);
        for (std::string& violation : invariants::of_solve(editor, report, budget, before))
            violations.push_back(std::move(violation));
        for (std::string& violation : rest.of_solve(editor, report)) violations.push_back(std::move(violation));
        return report;
    };
    const std::vector<Handle> changed = going(editor, handles);
    if (manner.radius > 0 && changed.size() == 1) editor.set_locality(manner.radius, std::vector{changed[0].vertex});
    if (manner.drags) {
        for (const Handle& handle : changed) {
            editor.drag_handle(handle.vertex, handle.target, manner.along);
            if (manner.iterations > 0) frame({.iterations = manner.iterations});
        }
        editor.release_handles();
    } else if (manner.radius > 0) {
        for (const Handle& handle : changed) editor.move_handle(handle.vertex, handle.target);
    } else {
        editor.set_handles(std::move(handles));
    }
    SolveReport report;
    double milliseconds = 0;
    report.status = Status::running;
    for (int k = 0; manner.iterations > 0 && k < k_most_frames && report.status == Status::running; ++k) {
        report = frame({.iterations = manner.iterations});
        milliseconds += report.milliseconds;
    }
    if (report.status == Status::running) report = frame({});
    report.milliseconds += milliseconds;
    return report;
}

/// One net, one method: a sequence that depends on nothing but its seed.
void edit_net(const NetKind& kind, const std::string& method, std::uint64_t seed, const Plan& plan, Tally& tally) {
    Random random(seed);
    Editor editor(kind.make(random));
    EditState state = editor.state();
    state.method = method;
    state.options = random_behaviour(random);
    state.handles = random_handles(editor.net(), method, random);
    editor.set_state(std::move(state));
    const auto tell = [&](int i, const EditKind& edit, const SolveReport& report, const std::string& what) {
        std::printf(
            "edit %d, %s, ends %s after %d iterations with max dL %.2g%s\n    "
            "again: --net \"%s\" --vertices %d --method %s --seed %llu --edits 1\n",
            i, edit.name, to_string(report.status), report.iterations, report.max_deviation, what.c_str(),
            kind.name.c_str(), plan.vertices, method.c_str(), static_cast<unsigned long long>(seed));
    };
    std::vector<double> times;
    invariants::RestJudge rest;
    for (int i = 0; i < plan.sequence; ++i) {
        const EditKind& kind_of_edit = random_edit_kind(random);
        std::vector<Handle> handles = kind_of_edit.move(editor, random);
        invariants::Violations violations;
        const SolveReport report = edit(editor, std::move(handles), random_manner(random), rest, violations);
        times.push_back(report.milliseconds);
        count(editor, kind_of_edit, method, report, tally);
        tally.violations += static_cast<int>(violations.size());
        for (const std::string& violation : violations) tell(i, kind_of_edit, report, ", VIOLATED: " + violation);
        if (plan.edits == 1 || plan.show == to_string(report.status)) tell(i, kind_of_edit, report, "");
    }
    const std::string net = kind.name + " of " + std::to_string(editor.net().vertex_count()) + " vertices, " + method;
    count_times(std::move(times), net, tally);
    tally.judged_at_rest += rest.judged();
}

void print(const Tally& tally) {
    std::printf("%-28s", "");
    for (const Status status : statuses()) std::printf("%15s", to_string(status));
    std::printf("\n");
    const auto row = [](const std::string& name, const Counts& counts) {
        std::printf("%-28s", name.c_str());
        for (const Status status : statuses()) std::printf("%15d", counts.contains(status) ? counts.at(status) : 0);
        std::printf("\n");
    };
    for (const auto& [name, counts] : tally.statuses) row(name, counts);
    row("all", tally.all);
    std::vector<double> times = tally.milliseconds;
    std::sort(times.begin(), times.end());
    std::printf("milliseconds: median %.2f, 99 %% %.1f, worst %.0f (%s); worst over the median of its net: %.0f\n",
                times[times.size() / 2], times[times.size() * 99 / 100], tally.worst_ms, tally.worst_net.c_str(),
                tally.worst_ratio);
    const auto percent = [](int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0.0; };
    std::printf("smallest angle of converged edits: %.0f %% below 1°, %.0f %% below 5°\n",
                percent(tally.below_1, tally.converged), percent(tally.below_5, tally.converged));
    std::printf("nets at rest, reckoned again: %d\n", tally.judged_at_rest);
    std::printf("edits back to rest that do not converge: %d of %d\n", tally.strays, tally.homecomings);
    std::printf("invariants violated: %d\n", tally.violations);
}

/// About 0.6 of `count`, and coprime to it: steps of it reach all, and few of them some of all parts of the list.
std::size_t stride(std::size_t count) {
    std::size_t step = std::max<std::size_t>(1, count * 3 / 5);
    while (std::gcd(step, count) > 1) ++step;
    return step;
}

int run(const Plan& plan) {
    std::vector<NetKind> kinds = net_kinds(plan.vertices);
    for (const std::string& name : plan.only)
        if (std::ranges::none_of(kinds, [&](const NetKind& kind) { return kind.name == name; })) {
            std::fprintf(stderr, "chebnet_soak: there are no nets of the name \"%s\"; known are", name.c_str());
            for (const NetKind& kind : kinds) std::fprintf(stderr, " \"%s\"", kind.name.c_str());
            std::fprintf(stderr, "\n");
            return 2;
        }
    if (!plan.only.empty())
        std::erase_if(kinds, [&](const NetKind& kind) {
            return std::find(plan.only.begin(), plan.only.end(), kind.name) == plan.only.end();
        });
    Tally tally;
    const std::size_t nets = static_cast<std::size_t>((plan.edits - 1) / plan.sequence + 1), count = kinds.size();
    for (std::size_t i = 0; i < nets; ++i) {
        const NetKind& kind = kinds[i * stride(count) % count];
        const std::string& method = plan.methods[(i % count + i / count) % plan.methods.size()];
        edit_net(kind, method, plan.seed + i, plan, tally);
    }
    print(tally);
    return tally.violations > 0 ? 1 : 0;
}

std::vector<std::string> names_of_methods() {
    std::vector<std::string> names;
    for (const MethodInfo& info : method_table()) names.emplace_back(info.name);
    return names;
}

}  // namespace
}  // namespace chebnet::soak

int main(int argc, char** argv) {
    using chebnet::soak::names_of_methods;
    chebnet::soak::Plan plan;
    CLI::App app("Edits nets at random and judges the results.");
    app.add_option("--edits", plan.edits, "How many; 1: one sequence, told edit by edit")
        ->check(CLI::Range(1, 1'000'000'000));
    app.add_option("--sequence", plan.sequence, "Edits of one net")->check(CLI::Range(1, 1'000'000'000));
    app.add_option("--seed", plan.seed, "Of the first sequence; each has the next");
    app.add_option("--vertices", plan.vertices, "How large a net may be")->check(CLI::Range(100, 1'000'000));
    app.add_option("--method", plan.methods, "Instead of equilibrium, projection and li2022 in turn")
        ->check(CLI::IsMember(names_of_methods()));
    app.add_option("--net", plan.only, "Only nets of this name");
    app.add_option("--show", plan.show, "Tell of each edit that ends with this status");
    CLI11_PARSE(app, argc, argv);
    std::printf("soak: %d edits, seed %llu\n", plan.edits, static_cast<unsigned long long>(plan.seed));
    return chebnet::soak::run(plan);
}
