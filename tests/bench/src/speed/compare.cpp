#include "compare.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "../numbers.h"

namespace chebnet::bench {
namespace {

constexpr double k_least_change = 0.05;  // of a time, as part of it
constexpr double k_least_bend_change = 0.01;

/// What is compared of a measurement.
struct Row {
    std::vector<double> ms;
    bool is_drag = false;
    std::string ending = "";
    double bend = 0;
};

using Rows = std::map<std::string, Row>;  // by section, method or solver, and edit

Rows rows_of(const Results& results) {
    Rows rows;
    for (const KernelResult& kernel : results.kernels)
        rows["kernels " + kernel.system + ' ' + kernel.solver + "  " + kernel.edit] = {kernel.ms};
    for (const EditResult& edit : results.edits)
        rows["edits " + edit.method + "  " + edit.edit] = {edit.ms, false, edit.status, edit.bend};
    for (const DragResult& drag : results.drags)
        rows["drags " + drag.method + "  " + drag.edit] = {
            drag.ms, true, std::to_string(drag.unsolved_frames) + " frames not converged", drag.bend};
    for (const GrowthResult& growth : results.growth)
        rows["growth " + growth.method + "  " + growth.edit] = {growth.ms, false, growth.status};
    return rows;
}

std::string section_of(const std::string& name) { return name.substr(0, name.find("  ")); }

struct Difference {
    double ratio;
    bool is_noise;
};

/// Samples of the same thing: the medians, and the spread around them.
Difference compare_samples(const std::vector<double>& before, const std::vector<double>& after) {
    const double a = median(before), b = median(after);
    const double noise = std::max(k_least_change * a, spread(before) + spread(after));
    return {b / a, std::abs(b - a) <= noise};
}

/// The frames of a drag are different work: each is compared with itself.
Difference compare_frames(const std::vector<double>& before, const std::vector<double>& after) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) ratios.push_back(after[i] / before[i]);
    const double ratio = median(ratios);
    return {ratio, std::abs(ratio - 1) <= std::max(k_least_change, spread(ratios))};
}

std::string differences(const Row& before, const Row& after, const Difference& change) {
    std::string text;
    if (!change.is_noise)
        text += "  " + formatted("%.3g", median(before.ms)) + " -> " + formatted("%.3g", median(after.ms)) + " ms (" +
                formatted("%.2f", change.ratio) + " times)";
    if (before.ending != after.ending) text += "  " + before.ending + " -> " + after.ending;
    if (std::abs(after.bend - before.bend) > k_least_bend_change * before.bend)
        text += "  bend " + formatted("%.4f", before.bend) + " -> " + formatted("%.4f", after.bend);
    return text;
}

std::string machine_differences(const Results& before, const Results& after) {
    std::string text;
    const auto add = [&](const std::string& what, const std::string& a, const std::string& b) {
        if (a != b) text += "Not the same " + what + ": " + a + " and " + b + '\n';
    };
    add("target", before.target, after.target);
    add("CPU", before.machine.cpu, after.machine.cpu);
    add("compiler", before.machine.compiler, after.machine.compiler);
    return text;
}

}  // namespace

std::string compare(const Results& before, const Results& after) {
    const Rows old_rows = rows_of(before), new_rows = rows_of(after);
    std::map<std::string, std::vector<double>> ratios;  // by section and method or solver
    std::ostringstream text;
    text << machine_differences(before, after);
    std::size_t same = 0, matched = 0;
    for (const auto& [name, row] : new_rows) {
        const auto found = old_rows.find(name);
        if (found == old_rows.end()) continue;
        ++matched;
        const Row& old_row = found->second;
        const Difference change =
            row.is_drag ? compare_frames(old_row.ms, row.ms) : compare_samples(old_row.ms, row.ms);
        ratios[section_of(name)].push_back(change.ratio);
        const std::string found_differences = differences(old_row, row, change);
        if (found_differences.empty())
            ++same;
        else
            text << name << found_differences << '\n';
    }
    text << same << " of " << matched << " measurements are the same within noise; only in the first file "
         << old_rows.size() - matched << ", only in the second " << new_rows.size() - matched << ".\n";
    for (const auto& [section, values] : ratios)
        text << section << ": time in the second as part of the first, geometric mean of " << values.size() << ": "
             << formatted("%.3f", geometric_mean(values)) << '\n';
    return text.str();
}

}  // namespace chebnet::bench
