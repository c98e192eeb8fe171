#include "page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "../numbers.h"

namespace chebnet::bench {
namespace {

using Cells = std::vector<std::string>;

std::string ms(double value) { return cell(value < 100 ? "%.3g" : "%.0f", value); }
std::string ratio(double value) { return cell("%.2f", value); }

std::string row(const Cells& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += ' ' + cell + " |";
    return text + '\n';
}

std::string table(const Cells& head, const std::vector<Cells>& rows) {
    if (rows.empty()) return "";
    std::string text = row(head) + row(Cells(head.size(), "---"));
    for (const Cells& cells : rows) text += row(cells);
    return text + '\n';
}

std::string section(const std::string& title, const std::string& words, const std::string& tables) {
    return tables.empty() ? "" : "### " + title + "\n\n" + words + "\n\n" + tables;
}

double largest(const std::vector<double>& values) {
    return values.empty() ? std::nan("") : *std::ranges::max_element(values);
}

bool is_solved(const EditResult& edit) { return edit.status == "converged"; }
bool is_solved(const DragResult& drag) { return drag.unsolved_frames == 0; }

/// The results of one method, each beside that of the first method on the same edit.
template <typename Result>
struct Pairs {
    std::string method;
    std::vector<std::pair<const Result*, const Result*>> list;  // first method's, this one's

    /// Over the edits that both have solved.
    template <typename Quantity>
    std::vector<double> ratios(Quantity quantity) const {
        std::vector<double> values;
        for (const auto& [first, other] : list)
            if (is_solved(*first) && is_solved(*other) && quantity(*first) > 0)
                values.push_back(quantity(*other) / quantity(*first));
        return values;
    }
    long solved() const {
        return std::ranges::count_if(list, [](const auto& pair) { return is_solved(*pair.second); });
    }
};

/// Measuring leaves the results of the methods on one edit side by side, in the order of the methods.
template <typename Result>
std::vector<Pairs<Result>> pair_up(const std::vector<std::string>& methods, const std::vector<Result>& results) {
    std::vector<Pairs<Result>> pairs;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        pairs.push_back({methods[m], {}});
        for (std::size_t i = 0; i + methods.size() <= results.size(); i += methods.size())
            pairs.back().list.emplace_back(&results[i], &results[i + m]);
    }
    return pairs;
}

template <typename Result>
double typical_ms(const Result& result) {
    return median(result.ms);
}
template <typename Result>
double slow_ms(const Result& result) {
    return quantile(result.ms, 0.95);
}
template <typename Result>
double bend_of(const Result& result) {
    return result.bend;
}

template <typename Result>
Cells ratio_cells(const Pairs<Result>& pairs) {
    const auto times = pairs.ratios(typical_ms<Result>), bends = pairs.ratios(bend_of<Result>);
    return {ratio(geometric_mean(times)), ratio(largest(times)), ratio(geometric_mean(bends)), ratio(largest(bends))};
}

Cells joined(Cells cells, const Cells& more) {
    cells.insert(cells.end(), more.begin(), more.end());
    return cells;
}

template <typename Result>
std::string ending(const Result& result) {
    return result.fell_back ? result.status + ", fell back" : result.status;
}

// Cold solves.

std::string edit_summary(const Results& results) {
    std::vector<Cells> rows;
    for (const auto& pairs : pair_up(results.methods, results.edits)) {
        if (pairs.list.empty()) continue;
        const auto fell_back = std::ranges::count_if(pairs.list, [](const auto& p) { return p.second->fell_back; });
        const std::string solved = std::to_string(pairs.solved()) + " of " + std::to_string(pairs.list.size());
        rows.push_back(joined(joined({pairs.method, solved}, ratio_cells(pairs)), {std::to_string(fell_back)}));
    }
    return table({"method", "converged", "time, mean", "time, worst", "bend, mean", "bend, worst", "fell back"}, rows);
}

std::string edit_table(const Results& results) {
    std::vector<Cells> rows;
    for (const auto& pairs : pair_up(results.methods, results.edits))
        for (const auto& [first, edit] : pairs.list)
            rows.push_back({edit->edit, std::to_string(edit->vertices), edit->method, ending(*edit),
                            ms(median(edit->ms)), ratio(median(edit->ms) / median(first->ms)),
                            std::to_string(edit->iterations), cell("%.1e", edit->max_dL), cell("%.4f", edit->bend),
                            cell("%.1f°", edit->smallest_angle)});
    std::ranges::stable_sort(rows, {}, [](const Cells& cells) { return cells[0]; });
    return table(
        {"edit", "vertices", "method", "ended", "ms", "time ratio", "iterations", "max dL", "bend", "smallest angle"},
        rows);
}

// Drags.

std::string drag_summary(const Results& results) {
    std::vector<Cells> rows;
    for (const auto& pairs : pair_up(results.methods, results.drags)) {
        if (pairs.list.empty()) continue;
        const auto slow = pairs.ratios(slow_ms<DragResult>);
        const std::string solved = std::to_string(pairs.solved()) + " of " + std::to_string(pairs.list.size());
        rows.push_back(joined({pairs.method, solved, ratio(geometric_mean(slow))}, ratio_cells(pairs)));
    }
    return table(
        {"method", "every frame converged", "95 %, mean", "median, mean", "median, worst", "bend, mean", "bend, worst"},
        rows);
}

std::string drag_table(const Results& results) {
    std::vector<Cells> rows;
    for (const DragResult& drag : results.drags)
        rows.push_back({drag.edit, std::to_string(drag.vertices), drag.method, ms(median(drag.ms)), ms(slow_ms(drag)),
                        cell("%.1e", drag.max_dL), cell("%.4f", drag.bend), std::to_string(drag.unsolved_frames),
                        std::to_string(drag.fallback_frames)});
    return table({"drag", "vertices", "method", "median ms", "95 % ms", "worst max dL", "bend at the end",
                  "frames not converged", "frames that fell back"},
                 rows);
}

// Factorisations.

struct System {
    const KernelResult* ours = nullptr;
    std::map<std::string, const KernelResult*> others;  // by solver

