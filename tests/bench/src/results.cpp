#include "results.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "io/obj.h"
#include "numbers.h"
#include "plot.h"
#include "report.h"

namespace chebnet::bench {
namespace {

constexpr double k_holds = 0.9, k_fails = 0.5;  // parts of the edits; see the page's introduction
constexpr int k_plotted_cases = 3;
constexpr std::size_t k_named_cases = 4;  // of those that contradict a claim

struct Verdict {
    const Claim* claim;
    int held, asked;
    std::vector<std::string> against;  // the edits that contradict it, with their numbers

    const char* word() const {
        if (asked == 0) return "no data";
        const double part = static_cast<double>(held) / asked;
        return part >= k_holds ? "holds" : part <= k_fails ? "does not hold" : "differs";
    }
    std::string count() const { return std::to_string(held) + " of " + std::to_string(asked); }
};

bool counts(const Experiment& experiment, const Group& group) {
    return group.any_moved() && (!experiment.needs_solution || group.any_converged());
}

std::vector<Verdict> judge(const Result& result) {
    std::vector<Verdict> verdicts;
    for (const Claim& claim : result.experiment->claims) {
        Verdict verdict{&claim, 0, 0, {}};
        for (const Group& group : result.groups) {
            if (!counts(*result.experiment, group)) continue;
            const Outcome outcome = claim.check(group);
            ++verdict.asked;
            verdict.held += outcome.holds;
            if (!outcome.holds) verdict.against.push_back(group.runs.front().edit + " (" + outcome.numbers + ")");
        }
        verdicts.push_back(std::move(verdict));
    }
    return verdicts;
}

std::string in_quotes(const std::string& text) { return '"' + text + '"'; }

std::string traces_csv(const Result& result) {
    std::ostringstream csv;
    bool has_header = false;
    for (const Group& group : result.groups)
        for (const Run& run : group.runs) {
            Trace trace;
            for (const Sample& sample : run.samples) trace.push_back(sample.row);
            std::istringstream lines(to_csv(trace));
            std::string line;
            std::getline(lines, line);
            if (!has_header) csv << "edit,variant,vertices,handles," << line << ",longer_share\n";
            has_header = true;
            for (const Sample& sample : run.samples) {
                std::getline(lines, line);
                csv << in_quotes(run.edit) << ',' << in_quotes(run.variant) << ',' << run.vertices << ',' << run.handles
                    << ',' << line << ',' << sample.longer_share << '\n';
            }
        }
    return csv.str();
}

Json run_json(const Run& run) {
    return {{"edit", run.edit},
            {"variant", run.variant},
            {"vertices", run.vertices},
            {"handles", run.handles},
            {"status", to_string(run.status)},
            {"iterations", run.iterations},
            {"milliseconds", run.milliseconds},
            {"max_dL", run.max_deviation},
            {"bend", run.bend},
            {"max_handle_error", run.handle_error}};
}

Json result_json(const Result& result) {
    const Experiment& experiment = *result.experiment;
    Json json{{"name", experiment.name}, {"figure", experiment.figure}, {"title", experiment.title}};
    json["claims"] = Json::array();
    for (const Verdict& verdict : judge(result))
        json["claims"].push_back({{"claim", verdict.claim->text},
                                  {"criterion", verdict.claim->criterion},
                                  {"verdict", verdict.word()},
                                  {"held", verdict.held},
                                  {"asked", verdict.asked},
                                  {"against", verdict.against}});
    json["runs"] = Json::array();
    for (const Group& group : result.groups)
        for (const Run& run : group.runs) json["runs"].push_back(run_json(run));
    return json;
}

Panel curves(const View& view, const Group& group) {
    Panel panel{group.runs.front().edit, view.x_label, view.y_label, view.log_x, view.log_y, {}};
    for (const Run& run : group.runs) {
        Series series{run.variant, {}};
        for (const Sample& sample : run.samples) series.points.push_back({view.x(run, sample), view.y(run, sample)});
        panel.series.push_back(std::move(series));
    }
    return panel;
}

Panel trend(const View& view, const std::vector<Group>& groups) {
    Panel panel{"", view.x_label, view.y_label, view.log_x, view.log_y, {}};
    for (const Group& group : groups) {
        Series series{group.runs.front().edit, {}};
        for (const Run& run : group.runs)
            if (run.converged()) series.points.push_back({view.x(run, {}), view.y(run, {})});
        panel.series.push_back(std::move(series));
    }
    return panel;
}

/// Some edits below one another, an aspect in each column; trends once, for all.
std::string plot(const Result& result) {
    std::vector<View> curve_views, trend_views;
    for (const View& view : result.experiment->views) (view.is_trend ? trend_views : curve_views).push_back(view);
    std::vector<Panel> panels;
    for (const View& view : trend_views) panels.push_back(trend(view, result.groups));
    if (!trend_views.empty()) return to_svg(panels, static_cast<int>(trend_views.size()));
    int plotted = 0;
    for (const Group& group : result.groups) {
        if (!counts(*result.experiment, group)) continue;
        if (++plotted > k_plotted_cases) break;
        for (const View& view : curve_views) panels.push_back(curves(view, group));
    }
    return to_svg(panels, static_cast<int>(curve_views.size()));
}

/// One line of an experiment's table: a variant over all edits. Ratios are over the edits that both it and the first
/// variant have solved.
std::string variant_row(const Result& result, std::size_t variant) {
    std::vector<double> iterations, times, bends, deviations;
    double handle_error = 0;
    std::map<std::string, int> endings;
    for (const Group& group : result.groups) {
        if (!counts(*result.experiment, group)) continue;
        const Run &run = group.runs[variant], &first = group.runs.front();
        ++endings[to_string(run.status)];
        iterations.push_back(run.iterations);
        deviations.push_back(run.max_deviation);
        handle_error = std::max(handle_error, run.handle_error);
        if (!run.converged() || !first.converged()) continue;
        times.push_back(run.milliseconds / first.milliseconds);
        bends.push_back(run.bend / first.bend);
    }
    std::string ended;
    for (const auto& [status, count] : endings)
        ended += (ended.empty() ? "" : ", ") + std::to_string(count) + ' ' + status;
    return "| " + result.experiment->variants[variant].label + " | " + ended + " | " + cell("%g", median(iterations)) +
           " | " + cell("%.2f", median(times)) + " | " + cell("%.2f", median(bends)) + " | " +
           cell("%.1e", median(deviations)) + " | " + cell("%.2g", handle_error) + " |\n";
}

std::string variant_table(const Result& result) {
    std::string table =
        "| variant | ended | iterations | time | bend | max dL | worst handle error |\n"
        "|---|---|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < result.experiment->variants.size(); ++i) table += variant_row(result, i);
    return table + "\nMedians over the edits; time and bend as multiples of the first variant's.\n\n";
}

std::string joined(const std::vector<std::string>& items, std::size_t limit) {
    std::string text;
    for (std::size_t i = 0; i < std::min(limit, items.size()); ++i) text += (i == 0 ? "" : "; ") + items[i];
    return items.size() > limit ? text + "; and " + std::to_string(items.size() - limit) + " more" : text;
}

std::string claim_text(const Verdict& verdict) {
    std::string text = "**" + verdict.claim->text + "** Criterion: " + verdict.claim->criterion + "  \n→ **" +
                       verdict.word() + "**, true of " + verdict.count() + " edits.";
    if (!verdict.against.empty()) text += " Not of " + joined(verdict.against, k_named_cases) + '.';
    const bool wants_reason = verdict.held < k_holds * verdict.asked && !verdict.claim->if_not.empty();
    if (wants_reason) text += " Possible reason: " + verdict.claim->if_not;
    return text + "\n\n";
}

std::string left_out(const Result& result) {
    std::vector<std::string> names;
    for (const Group& group : result.groups)
        if (!counts(*result.experiment, group)) names.push_back(group.runs.front().edit);
    if (names.empty()) return "";
    return "Left out, since no variant solves them or nothing moves: " + joined(names, names.size()) + ".\n\n";
}

std::string section(const Result& result) {
    const Experiment& experiment = *result.experiment;
    std::string text = "## Figure " + std::to_string(experiment.figure) + ": " + experiment.title + "\n\n";
    for (const Verdict& verdict : judge(result)) text += claim_text(verdict);
    text += left_out(result) + variant_table(result);
    text += "![Plot of " + experiment.title + "](" + experiment.name + ".svg)\n\n";
    return text + "[Traces](" + experiment.name + ".csv), [results](" + experiment.name +
           ".json); again with `--only " + experiment.name + "`.\n\n";
}

std::string summary(const std::vector<Result>& results) {
    std::string table = "| figure | claim | verdict | true of |\n|---|---|---|---|\n";
    for (const Result& result : results)
        for (const Verdict& verdict : judge(result))
            table += "| " + std::to_string(result.experiment->figure) + " | " + verdict.claim->text + " | **" +
                     verdict.word() + "** | " + verdict.count() + " |\n";
    return table + "\n";
}

constexpr const char* k_introduction =
    "# The paper's experiments, on nets of our own\n\n"
    "Li, Guo, Wang, Chai, Liu, Fu: *Interactive Editing of Discrete Chebyshev Nets*, Computer Graphics Forum 41(2), "
    "2022, argues by comparison. Here each of its comparisons is made again with chebnet, on chebnet's own shapes "
    "instead of the paper's nets.\n\n"
    "**How to read this.** Each claim has a criterion that every edit either meets or does not. It *holds* if at least "
    "nine edits in ten meet it, *does not hold* if half of them or fewer do, and otherwise *differs* from net to net. "
    "The program computes the verdicts; nothing has been tuned towards them. An edit named `vault_2000.pull` is the "
    "shape `vault:vertices=2000` with its suggested handles, the last of which is pulled up by a fifth of the net's "
    "size (*bend* tilts it by 45° about the anchors' middle, *spread* moves it away, *twist* carries it around by "
    "60°), "
    "less far where the net is too short for that. Converged means max dL < 1e-6. Methods give up after 200 "
    "iterations; local–global, gradient descent and L-BFGS as competitors after 2,000, ARAP after 500. Times were "
    "taken one after the other "
    "on one thread: only their ratios within one run mean anything.\n\n"
    "**What is ours.** Which topic a figure number stands for, and the wording of the claims, are our reading of the "
    "paper's argument, not quotations; exact numbers of the paper are not compared.\n\n";

}  // namespace

void write_files(const Result& result, const std::string& folder) {
    const std::string stem = folder + '/' + result.experiment->name;
    write_file(stem + ".csv", traces_csv(result));
    write_file(stem + ".json", result_json(result).dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
    write_file(stem + ".svg", plot(result));
}

void write_page(const std::vector<Result>& results, double seconds, const std::string& folder) {
    std::string page = k_introduction + summary(results);
    for (const Result& result : results) page += section(result);
    write_file(folder + "/results.md", page + "The run took " + cell("%.0f", seconds) + " s.\n");
}

}  // namespace chebnet::bench
