#include "experiments.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers.h"

namespace chebnet::bench {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_near = 1e-2;            // max dL at which the paper changes the exponent
constexpr double k_threshold = 1e-6;       // max dL at which a net is accepted
constexpr const char* k_patient = "2000";  // iterations for methods whose iterations are cheap

std::string number(double value) { return std::isinf(value) ? "never" : formatted("%.3g", value); }

// What is read off a run.

double iterations_to(const Run& run, double deviation) {
    for (const Sample& sample : run.samples)
        if (sample.row.max_deviation < deviation) return sample.row.iteration;
    return k_infinity;
}
double iterations(const Run& run) { return run.converged() ? run.iterations : k_infinity; }
double milliseconds(const Run& run) { return run.converged() ? run.milliseconds : k_infinity; }
double iterations_from_near(const Run& run) {
    return run.converged() ? run.iterations - iterations_to(run, k_near) : k_infinity;
}
double iteration_ms(const Run& run) { return run.milliseconds / run.iterations; }
double longer(const Run& run) {
    double sum = 0;
    for (const Sample& sample : run.samples) sum += sample.longer_share;
    return sum / static_cast<double>(std::max<std::size_t>(1, run.samples.size()));
}

// Ways to check a claim.

/// Whether the first variant comes to no more than each of the others.
Outcome no_more_than(const Group& group, double (*quantity)(const Run&), const std::string& first,
                     const std::vector<std::string>& others) {
    const double ours = quantity(group[first]);
    Outcome outcome{ours < k_infinity, first + " " + number(ours)};
    for (const std::string& other : others) {
        const double theirs = quantity(group[other]);
        outcome.holds = outcome.holds && ours <= theirs;
        outcome.numbers += ", " + other + " " + number(theirs);
    }
    return outcome;
}

// Times closer than this are the same: less than what repeats from run to run.
constexpr double k_time_noise = 0.03;

/// The same for times, which repeat only within one run: as multiples of the first variant's.
Outcome no_longer_than(const Group& group, const std::string& first, const std::vector<std::string>& others) {
    const double ours = milliseconds(group[first]);
    Outcome outcome{ours < k_infinity, std::isinf(ours) ? first + " never" : ""};
    for (const std::string& other : others) {
        const double ratio = milliseconds(group[other]) / ours;
        outcome.holds = outcome.holds && ratio >= 1 - k_time_noise;
        if (std::isinf(ours)) continue;
        outcome.numbers += (outcome.numbers.empty() ? "" : ", ") + other + " " + number(ratio);
        outcome.numbers += std::isinf(ratio) ? "" : " times " + first;
    }
    return outcome;
}

Outcome all_converge(const Group& group) {
    Outcome outcome{true, ""};
    for (const Run& run : group.runs)
        if (!run.converged()) {
            outcome.holds = false;
            outcome.numbers += run.variant + " " + to_string(run.status) + " at " + number(run.max_deviation) + ", ";
        }
    if (outcome.holds) return {true, "all"};
    outcome.numbers.resize(outcome.numbers.size() - 2);
    return outcome;
}

Outcome stays_above_threshold(const Group& group, const std::string& variant) {
    const double deviation = group[variant].max_deviation;
    return {group["li2022"].converged() && deviation > k_threshold, variant + " ends at " + number(deviation)};
}

/// Slope of log time of an iteration against log vertices, by least squares.
double growth_exponent(const Group& group) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const Run& run : group.runs) {
        const double x = std::log(run.vertices), y = std::log(iteration_ms(run));
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double mean_frame_iterations(const Run& run) { return run.iterations / static_cast<double>(run.samples.size()); }

// What is plotted.

double iteration(const Run&, const Sample& sample) { return sample.row.iteration; }
double time_ms(const Run&, const Sample& sample) { return sample.row.total_ms; }
double max_deviation(const Run&, const Sample& sample) { return sample.row.max_deviation; }
double longer_percent(const Run&, const Sample& sample) { return 100 * sample.longer_share; }
double vertices(const Run& run, const Sample&) { return run.vertices; }
double handles(const Run& run, const Sample&) { return run.handles; }
double total_iterations(const Run& run, const Sample&) { return run.iterations; }
double ms_of_iteration(const Run& run, const Sample&) { return iteration_ms(run); }
double free_vertices(const Run&, const Sample& sample) { return sample.row.free_vertices; }

constexpr View k_by_iteration{"iteration", "max dL", false, true, iteration, max_deviation};
constexpr View k_by_time{"ms, this run", "max dL", false, true, time_ms, max_deviation};
constexpr View k_by_log_iteration{"iteration", "max dL", true, true, iteration, max_deviation};
constexpr View k_by_log_time{"ms, this run", "max dL", true, true, time_ms, max_deviation};
constexpr View k_longer{"iteration", "edges longer than L, %", false, false, iteration, longer_percent};
constexpr View k_free{"iteration", "free vertices", false, false, iteration, free_vertices};
constexpr View k_frame_deviation{"frame", "max dL", false, true, iteration, max_deviation};
constexpr View k_frame_time{"frame", "ms a frame, this run", false, true, iteration, time_ms};
constexpr View k_growth_time{"vertices", "ms an iteration, this run", true, true, vertices, ms_of_iteration, true};
constexpr View k_growth_count{"vertices", "iterations", true, false, vertices, total_iterations, true};
constexpr View k_handle_count{"handles", "iterations", true, false, handles, total_iterations, true};

// What is run.

const std::vector<EditCase> k_usual = {{"vault:vertices=2000", "pull", ""},    {"dome:vertices=4000", "bend", ""},
                                       {"tube:vertices=3000", "twist", ""},    {"torus:vertices=4000", "spread", ""},
                                       {"elephant:vertices=4000", "pull", ""}, {"jack:vertices=3000", "bend", ""},
                                       {"steps:vertices=6000", "twist", ""},   {"elephant:vertices=8600", "bend", ""},
                                       {"vault:vertices=1000", "twist", ""},   {"torus:vertices=9000", "twist", ""}};

const std::vector<EditCase> k_dragged = {{"elephant:vertices=4000", "bend", ""},
                                         {"vault:vertices=4000", "pull", ""},
                                         {"jack:vertices=3000", "twist", ""},
                                         {"dome:vertices=6000", "spread", ""}};

const std::vector<EditCase> k_sized = {
    {"elephant", "bend", ""}, {"vault", "pull", ""}, {"torus", "twist", ""}, {"steps", "pull", ""}};

std::vector<EditCase> all_kinds(const std::vector<std::string>& nets) {
    std::vector<EditCase> cases;
    for (const std::string& net : nets)
        for (const std::string& kind : edit_kinds()) cases.push_back({net, kind, ""});
    return cases;
}

Variant fixed_exponent(const std::string& p) {
    return {.label = "p = " + p, .options = {{"adaptive_p", "off"}, {"p_end", p}}};
}

Variant patient(const std::string& method) {
    return {.label = method, .method = method, .options = {{"max_iterations", k_patient}}};
}

/// Without the two rules by which a stage ends early.
Variant to_the_end(const std::string& method) {
    return {.label = method + " to the end",
            .method = method,
            .options = {{"energy_tolerance", "0"}, {"gradient_tolerance", "0"}}};
}

template <typename Value>
std::vector<Variant> one_each(const std::vector<Value>& values, const std::string& what, Value Change::*member) {
    std::vector<Variant> variants;
    for (const Value value : values) {
        variants.push_back({.label = std::to_string(value) + what});
        variants.back().change.*member = value;
    }
    return variants;
}

Variant on_mesh(const std::string& label, Cut cut, double amount, const std::string& method = "li2022") {
    return {.label = label, .method = method, .change = {.cut = cut, .amount = amount}};
}

constexpr const char* k_slow_majorizer =
    "Near the solution the paper's majorizer has the radial weight p(3p − 1) where the energy's own Hessian has 2p², "
    "so "
    "its steps are about two thirds of what is needed. It spends the difference on fairer shapes: compare the bends.";

std::vector<Experiment> make_experiments() {
    const Variant li2022{.label = "li2022"};
    return {
        {"fig04_exponent",
         4,
         "The exponent p",
         {{"A small exponent is quicker from far away.",
           "p = 2 reaches max dL < 1e-2 in no more iterations than p = 50.", "",
           [](const Group& g) {
               return no_more_than(g, [](const Run& run) { return iterations_to(run, k_near); }, "p = 2", {"p = 50"});
           }},
          {"A large exponent is quicker near the solution.",
           "p = 50 goes from max dL < 1e-2 to 1e-6 in no more iterations than p = 2.", "",
           [](const Group& g) { return no_more_than(g, iterations_from_near, "p = 50", {"p = 2"}); }}},
         k_usual,
         {{.label = "adaptive"}, fixed_exponent("2"), fixed_exponent("4"), fixed_exponent("10"), fixed_exponent("50")},
         {k_by_iteration, k_by_time}},
        {"fig05_adaptive_exponent",
         5,
         "Adaptive exponent against the final one throughout",
         {{"Raising the exponent on the way is quicker than the large exponent from the start.",
           "adaptive converges, in no more iterations than p = 50.", "",
           [](const Group& g) { return no_more_than(g, iterations, "adaptive", {"p = 50"}); }}},
         k_usual,
         {{.label = "adaptive"}, fixed_exponent("50")},
         {k_by_iteration, k_by_time}},
        {"fig07_reduction",
         7,
         "Adaptive variable reduction",
         {{"Moving only the vertices near bad edges saves time.",
           "on converges, in no more time than off (3% are noise).",
           "With few bad edges left the last iterations become cheap, but a new part of the net has to be ordered and "
           "factored, and sometimes more iterations are needed.",
           [](const Group& g) { return no_longer_than(g, "on", {"off"}); }}},
         k_usual,
         {{.label = "on"}, {.label = "off", .options = {{"adaptive_reduction", "off"}}}},
         {k_by_time, k_free},
         3},
        {"fig08_long_edges",
         8,
         "Composite majorization prefers long edges",
         {{"Under composite majorization more edges are longer than L on the way.",
           "Share of edges with length > L, mean over the iterations: no smaller than under li2022.", "",
           [](const Group& g) { return no_more_than(g, longer, "li2022", {"composite_majorization"}); }}},
         k_usual,
         {li2022, {.label = "composite_majorization", .method = "composite_majorization"}},
         {k_longer, k_by_iteration}},
        {"fig09_majorizers",
         9,
         "Majorizers of the same energy",
         {{"The paper's majorizer needs fewer iterations.",
           "li2022 converges, in no more iterations than either of the others.", k_slow_majorizer,
           [](const Group& g) {
               return no_more_than(g, iterations, "li2022", {"composite_majorization", "projected_newton"});
           }},
          {"The paper's majorizer needs less time.", "li2022 converges, in no more time than either of the others.",
           k_slow_majorizer,
           [](const Group& g) {
               return no_longer_than(g, "li2022", {"composite_majorization", "projected_newton"});
           }},
          {"The paper's majorizer gives the fairer net.",
           "Bend under li2022 no larger than under either of the others.", "",
           [](const Group& g) {
               return no_more_than(g, [](const Run& run) { return run.bend; }, "li2022",
                                   {"composite_majorization", "projected_newton"});
           }}},
         k_usual,
         {li2022,
          {.label = "composite_majorization", .method = "composite_majorization"},
          {.label = "projected_newton", .method = "projected_newton"}},
         {k_by_iteration, k_by_time},
         2},
        {"fig10_energies",
         10,
         "Energies",
         {{"Energy (3) reaches the threshold sooner than its rivals, with the paper's stopping rules for all.",
           "li2022 converges, in no more iterations than direct E_p, dp4 and dp8.", "",
           [](const Group& g) {
               return no_more_than(g, iterations, "li2022", {"direct E_p", "dp4", "dp8"});
           }},
          {"It does so too when the rivals may go on after their energy has settled.",
           "li2022 converges, in no more iterations than dp4 and dp8 with ε1 = ε2 = 0.",
           "D_p is so flat near its minimum that the stopping rules end it early; without them it goes on to converge.",
           [](const Group& g) {
               return no_more_than(g, iterations, "li2022", {"dp4 to the end", "dp8 to the end"});
           }}},
         k_usual,
         {li2022,
          {.label = "direct E_p", .options = {{"direct_energy", "on"}}},
          {.label = "dp4", .method = "dp4"},
          {.label = "dp8", .method = "dp8"},
          to_the_end("dp4"),
          to_the_end("dp8")},
         {k_by_iteration, k_by_time}},
        {"fig12_initialisations",
         12,
         "Initialisations",
         {{"The method converges from every start.", "All three converge.", "", all_converge},
          {"Five iterations of ARAP are a better start than none.",
           "li2022 from arap:5 takes no more iterations than from naive.", "",
           [](const Group& g) { return no_more_than(g, iterations, "arap:5", {"naive"}); }},
          {"Five iterations of local–global are a better start than none.",
           "li2022 from local_global:5 takes no more iterations than from naive.", "",
           [](const Group& g) { return no_more_than(g, iterations, "local_global:5", {"naive"}); }}},
         k_usual,
         {{.label = "naive"},
          {.label = "arap:5", .initialisation = "arap:5"},
          {.label = "local_global:5", .initialisation = "local_global:5"}},
         {k_by_iteration, k_by_time}},
        {"fig13_arap",
         13,
         "As rigid as possible, as a competitor",
         {{"ARAP does not keep the lengths.", "li2022 converges; ARAP ends with max dL > 1e-6.", "",
           [](const Group& g) { return stays_above_threshold(g, "arap"); }}},
         k_usual,
         {li2022, {.label = "arap", .method = "arap", .options = {{"max_iterations", "500"}}}},
         {k_by_log_iteration, k_by_log_time}},
        {"fig14_local_global",
         14,
         "Local–global, as a competitor",
         {{"Local–global takes more iterations.", "li2022 converges, in no more iterations than local–global.", "",
           [](const Group& g) { return no_more_than(g, iterations, "li2022", {"local_global"}); }},
          {"Local–global takes more time.", "li2022 converges, in no more time than local–global.",
           "An iteration of local–global is two triangular solves and costs a small part of one with a factorisation.",
           [](const Group& g) { return no_longer_than(g, "li2022", {"local_global"}); }}},
         k_usual,
         {li2022, patient("local_global")},
         {k_by_log_iteration, k_by_log_time}},
        {"fig15_first_order",
         15,
         "First-order and quasi-Newton methods",
         {{"Gradient descent takes more time.", "li2022 converges, in no more time than gradient descent.", "",
           [](const Group& g) { return no_longer_than(g, "li2022", {"gradient_descent"}); }},
          {"L-BFGS takes more time.", "li2022 converges, in no more time than L-BFGS.",
           "An iteration of L-BFGS costs a small part of one with a factorisation, and on short edits hundreds "
           "suffice. "
           "It bends the net more: compare the bends.",
           [](const Group& g) { return no_longer_than(g, "li2022", {"lbfgs"}); }}},
         k_usual,
         {li2022, patient("gradient_descent"), patient("lbfgs")},
         {k_by_log_iteration, k_by_log_time}},
        {"fig16_drag",
         16,
         "Dragging: the last frame as the start of the next",
         {{"Every frame of a drag ends below the threshold.", "All 20 frames of warm converge.", "",
           [](const Group& g) {
               return Outcome{g["warm"].converged(), "worst frame " + number(g["warm"].max_deviation)};
           }},
          {"A frame that starts from the last one takes fewer iterations than one that starts at rest.",
           "Iterations a frame, mean: warm no more than cold.", "",
           [](const Group& g) { return no_more_than(g, mean_frame_iterations, "warm", {"cold"}); }}},
         k_dragged,
         {{.label = "warm", .frames = 20}, {.label = "cold", .frames = 20, .frame_start = FrameStart::rest}},
         {k_frame_time, k_frame_deviation}},
        {"fig17_handles",
         17,
         "Many handles",
         {{"The method converges with many handles.", "All converge.",
           "Many handles leave little freedom between them; the start, where handles jump and the rest stays, crumples "
           "the net at each of them.",
           all_converge},
          {"More handles do not make it much slower.", "64 handles take at most twice the iterations of 4.", "",
           [](const Group& g) {
               const double few = iterations(g["4 handles"]), many = iterations(g["64 handles"]);
               return Outcome{many <= 2 * few && many < k_infinity, number(few) + " and " + number(many)};
           }}},
         k_usual,
         one_each<int>({4, 16, 64, 128}, " handles", &Change::handles),
         {k_by_iteration, k_handle_count}},
        {"fig18_growth",
         18,
         "Growth with the size of the net",
         {{"The time of an iteration grows little faster than the net.",
           "Exponent of vertices in the time of an iteration, fitted: at most 1.5, which nested dissection promises.",
           "",
           [](const Group& g) {
               const double exponent = growth_exponent(g);
               return Outcome{exponent <= 1.5, "exponent " + number(exponent)};
           }},
          {"The number of iterations hardly depends on the size.",
           "15,000 vertices take at most twice the iterations of 1,000.", "",
           [](const Group& g) {
               const double few = iterations(g["1000 vertices"]), many = iterations(g["15000 vertices"]);
               return Outcome{many <= 2 * few && many < k_infinity, number(few) + " and " + number(many)};
           }}},
         k_sized,
         one_each<int>({1000, 2000, 4000, 8000, 15000}, " vertices", &Change::vertices),
         {k_growth_time, k_growth_count},
         2,
         true,
         true},
        {"fig20_singular",
         20,
         "Singular vertices, closed nets, nets with a hole through them",
         {{"Vertices of valence 3, 5 and 6, closed nets and other topologies make no difference.", "Both converge.", "",
           all_converge}},
         all_kinds({"steps:vertices=3000", "jack:vertices=4000", "elephant:vertices=5000", "torus:vertices=3000"}),
         {{.label = "naive"}, {.label = "arap:5", .initialisation = "arap:5"}},
         {k_by_iteration, k_by_time},
         1,
         false},
        {"fig21_general_meshes",
         21,
         "General meshes: each edge keeps its own length",
         {{"Mixed meshes (a diagonal in every second quad) are edited as nets are.", "mixed converges.",
           "Each diagonal is one constraint more.",
           [](const Group& g) {
               return Outcome{g["mixed"].converged(), "ends at " + number(g["mixed"].max_deviation)};
           }},
          {"Triangle meshes (a diagonal in every quad) are edited as nets are.", "triangles converges.",
           "With all diagonals there are about as many edges as coordinates: the mesh can bend like paper but not "
           "shear, and a far edit may have no exact solution nearby.",
           [](const Group& g) {
               return Outcome{g["triangles"].converged(), "ends at " + number(g["triangles"].max_deviation)};
           }},
          {"A shorter edit of a triangle mesh can be solved.", "triangles, a tenth of the motion: converges.", "",
           [](const Group& g) {
               const Run& run = g["triangles, tenth"];
               return Outcome{run.converged(), "ends at " + number(run.max_deviation)};
           }}},
         k_usual,
         {on_mesh("quads", Cut::none, 1), on_mesh("mixed", Cut::some, 1), on_mesh("triangles", Cut::all, 1),
          on_mesh("triangles, tenth", Cut::all, 0.1),
          on_mesh("triangles, projected_newton", Cut::all, 1, "projected_newton"),
          on_mesh("triangles, lbfgs", Cut::all, 1, "lbfgs")},
         {k_by_iteration, k_by_time},
         1,
         false},
    };
}

}  // namespace

const Run& Group::operator[](const std::string& variant) const {
    return *std::ranges::find(runs, variant, &Run::variant);
}

bool Group::any_converged() const { return std::ranges::any_of(runs, &Run::converged); }

bool Group::any_moved() const {
    return std::ranges::any_of(runs, [](const Run& run) { return run.iterations > 0; });
}

const std::vector<Experiment>& experiments() {
    static const std::vector<Experiment> table = make_experiments();
    return table;
}

}  // namespace chebnet::bench