    double ratio_to(const std::string& solver) const {
        const auto found = others.find(solver);
        return found == others.end() ? std::nan("") : median(found->second->ms) / median(ours->ms);
    }
    double ms_of(const std::string& solver) const {
        const auto found = others.find(solver);
        return found == others.end() ? std::nan("") : median(found->second->ms);
    }
};

/// The solvers come together, ours first.
std::vector<System> systems_of(const Results& results) {
    std::vector<System> systems;
    for (const KernelResult& kernel : results.kernels)
        if (kernel.solver == "chebnet")
            systems.push_back({&kernel, {}});
        else
            systems.back().others[kernel.solver] = &kernel;
    return systems;
}

std::string kernel_summary(const Results& results) {
    std::map<std::string, std::map<std::string, std::vector<double>>> ratios;  // by system and other solver
    for (const System& system : systems_of(results))
        for (const auto& [solver, kernel] : system.others)
            ratios[system.ours->system][solver].push_back(system.ratio_to(solver));
    std::vector<Cells> rows;
    for (const auto& [system, by_solver] : ratios)
        for (const auto& [solver, values] : by_solver)
            rows.push_back({system, solver, ratio(geometric_mean(values)), ratio(*std::ranges::min_element(values))});
    return table({"system", "other solver", "its time as a multiple of ours, mean", "worst"}, rows);
}

std::string kernel_table(const Results& results) {
    std::vector<Cells> rows;
    for (const System& system : systems_of(results))
        rows.push_back({system.ours->edit, system.ours->system, std::to_string(system.ours->rows),
                        ms(median(system.ours->ms)), ms(system.ms_of("eigen")), ms(system.ms_of("cholmod")),
                        ratio(system.ratio_to("eigen")), ratio(system.ratio_to("cholmod")),
                        cell("%.1e", system.ours->residual)});
    return table({"net and handles of", "system", "rows", "ms", "Eigen, ms", "CHOLMOD, ms", "Eigen / ours",
                  "CHOLMOD / ours", "our residual"},
                 rows);
}

// Growth.

std::string growth_exponents(const Results& results) {
    std::map<std::pair<std::string, std::string>, std::vector<Point>> points;
    for (const GrowthResult& growth : results.growth)
        points[{growth.series, growth.method}].push_back({static_cast<double>(growth.vertices), median(growth.ms)});
    std::vector<Cells> rows;
    for (const auto& [key, list] : points)
        if (list.size() > 1)
            rows.push_back({key.first, key.second, cell("%.2f", fit_power_law(list).exponent),
                            cell("%.0f", list.front().x) + " … " + cell("%.0f", list.back().x)});
    return table({"edit", "method", "exponent", "vertices"}, rows);
}

std::string growth_table(const Results& results) {
    std::vector<Cells> rows;
    for (const GrowthResult& growth : results.growth)
        rows.push_back({growth.edit, std::to_string(growth.vertices), growth.method, ending(growth),
                        ms(median(growth.ms)), std::to_string(growth.iterations), cell("%.0f", growth.peak_mb)});
    std::string text = table({"edit", "vertices", "method", "ended", "ms", "iterations", "peak memory, MB"}, rows);
    for (const GrowthStop& stop : results.stops)
        text += "- " + stop.edit + " by " + stop.method + " was left out: it would take about " +
                cell("%.0f", stop.predicted_seconds) + " s.\n";
    return text + (results.stops.empty() ? "" : "\n");
}

std::string target_text(const Results& results) {
    const std::string first = results.methods.empty() ? "" : results.methods.front();
    const Machine& machine = results.machine;
    std::string text = "## " + std::string(results.target == "wasm" ? "WebAssembly, in Node" : "Native") + "\n\n" +
                       machine.cpu + "; " + machine.compiler +
                       (machine.blas.empty() ? "" : "; BLAS of CHOLMOD: " + machine.blas) + "\n\n";
    text += section("Cold solves",
                    "Time and bend as parts of those of " + first +
                        " on the same edit in the same run: geometric mean and worst over the edits that both solve.",
                    edit_summary(results) + edit_table(results));
    text += section("Drags",
                    "Handles go to their targets in equal steps, and each frame is solved to the end from the last "
                    "one. Ratios to " +
                        first + " as above.",
                    drag_summary(results) + drag_table(results));
    text +=
        section("Factorisations",
                "Numeric factorisation of one matrix. *block* is the 3V×3V system of a Newton-like step, "
                "*lengths* the E×E system of projection, *laplacian* V×V. Eigen is SimplicialLDLT with AMD, CHOLMOD "
                "its supernodal LLT, both in double precision. The residual ‖Ax − b‖ / ‖b‖ tells the precision of "
                "our factor.",
                kernel_summary(results) + kernel_table(results));
    return text +
           section("Growth",
                   "Cold solves; the exponent of vertices in the time, by least squares of logarithms. Memory is "
                   "the peak of a process of its own, net included.",
                   growth_exponents(results) + growth_table(results));
}

/// What the same work takes in WebAssembly, where both targets were measured.
std::string target_ratios(const Results& native, const Results& wasm) {
    std::map<std::string, double> times;
    std::map<std::string, std::vector<double>> ratios;
    const auto visit = [](const Results& results, auto action) {
        for (const EditResult& edit : results.edits) action("cold solves, " + edit.method, edit.edit, median(edit.ms));
        for (const DragResult& drag : results.drags) action("drags, " + drag.method, drag.edit, median(drag.ms));
        for (const KernelResult& kernel : results.kernels)
            action(kernel.system + " by " + kernel.solver, kernel.edit, median(kernel.ms));
    };
    visit(native, [&](const std::string& kind, const std::string& edit, double time) { times[kind + edit] = time; });
    visit(wasm, [&](const std::string& kind, const std::string& edit, double time) {
        if (const auto found = times.find(kind + edit); found != times.end())
            ratios[kind].push_back(time / found->second);
    });
    std::vector<Cells> rows;
    for (const auto& [kind, values] : ratios)
        rows.push_back({kind, ratio(geometric_mean(values)), ratio(largest(values))});
    const std::string text = table({"", "time in WebAssembly / native, mean", "worst"}, rows);
    if (text.empty()) return "";
    return "## WebAssembly beside native\n\nMeasured one after the other, not in turns: load of the machine shows here "
           "most.\n\n" +
           text;
}

}  // namespace

std::string speed_page(const std::vector<Results>& targets) {
    std::string page =
        "# Speed\n\nTimes are medians of samples between which the methods or solvers took turns, on one thread. "
        "Milliseconds hold for this machine; ratios within one run carry over to others.\n\n";
    for (const Results& results : targets) page += target_text(results);
    if (targets.size() == 2) page += target_ratios(targets[0], targets[1]);
    return page;
}

}  // namespace chebnet::bench
