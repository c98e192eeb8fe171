#include "page_of_figures.h"

#include <cmath>
#include <numbers>
#include <sstream>

#include "io/file.h"
#include "markup.h"
#include "numbers.h"
#include "picture.h"
#include "plots_of_runs.h"

namespace chebnet::bench {
namespace {

constexpr double k_degrees = 180 / std::numbers::pi;

std::string element(const std::string& tag, const std::string& content, const std::string& attributes = "") {
    return '<' + tag + (attributes.empty() ? "" : ' ' + attributes) + '>' + content + "</" + tag + ">\n";
}

std::string file_of_picture(const Figure& figure, const Run& run, const std::string& what) {
    return figure.name + '.' + run.edit + '.' + what + ".png";
}

std::string stage_name(const Snapshot& snapshot) { return "after_stage_" + std::to_string(snapshot.stage); }

/// Stages are what figure 11 shows.
bool shows_stages(const Figure& figure) {
    return figure.variants.size() == 1 && figure.plots.front() == "stages/iteration";
}

// Pictures.

Eigen::AlignedBox3d room_of(const Group& group) {
    Eigen::AlignedBox3d room;
    const auto include = [&room](const Positions& positions) {
        room.extend(Eigen::Vector3d(positions.rowwise().minCoeff()));
        room.extend(Eigen::Vector3d(positions.rowwise().maxCoeff()));
    };
    include(group.runs.front().problem->net.rest_positions());
    for (const Run& run : group.runs) include(run.positions);
    return room;
}

void draw_group(const Figure& figure, const Group& group, const std::string& folder) {
    const Camera camera{room_of(group)};
    const auto draw = [&](const Run& run, const Positions& positions, const std::string& what) {
        draw_net(run.problem->net, positions, run.problem->handles, figure.colouring, camera,
                 folder + '/' + file_of_picture(figure, run, what));
    };
    const Run& first = group.runs.front();
    draw(first, first.problem->net.rest_positions(), "input");
    for (const Run& run : group.runs) draw(run, run.positions, run.variant->name);
    if (shows_stages(figure))
        for (const Snapshot& snapshot : first.snapshots) draw(first, snapshot.positions, stage_name(snapshot));
}

std::string picture(const Figure& figure, const Run& run, const std::string& what, const std::string& caption) {
    const std::string image = "<img loading=\"lazy\" src=\"" + file_of_picture(figure, run, what) + "\" alt=\"\">";
    return element("figure", image + element("figcaption", escaped(caption)));
}

std::string pictures(const Figure& figure, const Group& group) {
    const Run& first = group.runs.front();
    std::string content = picture(figure, first, "input", "input, " + std::to_string(first.vertices()) + " vertices");
    if (shows_stages(figure))
        for (const Snapshot& snapshot : first.snapshots)
            content += picture(figure, first, stage_name(snapshot), "after stage " + std::to_string(snapshot.stage));
    for (const Run& run : group.runs) content += picture(figure, run, run.variant->name, run.variant->label);
    return element("div", content, "class=\"nets\"");
}

// Numbers.

std::string row(const std::string& tag, const std::vector<std::string>& cells) {
    std::string content;
    for (const std::string& cell : cells) content += element(tag, cell);
    return element("tr", content);
}

std::string table(const Group& group) {
    std::string rows = row("th", {"", "vertices", "ended", "iterations", "ms", "max dL", "second differences, L",
                                  "smallest angle", "from the first, L"});
    const Run& first = group.runs.front();
    for (const Run& run : group.runs) {
        const bool is_same_net = run.edit == first.edit;
        rows += row("td", {escaped(run.variant->label) + (run.variant->is_ours ? " (ours)" : ""),
                           std::to_string(run.vertices()), to_string(run.status), std::to_string(run.iterations),
                           cell("%.0f", run.milliseconds), cell("%.2g", run.max_deviation), cell("%.3f", run.bend),
                           cell("%.1f", k_degrees * run.smallest_angle) + "°",
                           is_same_net ? cell("%.3f", distance(run, first)) : "–"});
    }
    return element("table", rows);
}

std::string claim(const Verdict& verdict, const std::vector<Group>& groups) {
    const std::string word = verdict.word();
    std::string content = "<strong>" + escaped(verdict.claim->text) + "</strong> <mark class=\"" +
                          (word == "holds"     ? "holds"
                           : word == "differs" ? "differs"
                                               : "not") +
                          "\">" + word + "</mark> " + std::to_string(verdict.held()) + " of " +
                          std::to_string(verdict.outcomes.size()) + ". <span>" + escaped(verdict.check->criterion) +
                          "</span>";
    std::string numbers;
    for (std::size_t i = 0; i < groups.size(); ++i)
        numbers +=
            element("li", escaped(groups[i].runs.front().edit) + ": " + (verdict.outcomes[i].holds ? "yes" : "no") +
                              ". " + escaped(to_words(verdict.outcomes[i].values, groups[i])));
    if (verdict.held() < static_cast<int>(groups.size()) && *verdict.check->if_not != 0)
        content += " Possible reason: " + escaped(verdict.check->if_not);
    return element("li", content + element("ul", numbers));
}

std::string section(const Result& result) {
    const Figure& figure = *result.figure;
    std::string content = element("h2", figure.place() + ": " + escaped(figure.title));
    std::string claims;
    for (const Verdict& verdict : judge(result)) claims += claim(verdict, result.groups);
    content += element("p", "<em>What to look for on the page:</em> " + escaped(figure.look)) + element("ol", claims);
    for (const Group& group : result.groups)
        content += element("h3", escaped(group.runs.front().edit)) + pictures(figure, group) + table(group);
    content += "<img class=\"plot\" src=\"" + figure.name + ".svg\" alt=\"Plots of " + escaped(figure.title) + "\">\n";
    content += element(
        "p", "<a href=\"" + figure.name + ".csv\">Traces</a>; again with <code>--only " + figure.name + "</code>.");
    return element("section", content, "id=\"" + figure.name + '"');
}

std::string summary(const std::vector<Result>& results) {
    std::string rows = row("th", {"of the paper", "claim", "verdict", "true of"});
    for (const Result& result : results)
        for (const Verdict& verdict : judge(result))
            rows += row("td", {"<a href=\"#" + result.figure->name + "\">" + result.figure->place() + "</a>",
                               escaped(verdict.claim->text), verdict.word(),
                               std::to_string(verdict.held()) + " of " + std::to_string(verdict.outcomes.size())});
    return element("table", rows);
}

constexpr const char* k_head = R"(<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>The paper, figure by figure</title>
<style>
body { font: 15px/1.5 system-ui, sans-serif; max-width: 76rem; margin: 2rem auto; padding: 0 1rem; color: #222; }
h2 { margin-top: 4rem; border-top: 1px solid #ccc; padding-top: 1rem; }
table { border-collapse: collapse; margin: 1rem 0; font-size: 0.9em; }
th, td { border: 1px solid #ddd; padding: 0.2rem 0.6rem; text-align: left; font-variant-numeric: tabular-nums; }
.nets { display: flex; flex-wrap: wrap; gap: 0.5rem; }
.nets figure { margin: 0; width: 15rem; }
.nets img { width: 100%; border: 1px solid #eee; }
figcaption { font-size: 0.85em; color: #555; text-align: center; }
li span, li ul { color: #555; font-size: 0.9em; }
mark { padding: 0 0.4em; border-radius: 0.3em; color: #fff; }
.holds { background: #1a7f37; } .differs { background: #8a6100; } .not { background: #b42318; }
.plot { max-width: 100%; }
</style>
)";

constexpr const char* k_introduction =
    R"(<h1>The paper, figure by figure</h1>
<p>Li, Guo, Wang, Chai, Liu, Fu: <em>Interactive Editing of Discrete Chebyshev Nets</em>, Computer Graphics Forum 41(2),
2022. Each figure that shows the method at work is made again here, on nets of our own of the same size and character, and
each of its claims is asked of every edit by a criterion fixed beforehand. A claim <em>holds</em> if it is true of all
edits, <em>does not hold</em> if of none, and else <em>differs</em>. Figures 1 and 3 show other people's work.</p>
<p>Colours are the paper's: blue edges have dL &lt; 1e-6, red ones dL &gt; 2e-6. Second differences are those of net lines
against rest, RMS. Distances between nets are RMS over vertices, in edge lengths L. Times were taken one after the other on
one thread of one machine; only their ratios mean anything elsewhere. What is marked as ours is no part of the paper's
claims.</p>
)";

std::string csv_of_traces(const Result& result) {
    std::ostringstream csv;
    bool has_header = false;
    for (const Group& group : result.groups)
        for (const Run& run : group.runs) {
            Trace trace;
            for (const Sample& sample : run.samples) trace.push_back(sample.row);
            std::istringstream lines(to_csv(trace));
            std::string line;
            std::getline(lines, line);
            if (!has_header) csv << "edit,variant,vertices," << line << ",longer_share\n";
            has_header = true;
            for (const Sample& sample : run.samples) {
                std::getline(lines, line);
                csv << run.edit << ',' << run.variant->name << ',' << run.vertices() << ',' << line << ','
                    << sample.longer_share << '\n';
            }
        }
    return csv.str();
}

}  // namespace

void write_files(const Result& result, const std::string& folder) {
    const Plots plots = plots_of_runs(*result.figure, result.groups);
    write_file(folder + '/' + result.figure->name + ".svg", to_svg(plots.panels, plots.columns));
    write_file(folder + '/' + result.figure->name + ".csv", csv_of_traces(result));
    for (const Group& group : result.groups) draw_group(*result.figure, group, folder);
}

void write_page(const std::vector<Result>& results, double seconds, const std::string& folder) {
    std::string page = k_head + std::string(k_introduction) + summary(results);
    for (const Result& result : results) page += section(result);
    write_file(folder + "/figures.html", page + element("p", "The run took " + cell("%.0f", seconds) + " s."));
}

}  // namespace chebnet::bench
