#include "checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "energy/direct_energy.h"
#include "energy/power_energy.h"
#include "numbers.h"

namespace chebnet::bench {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_degrees = 180 / std::numbers::pi;
constexpr double k_near = 1e-2;       // max dL at which the paper changes the exponent
constexpr double k_threshold = 1e-6;  // ε_3
// Times closer than this are the same: less than what repeats from run to run.
constexpr double k_time_noise = 1.03;
// Distances of nets, RMS, in edge lengths.
constexpr double k_other = 0.1, k_similar = 0.5, k_same = 0.05;
constexpr double k_collapsed = 5;         // degrees
constexpr double k_interactive_ms = 500;  // section 1

// What is read off a run.

double iterations(const Run& run) { return run.converged() ? run.iterations : k_infinity; }
double milliseconds(const Run& run) { return run.converged() ? run.milliseconds : k_infinity; }
double max_deviation(const Run& run) { return run.max_deviation; }
double bend(const Run& run) { return run.bend; }

double iterations_to(const Run& run, double deviation) {
    for (const Sample& sample : run.samples)
        if (sample.row.max_deviation < deviation) return sample.row.iteration;
    return k_infinity;
}
double iterations_to_near(const Run& run) { return iterations_to(run, k_near); }
double iterations_from_near(const Run& run) {
    return run.converged() ? run.iterations - iterations_to(run, k_near) : k_infinity;
}
double largest_longer_share(const Run& run) {
    double share = 0;
    for (const Sample& sample : run.samples) share = std::max(share, sample.longer_share);
    return share;
}
double median_frame_ms(const Run& run) {
    std::vector<double> times;
    for (const Sample& sample : run.samples) times.push_back(sample.row.total_ms);
    return median(times);
}
/// Max dL when so much time had passed.
double deviation_at(const Run& run, double ms) {
    double deviation = k_infinity;
    for (const Sample& sample : run.samples)
        if (sample.row.total_ms <= ms) deviation = sample.row.max_deviation;
    return deviation;
}
/// Vertices that may move when the third stage begins; all, if it never does.
double free_in_third_stage(const Run& run) {
    for (const Sample& sample : run.samples)
        if (sample.row.stage == 3) return sample.row.free_vertices;
    return run.vertices();
}
double fixed_in_third_stage(const Run& run) { return run.vertices() - free_in_third_stage(run); }

// What several checks have in common.

std::vector<Value> values_of(const Group& group, double (*quantity)(const Run&), const char* unit) {
    std::vector<Value> values;
    for (const Run& run : group.runs) values.push_back({run.variant->name, quantity(run), unit});
    return values;
}

/// Whether a quantity is finite and no more under the first variant than under each of the others.
Outcome no_more_than(const Group& group, double (*quantity)(const Run&), const char* unit,
                     const std::vector<std::string>& variants, double slack = 1) {
    Outcome outcome{true, {}};
    const double first = quantity(group[variants.front()]);
    for (const std::string& variant : variants) {
        const double value = quantity(group[variant]);
        outcome.holds = outcome.holds && first < k_infinity && first <= slack * value;
        outcome.values.push_back({variant, value, unit});
    }
    return outcome;
}

Outcome no_longer_than(const Group& group, const std::vector<std::string>& variants) {
    return no_more_than(group, milliseconds, "ms", variants, k_time_noise);
}

Outcome both(Outcome a, const Outcome& b) {
    a.holds = a.holds && b.holds;
    a.values.insert(a.values.end(), b.values.begin(), b.values.end());
    return a;
}

/// How far the converged nets of the paper's variants are from the first of them.
std::vector<Value> distances(const Group& group) {
    const Run* first = nullptr;
    std::vector<Value> values;
    for (const Run& run : group.runs) {
        if (!run.converged() || run.variant->is_ours) continue;
        if (first == nullptr)
            first = &run;
        else
            values.push_back({run.variant->name, distance(run, *first), "L"});
    }
    return values;
}

Outcome within(const Group& group, double most) {
    const std::vector<Value> values = distances(group);
    return {!values.empty() && std::ranges::all_of(values, [most](const Value& v) { return v.value <= most; }), values};
}

double smallest_distance(const Group& group) {
    double smallest = k_infinity;
    for (std::size_t i = 0; i < group.runs.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) smallest = std::min(smallest, distance(group.runs[i], group.runs[k]));
    return smallest;
}

/// Whether `good` is true of the ratios from 1/4 to 4 for every exponent of the paper.
bool true_of_energies(bool (*good)(double p, double r)) {
    for (const double p : {2.0, 4.0, 8.0, 10.0, 20.0, 50.0, 75.0})
        for (double r = 0.25; r <= 4; r *= 1.001)
            if (!good(p, r)) return false;
    return true;
}

constexpr const char* k_step_length =
    "Near the solution the paper's majorizer has the radial weight p(3p − 1) where the energy's own Hessian has 2p², "
    "so "
    "its steps are about two thirds of what is needed; composite majorization takes the whole step there.";

const Check k_checks[] = {
    {"all_converge", "Every variant ends with max dL below its threshold.", "", false,
     [](const Group& g) {
         return Outcome{std::ranges::all_of(g.runs, &Run::converged), values_of(g, max_deviation, "dL")};
     }},
    {"solved_in_164_ms", "Li et al. 2022 converges within 164 ms on this machine.", "", true,
     [](const Group& g) {
         const double ms = milliseconds(g["paper"]);
         return Outcome{ms <= 164, {{"paper", ms, "ms"}, {"ours", milliseconds(g["ours"]), "ms"}}};
     }},
    {"drags_at_paper_rate",
     "In a drag of 60 frames every frame converges, and the median frame takes at most 40 ms at up to 6,000 vertices, "
     "100 ms above.",
     "The paper's times are those of eight cores and a vendor's library; these are of one thread, and every frame "
     "is solved to the end.",
     false,
     [](const Group& g) {
         const Run& run = g["paper"];
         const double ms = median_frame_ms(run), most = run.vertices() <= 6000 ? 40 : 100;
         return Outcome{run.converged() && ms <= most,
                        {{"paper", 1000 / ms, "frames"}, {"ours", 1000 / median_frame_ms(g["ours"]), "frames"}}};
     }},
    {"new_net_takes_longer",
     "To deform the surface and make a net on it takes longer than the edit by Li et al. 2022, and longer than half a "
     "second.",
     "Ten minutes are what the paper's authors measured with another program.", true,
     [](const Group& g) {
         const Run& run = g["deformed"];
         const double ms = run.new_net ? run.milliseconds + run.new_net->milliseconds : k_infinity;
         return Outcome{ms > milliseconds(g["paper"]) && ms > k_interactive_ms,
                        {{"deformed", ms, "ms"},
                         {"paper", milliseconds(g["paper"]), "ms"},
                         {"ours", milliseconds(g["ours"]), "ms"}}};
     }},
    {"new_net_has_other_singular_vertices", "The new net has not as many singular vertices as the net that was edited.",
     "", false,
     [](const Group& g) {
         const Run& run = g["deformed"];
         const int before = singular_vertices(run.problem->net);
         const int after = run.new_net ? singular_vertices(run.new_net->net) : 0;
         return Outcome{run.new_net && after != before,
                        {{"deformed", static_cast<double>(after), "vertices"},
                         {"paper", static_cast<double>(before), "vertices"}}};
     }},
    {"new_net_is_near", "Its mean distance from the deformed surface is less than that of each edited net.", "", false,
     [](const Group& g) {
         const Run& run = g["deformed"];
         const auto edited = [&](const char* variant) {
             return mean_distance(run.problem->net, g[variant].positions, run);
         };
         const double near =
             run.new_net ? mean_distance(run.new_net->net, run.new_net->net.rest_positions(), run) : k_infinity;
         return Outcome{near < edited("paper") && near < edited("ours"),
                        {{"deformed", near, "L"}, {"paper", edited("paper"), "L"}, {"ours", edited("ours"), "L"}}};
     }},
    {"shapes_differ", "Any two of the nets are at least 0.1 L apart, RMS over vertices.", "", false,
     [](const Group& g) {
         return Outcome{smallest_distance(g) >= k_other, distances(g)};
     }},
    {"shapes_alike", "Those that converge are no more than 0.5 L from the first, RMS over vertices.",
     "Equal lengths leave the shear free (figure 4): another way there ends at another net.", false,
     [](const Group& g) { return within(g, k_similar); }},
    {"shapes_same", "Those that converge are no more than 0.05 L from the first, RMS over vertices.", "", false,
     [](const Group& g) { return within(g, k_same); }},
    {"local_global_is_behind", "After the time that Li et al. 2022 needs, local–global is at max dL > 1e-6.",
     "An iteration of local–global is two triangular solves and costs a small part of one with a factorisation.", true,
     [](const Group& g) {
         const double ms = milliseconds(g["paper"]), left = deviation_at(g["local_global"], ms);
         return Outcome{ms < k_infinity && left > k_threshold, {{"paper", ms, "ms"}, {"local_global", left, "dL"}}};
     }},
    {"local_global_stays_above", "After 2,000 iterations local–global is at max dL > 1e-6.",
     "It converges linearly, and given enough iterations it does arrive.", false,
     [](const Group& g) {
         const Run& run = g["local_global"];
         return Outcome{!run.converged(),
                        {{"local_global", run.max_deviation, "dL"}, {"local_global", iterations(run), "iterations"}}};
     }},
    {"proposition_1", "r^p + r^−p − 2 ≥ (r + 1/r − 2)^p for r from 1/4 to 4 and every p of the paper; both 0 at r = 1.",
     "", false,
     [](const Group&) {
         return Outcome{true_of_energies([](double p, double r) {
                            return PowerEnergy(p).value(r) >= DirectEnergy(p).value(r) &&
                                   PowerEnergy(p).value(1) == 0 && DirectEnergy(p).value(1) == 0;
                        }),
                        {}};
     }},
    {"steeper_near_one", "For p = 4, at r = 0.9 and 1.1, its slope is at least ten times that of dL^p.", "", false,
     [](const Group&) {
         const auto times = [](double r) { return PowerEnergy(4).slope(r) / DirectEnergy(4).slope(r); };
         return Outcome{std::min(times(0.9), times(1.1)) >= 10, {{"", times(0.9), "times"}, {"", times(1.1), "times"}}};
     }},
    {"large_p_controls_length", "At r = 0.9 and 1.1, F^new_p grows with p, for every p of the paper.", "", false,
     [](const Group&) {
         bool grows = true;
         double before = 0;
         for (const double p : {2.0, 4.0, 8.0, 10.0, 20.0, 50.0, 75.0}) {
             const double value = std::min(PowerEnergy(p).value(0.9), PowerEnergy(p).value(1.1));
             grows = grows && value > before;
             before = value;
         }
         return Outcome{grows, {}};
     }},
    {"new_energy_gets_farther", "At the limit of iterations, max dL is smaller under the new energy.",
     "The paper does not say how it makes the Hessian of E_p positive; here it is the majorizer of the split at r = 1, "
     "whose "
     "steps near the solution are whole ones, where the paper's own are two thirds.",
     false,
     [](const Group& g) {
         return no_more_than(g, max_deviation, "dL", {"new", "direct"});
     }},
    {"composite_lengthens",
     "Under composite majorization at least 90 % of the edges are too long at some iteration, and more than under Li "
     "et al. 2022 at any.",
     "", false,
     [](const Group& g) {
         const double composite = largest_longer_share(g["composite"]), paper = largest_longer_share(g["paper"]);
         return Outcome{composite >= 0.9 && composite > paper,
                        {{"composite", composite, "share"}, {"paper", paper, "share"}}};
     }},
    {"composite_takes_longer", "Li et al. 2022 converges in no more iterations.", k_step_length, false,
     [](const Group& g) {
         return no_more_than(g, iterations, "iterations", {"paper", "composite"});
     }},
    {"composite_is_noisy", "Its second differences, against those at rest, are larger (RMS in units of L).", "", false,
     [](const Group& g) {
         return no_more_than(g, bend, "L", {"paper", "composite"});
     }},
    {"small_p_begins_faster", "p = 2 reaches max dL < 1e-2 in no more iterations than p = 50.", "", false,
     [](const Group& g) {
         return no_more_than(g, iterations_to_near, "iterations", {"p_2", "p_50"});
     }},
    {"small_p_ends_slower", "p = 50 goes from max dL < 1e-2 to 1e-6 in no more iterations than p = 2.", "", false,
     [](const Group& g) {
         return no_more_than(g, iterations_from_near, "iterations", {"p_50", "p_2"});
     }},
    {"adaptive_p_is_best", "It converges, in no more iterations than any fixed exponent.", "", false,
     [](const Group& g) {
         return no_more_than(g, iterations, "iterations", {"adaptive", "p_2", "p_4", "p_10", "p_50"});
     }},
    {"most_are_fixed", "When the third stage begins, at least half of the vertices are fixed.", "", false,
     [](const Group& g) {
         const Run& run = g["paper"];
         Outcome outcome{fixed_in_third_stage(run) >= 0.5 * run.vertices(),
                         {{"paper", fixed_in_third_stage(run), "vertices"}}};
         for (const Snapshot& snapshot : run.snapshots)
             if (snapshot.stage == 2)
                 outcome.values.push_back({"paper", static_cast<double>(edges_at_rest_since(run, snapshot)), "edges"});
         return outcome;
     }},
    {"reduction_saves_time", "It converges, in no more time than without (3 % are noise).",
     "The last iterations become cheap, but a new part of the net has to be ordered and factored, and sometimes more "
     "iterations are needed.",
     true,
     [](const Group& g) {
         return no_longer_than(g, {"paper", "without"});
     }},
    {"reduction_changes_little", "The nets with and without are no more than 0.05 L apart, RMS over vertices.", "",
     false,
     [](const Group& g) {
         const double apart = distance(g["paper"], g["without"]);
         return Outcome{apart <= k_same, {{"paper", apart, "L"}}};
     }},
    {"literal_reduction_ends_well", "With the vertices of the third stage chosen once, the solve converges.",
     "Fixed vertices take from the others what they would need.", false,
     [](const Group& g) {
         return Outcome{g["paper"].converged(), {{"paper", g["paper"].max_deviation, "dL"}}};
     }},
    {"three_stages", "The trace has the stages 1, 2 and 3 in this order, and ends below 1e-6.", "", false,
     [](const Group& g) {
         const Run& run = g["paper"];
         Outcome outcome{run.converged() && run.snapshots.size() == 2, {}};
         for (const Snapshot& snapshot : run.snapshots) {
             const auto ended = [&](const Sample& s) { return s.row.stage == snapshot.stage; };
             outcome.values.push_back(
                 {"paper", static_cast<double>(std::ranges::count_if(run.samples, ended)), "iterations"});
         }
         return outcome;
     }},
    {"threshold_times", "They take at most 1.37 and 1.74 times as long as 1e-6 (3 % are noise).", "", true,
     [](const Group& g) {
         const double base = milliseconds(g["epsilon_1e-6"]);
         const double first = milliseconds(g["epsilon_1e-8"]) / base, second = milliseconds(g["epsilon_1e-10"]) / base;
         return Outcome{first <= 1.37 * k_time_noise && second <= 1.74 * k_time_noise,
                        {{"epsilon_1e-8", first, "times"}, {"epsilon_1e-10", second, "times"}}};
     }},
    {"larger_p_is_faster", "p = 50 converges in no more iterations than p = 20.", "", false,
     [](const Group& g) {
         Outcome outcome = no_more_than(g, iterations, "iterations", {"p_50", "p_20"});
         outcome.values.push_back({"p_75", iterations(g["p_75"]), "iterations"});
         return outcome;
     }},
    {"p_75_breaks", "With p = 75 the solve does not converge.",
     "Here dL and its powers are computed without cancellation near r = 1, steps that overflow are halved, and the "
     "large exponent is used only once all edges are within a tenth of their length.",
     false,
     [](const Group& g) {
         return Outcome{!g["p_75"].converged(), {{"p_75", g["p_75"].max_deviation, "dL"}}};
     }},
    {"smaller_epsilon_4_fixes_fewer", "Vertices fixed in the third stage: ε₃/25 ≤ ε₃/4 ≤ ε₃, and not all the same.", "",
     false,
     [](const Group& g) {
         const double few = fixed_in_third_stage(g["twentyfifth"]), some = fixed_in_third_stage(g["quarter"]);
         const double many = fixed_in_third_stage(g["whole"]);
         return Outcome{few <= some && some <= many && few < many, values_of(g, fixed_in_third_stage, "vertices")};
     }},
    {"quarter_is_fastest", "It converges, in no more time than with ε₃ and ε₃/25 (3 % are noise).", "", true,
     [](const Group& g) {
         return no_longer_than(g, {"quarter", "whole", "twentyfifth"});
     }},
    {"adaptive_p_saves_time", "Both take no more time than Reduction, and Adaptive p no more than Neither.", "", true,
     [](const Group& g) {
         return both(no_longer_than(g, {"both", "reduction"}), no_longer_than(g, {"adaptive_p", "neither"}));
     }},
    {"reduction_saves_time_twice", "Both take no more time than Adaptive p, and Reduction no more than Neither.",
     "On nets of some thousand vertices the third stage has few iterations to save.", true,
     [](const Group& g) {
         return both(no_longer_than(g, {"both", "adaptive_p"}), no_longer_than(g, {"reduction", "neither"}));
     }},
    {"time_grows", "Dense takes more time than Middle, and that more than Sparse.", "", true,
     [](const Group& g) {
         const double sparse = milliseconds(g["sparse"]), middle = milliseconds(g["middle"]);
         const double dense = milliseconds(g["dense"]);
         return Outcome{sparse < middle && middle < dense && dense < k_infinity, values_of(g, milliseconds, "ms")};
     }},
    {"competitors_fall_short", "Li et al. 2022 converges; each other one ends above 1e-6 or takes more time.",
     k_step_length, true,
     [](const Group& g) {
         Outcome outcome{g["paper"].converged(), {}};
         for (const Run& run : g.runs) {
             outcome.holds =
                 outcome.holds && (run.variant->name == "paper" || milliseconds(run) > g["paper"].milliseconds);
             if (run.converged())
                 outcome.values.push_back({run.variant->name, run.milliseconds, "ms"});
             else
                 outcome.values.push_back({run.variant->name, run.max_deviation, "dL"});
         }
         return outcome;
     }},
    {"more_p_in_dp_does_not_help", "D_p with p = 8 ends with no smaller max dL than with p = 4.", "", false,
     [](const Group& g) {
         return no_more_than(g, max_deviation, "dL", {"dp4", "dp8"});
     }},
    {"starts_make_no_difference",
     "From either start the method takes within 25 % of the iterations from the naive one.", "", false,
     [](const Group& g) {
         const double naive = iterations(g["naive"]);
         const auto near = [naive](const Run& run) { return std::abs(iterations(run) - naive) <= 0.25 * naive; };
         return Outcome{naive < k_infinity && std::ranges::all_of(g.runs, near),
                        values_of(g, iterations, "iterations")};
     }},
    {"hard_handles_fail", "It does not converge.", "", false,
     [](const Group& g) {
         return Outcome{!g["paper"].converged(), {{"paper", g["paper"].max_deviation, "dL"}}};
     }},
    {"quads_collapse", "The smallest corner angle is below 5°.", "", false,
     [](const Group& g) {
         const double angle = k_degrees * g["paper"].smallest_angle;
         return Outcome{angle < k_collapsed, {{"paper", angle, "degrees"}}};
     }},
};

std::string in_unit(double value, const std::string& unit) {
    if (std::isinf(value)) return "never";
    if (unit == "share") return formatted("%.0f", 100 * value) + " %";
    if (unit == "degrees") return formatted("%.1f", value) + "°";
    if (unit == "dL") return "dL " + formatted("%.2g", value);
    if (unit == "frames") return formatted("%.3g", value) + " frames a second";
    return formatted(value >= 1000 ? "%.0f" : "%.3g", value) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

bool Group::has(const std::string& variant) const {
    return std::ranges::any_of(runs, [&](const Run& run) { return run.variant->name == variant; });
}

const Run& Group::operator[](const std::string& variant) const {
    for (const Run& run : runs)
        if (run.variant->name == variant) return run;
    throw Error(ErrorCode::bad_option, "a check asks for a variant \"" + variant + "\" that the figure does not have");
}

std::span<const Check> check_table() { return k_checks; }

const Check& find_check(const std::string& name) {
    for (const Check& check : k_checks)
        if (check.name == name) return check;
    throw Error(ErrorCode::bad_option, "there is no check \"" + name + "\"");
}

std::string to_words(const std::vector<Value>& values, const Group& group) {
    std::string words;
    for (const Value& value : values) {
        words += words.empty() ? "" : ", ";
        if (!value.variant.empty()) words += group[value.variant].variant->label + " ";
        words += in_unit(value.value, value.unit);
    }
    return words;
}

}  // namespace chebnet::bench
