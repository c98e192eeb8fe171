#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "../numbers.h"
#include "base/error.h"
#include "base/stopwatch.h"
#include "measure.h"
#include "open_net.h"

namespace chebnet::bench {
namespace {

using Json = nlohmann::json;

constexpr double k_longest_solve_ms = 60e3;    // larger sizes are left out
constexpr double k_longest_repeats_ms = 10e3;  // of one size: then no more repeats
constexpr double k_guessed_exponent = 1.5;     // while there is only one size to go by

std::string read_all(int pipe) {
    std::string text;
    std::array<char, 4096> buffer;
    for (ssize_t count; (count = read(pipe, buffer.data(), buffer.size())) > 0;)
        text.append(buffer.data(), static_cast<std::size_t>(count));
    close(pipe);
    return text;
}

[[noreturn]] void run_child(const std::function<Json()>& action, int pipe) {
    int code = EXIT_FAILURE;
    try {
        const std::string text = action().dump();
        if (write(pipe, text.data(), text.size()) == static_cast<ssize_t>(text.size())) code = EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::cerr << "speed: " << error.what() << std::endl;
    }
    _exit(code);
}

/// What the action gives, and the peak of its memory in MB. The action's result must fit into a pipe (64 kB).
std::pair<Json, double> in_own_process(const std::function<Json()>& action) {
    std::array<int, 2> ends;
    if (pipe(ends.data()) != 0) throw Error(ErrorCode::file_access, "cannot make a pipe");
    const pid_t child = fork();
    if (child < 0) throw Error(ErrorCode::file_access, "cannot start a process");
    if (child == 0) run_child(action, ends[1]);
    close(ends[1]);
    const std::string text = read_all(ends[0]);
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    if (status != 0) throw Error(ErrorCode::file_access, "a measurement broke off, perhaps for lack of memory");
    return {Json::parse(text), static_cast<double>(usage.ru_maxrss) / 1024};
}

GrowthResult solve_once(const Task& task, const std::string& method) {
    const auto [json, peak_mb] = in_own_process([&]() -> Json {
        Editor editor(open_net(task.net));
        editor.set_method(method);
        editor.set_handles(task.handles);
        const Stopwatch watch;
        const SolveReport report = editor.solve();
        const double ms = watch.milliseconds();
        return GrowthResult{task.edit,         task.series,       method, task.vertices, to_string(report.status),
                            report.iterations, fell_back(report), 0,      {ms}};
    });
    GrowthResult result = json;
    result.peak_mb = peak_mb;
    return result;
}

/// The methods take turns, as elsewhere; one that has taken long does not take many.
std::vector<GrowthResult> solve_in_turns(const Task& task, const std::vector<std::string>& methods, int repeats) {
    std::vector<GrowthResult> results;
    for (const std::string& method : methods) results.push_back(solve_once(task, method));
    for (int repeat = 1; repeat < repeats; ++repeat)
        for (GrowthResult& result : results) {
            if (std::reduce(result.ms.begin(), result.ms.end()) > k_longest_repeats_ms) continue;
            const GrowthResult again = solve_once(task, result.method);
            result.ms.push_back(again.ms.front());
            result.peak_mb = std::max(result.peak_mb, again.peak_mb);
        }
    return results;
}

double predicted_ms(const std::vector<Point>& points, double vertices) {
    if (points.empty()) return 0;
    if (points.size() == 1) return points[0].y * std::pow(vertices / points[0].x, k_guessed_exponent);
    return fit_power_law(std::span(points).last(2))(vertices);
}

}  // namespace

void measure_growth(const Plan& plan, Results& results) {
    std::map<std::pair<std::string, std::string>, std::vector<Point>> points;  // vertices, ms by series and method
    for (const Task& task : plan.tasks) {
        if (task.section != "growth") continue;
        std::cerr << "  growth  " << task.edit << std::endl;
        std::vector<std::string> quick_enough;
        for (const std::string& method : plan.methods) {
            const double expected = predicted_ms(points[{task.series, method}], task.vertices);
            if (expected > k_longest_solve_ms)
                results.stops.push_back({task.edit, task.series, method, expected / 1000});
            else
                quick_enough.push_back(method);
        }
        for (GrowthResult& result : solve_in_turns(task, quick_enough, plan.repeats)) {
            points[{task.series, result.method}].push_back({static_cast<double>(result.vertices), median(result.ms)});
            results.growth.push_back(std::move(result));
        }
    }
}

}  // namespace chebnet::bench
