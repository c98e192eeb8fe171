#include "plots_of_runs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "energy/direct_energy.h"
#include "energy/power_energy.h"

namespace chebnet::bench {
namespace {

/// Iterations of the initialisation, which the curves begin with.
int start_iterations(const Run& run) {
    return static_cast<int>(std::ranges::count_if(run.samples, [](const Sample& s) { return s.row.stage == 0; }));
}

using Quantity = double (*)(const Run&, const Sample&);

double iteration(const Run& run, const Sample& sample) { return sample.row.iteration + start_iterations(run); }
double time_ms(const Run&, const Sample& sample) { return sample.row.total_ms; }
double deviation(const Run&, const Sample& sample) { return sample.row.max_deviation; }
double energy(const Run&, const Sample& sample) { return sample.row.energy; }
double longer_percent(const Run&, const Sample& sample) { return 100 * sample.longer_share; }
double free_vertices(const Run&, const Sample& sample) { return sample.row.free_vertices; }

Panel curves(const Group& group, const char* x_label, const char* y_label, bool log_y, Quantity x, Quantity y) {
    Panel panel{group.runs.front().edit, x_label, y_label, false, log_y, {}};
    for (const Run& run : group.runs) {
        Series series{run.variant->label, {}};
        for (const Sample& sample : run.samples) series.points.push_back({x(run, sample), y(run, sample)});
        const int start = start_iterations(run);
        if (start > 0) series.circles.push_back(series.points[static_cast<std::size_t>(start) - 1]);
        panel.series.push_back(std::move(series));
    }
    return panel;
}

Panel by_iteration(const Group& g) { return curves(g, "iteration", "max dL", true, iteration, deviation); }
Panel by_time(const Group& g) { return curves(g, "ms, this run", "max dL", true, time_ms, deviation); }
Panel energies_of_run(const Group& g) { return curves(g, "iteration", "energy", true, iteration, energy); }
Panel longer(const Group& g) {
    return curves(g, "iteration", "edges longer than L, %", false, iteration, longer_percent);
}
Panel free_by_iteration(const Group& g) {
    return curves(g, "iteration", "free vertices", false, iteration, free_vertices);
}
Panel frame_times(const Group& g) { return curves(g, "frame", "ms a frame, this run", true, iteration, time_ms); }

/// With a dotted line where each stage of the first run begins.
Panel stages_by_iteration(const Group& group) {
    Panel panel = by_iteration(group);
    const Run& run = group.runs.front();
    for (std::size_t k = 1; k < run.samples.size(); ++k)
        if (run.samples[k].row.stage != run.samples[k - 1].row.stage)
            panel.lines.push_back(iteration(run, run.samples[k - 1]));
    return panel;
}

/// Shares of the corners' angles, in steps of 5°.
Panel angles(const Group& group) {
    constexpr int k_bins = 36;
    Panel panel{group.runs.front().edit, "corner angle, degrees", "corners, %", false, false, {}};
    for (const Run& run : group.runs) {
        std::array<double, k_bins> count{};
        double corners = 0;
        const Net& net = run.problem->net;
        for (int f = 0; f < net.face_count(); ++f) {
            const auto face = net.faces()[f];
            const std::size_t size = face.size();
            for (std::size_t i = 0; i < size; ++i) {
                const auto at = [&](std::size_t k) { return run.positions.col(face[(i + k) % size]); };
                const Eigen::Vector3d a = at(size - 1) - at(0), b = at(1) - at(0);
                const double angle = std::atan2(a.cross(b).norm(), a.dot(b)) / std::numbers::pi;
                ++count[static_cast<std::size_t>(std::min(k_bins - 1.0, std::floor(k_bins * angle)))];
                ++corners;
            }
        }
        Series series{run.variant->label, {}};
        for (int bin = 0; bin < k_bins; ++bin)
            series.points.push_back({(bin + 0.5) * 180 / k_bins, 100 * count[static_cast<std::size_t>(bin)] / corners});
        panel.series.push_back(std::move(series));
    }
    return panel;
}

/// A curve for each edit, a point for each variant.
Panel growth(const std::vector<Group>& groups) {
    Panel panel{"", "vertices", "ms, this run", true, true, {}};
    for (const Group& group : groups) {
        Series series{group.runs.front().edit, {}};
        for (const Run& run : group.runs)
            if (run.converged()) series.points.push_back({static_cast<double>(run.vertices()), run.milliseconds});
        panel.series.push_back(std::move(series));
    }
    return panel;
}

Series function(const std::string& key, const EdgeEnergy& energy) {
    Series series{key, {}};
    for (int i = 0; i <= 150; ++i) {
        const double r = 0.5 + 0.01 * i, value = energy.value(r);
        if (value <= 2) series.points.push_back({r, value});
    }
    return series;
}

/// Figure 6, of the energies that the methods minimise.
std::vector<Panel> energies_of_an_edge() {
    Panel difference{"p = 4", "length / L", "energy", false, false, {}};
    difference.series.push_back(function("dL^p", DirectEnergy(4)));
    difference.series.push_back(function("F^new, p = 4", PowerEnergy(4)));
    Panel exponents{"F^new", "length / L", "energy", false, false, {}};
    for (const int p : {2, 4, 10, 20, 50})
        exponents.series.push_back(function("F^new, p = " + std::to_string(p), PowerEnergy(p)));
    return {difference, exponents};
}

struct PlotOfEdit {
    const char* name;
    Panel (*draw)(const Group& group);
};
constexpr PlotOfEdit k_plots[] = {
    {"deviation/iteration", by_iteration}, {"deviation/ms", by_time},    {"stages/iteration", stages_by_iteration},
    {"energy/iteration", energies_of_run}, {"longer/iteration", longer}, {"free/iteration", free_by_iteration},
    {"frame_ms/frame", frame_times},       {"angles", angles},
};

}  // namespace

Plots plots_of_runs(const Figure& figure, const std::vector<Group>& groups) {
    Plots plots{{}, std::max(1, static_cast<int>(figure.plots.size()))};
    if (figure.plots == std::vector<std::string>{"energies"}) return {energies_of_an_edge(), 2};
    for (const Group& group : groups)
        for (const std::string& name : figure.plots) {
            if (name == "ms/vertices") continue;
            const auto* plot =
                std::ranges::find(k_plots, name, [](const PlotOfEdit& each) { return std::string(each.name); });
            if (plot == std::end(k_plots)) throw Error(ErrorCode::bad_option, "there is no plot \"" + name + "\"");
            plots.panels.push_back(plot->draw(group));
        }
    if (std::ranges::count(figure.plots, "ms/vertices") > 0) plots.panels.push_back(growth(groups));
    return plots;
}

}  // namespace chebnet::bench
