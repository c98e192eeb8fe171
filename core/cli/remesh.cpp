#include "remesh/remesh.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/error.h"
#include "base/number.h"
#include "base/stopwatch.h"
#include "base/text.h"
#include "command.h"
#include "drape/drape.h"
#include "drape/tilt.h"
#include "net_output.h"
#include "option_words.h"
#include "points_argument.h"
#include "report.h"
#include "surface_argument.h"

namespace chebnet {
namespace {

const std::map<std::string, RemeshOptions::Border> k_borders = option_words(k_remesh_borders);

// Of a surface, what is as good as all of it.
constexpr double k_covered = 0.98;
constexpr std::size_t k_most_places = 4;  // that a sentence names
constexpr int k_place_digits = 3;         // of their coordinates

struct RemeshArguments {
    SurfaceArgument surface;
    NetOutput output;
    RemeshOptions options;
    double smallest_angle = k_usual_limit_degrees;
    std::string crease = "fitting";
    std::string border = "fitting";
    std::vector<std::string> singular, forbidden, creases;
};

/// What is wrong with a length after --length.
std::string length_fault(const std::string& text) {
    const std::optional<double> length = parse_number(text);
    return length && *length > 0 ? "" : "wants a number above 0, not " + text;
}

/// "X,Y,Z:NUMBER".
std::pair<Eigen::Vector3d, double> point_and_number(const std::string& text, const char* option, const char* form) {
    std::vector<double> numbers;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find(numbers.size() < 2 ? ',' : ':', start), text.size());
        const std::optional<double> number = parse_number(std::string_view(text).substr(start, end - start));
        if (!number || numbers.size() == 4)
            throw Error(ErrorCode::bad_syntax, std::string(option) + " " + chebnet::quoted(text) + " is not " + form);
        numbers.push_back(*number);
        start = end + 1;
    }
    if (numbers.size() != 4)
        throw Error(ErrorCode::bad_syntax, std::string(option) + " " + chebnet::quoted(text) + " is not " + form);
    return {{numbers[0], numbers[1], numbers[2]}, numbers[3]};
}

void read_wishes(const RemeshArguments& arguments, SingularWishes& wishes) {
    for (const std::string& text : arguments.singular) {
        const auto [point, valence] = point_and_number(text, "--singular", "X,Y,Z:VALENCE");
        if (valence != std::round(valence) || !(std::abs(valence) < 100))
            throw Error(ErrorCode::bad_syntax,
                        "--singular " + chebnet::quoted(text) + ": the valence is no whole number");
        wishes.vertices.push_back({point, static_cast<int>(valence)});
    }
    for (const std::string& text : arguments.forbidden) {
        const auto [centre, radius] = point_and_number(text, "--forbid", "X,Y,Z:RADIUS");
        wishes.forbidden.push_back({centre, radius});
    }
}

Json point_json(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

/// What was wished for, and what came of it.
Json wishes_report(const SingularWishes& wishes, const KeptWishes& kept) {
    Json vertices = Json::array(), forbidden = Json::array(), creases = Json::array(), unkept = Json::array();
    for (std::size_t k = 0; k < wishes.vertices.size(); ++k)
        vertices.push_back({{"point", point_json(wishes.vertices[k].point)},
                            {"valence", wishes.vertices[k].valence},
                            {"kept", static_cast<bool>(kept.vertices[k])},
                            {"distance_in_edges", kept.distances[k] < 0 ? Json() : Json(kept.distances[k])}});
    for (std::size_t k = 0; k < wishes.forbidden.size(); ++k)
        forbidden.push_back({{"centre", point_json(wishes.forbidden[k].centre)},
                             {"radius", wishes.forbidden[k].radius},
                             {"kept", kept.intruders[k] == 0},
                             {"singular_vertices", kept.intruders[k]}});
    for (const std::string& sentence : unkept_wishes(wishes, kept)) unkept.push_back(sentence);
    for (const double distance : kept.creases)
        creases.push_back({{"followed", is_followed(distance)}, {"distance_in_edges", distance}});
    return {{"vertices", vertices},
            {"forbidden", forbidden},
            {"only", wishes.only},
            {"creases", creases},
            {"not_kept", unkept}};
}

Json left_off_report(const std::vector<ThinLimb>& limbs) {
    Json list = Json::array();
    for (const ThinLimb& limb : limbs)
        list.push_back({{"point", point_json(limb.point)}, {"girth_in_cells", limb.girth}});
    return list;
}

Json remesh_report(const Remesh& made, const DrapeReport& measured, const SingularWishes& wishes) {
    Json report = net_on_surface_report(made.net, measured);
    Json by_valence = Json::object(), list = Json::array();
    for (const SingularVertex& singular : made.singular) {
        Json& count = by_valence[std::to_string(singular.valence)];
        count = (count.is_null() ? 0 : count.get<int>()) + 1;
        list.push_back(
            {{"vertex", singular.vertex}, {"valence", singular.valence}, {"position", point_json(singular.position)}});
    }
    report["quads_beyond_shear_limit"] = made.sharp_quads;
    report["singular_vertices"] = made.singular.size();
    report["singular_vertices_by_valence"] = by_valence;
    report["singular"] = list;
    report["left_off"] = left_off_report(made.left_off);
    if (!wishes.is_empty() || !made.kept.creases.empty()) report["wishes"] = wishes_report(wishes, made.kept);
    return report;
}

/// What was asked for that may be in the way of a net that lies smoothly on all of the surface; empty: nothing.
std::string obstacle(const RemeshOptions& options) {
    if (options.crease > 0) return "--crease";
    if (!options.marked_creases.empty()) return "--crease-along";
    return options.singular.is_empty() ? "" : "wishes for singular vertices";
}

/// A border that is held may lead to a net that is longer than there is room for.
std::string smoother_way(const RemeshOptions& options) {
    if (const std::string what = obstacle(options); !what.empty()) return "without " + what + " it often lies smoother";
    return options.border == RemeshOptions::Border::fitting ? "more cells often lie smoother"
                                                            : "--border fitting often lies smoother";
}

std::string fuller_way(const RemeshOptions& options, int gaps) {
    if (const std::string what = obstacle(options); !what.empty()) return "without " + what + " it often covers more";
    if (options.border != RemeshOptions::Border::fitting) return "--border fitting often covers more";
    return gaps > 0 ? "it has gaps where it would crumple: more cells, or chebnet drape --leave, may cover more"
                    : "where that is finely shaped more cells cover more, where it is rough fewer";
}

/// Where the limbs are that the net lies without.
void tell_left_off(const std::vector<ThinLimb>& limbs) {
    if (limbs.empty()) return;
    std::string places;
    const std::size_t named = std::min(limbs.size(), k_most_places);
    for (std::size_t k = 0; k < named; ++k) {
        if (k > 0) places += k + 1 == limbs.size() ? " and " : ", ";
        places += row_text(std::span(limbs[k].point.data(), 3), k_place_digits);
    }
    if (named < limbs.size()) places += " and elsewhere";
    const bool is_one = limbs.size() == 1;
    std::cerr << "chebnet: " << (is_one ? "a limb is" : std::to_string(limbs.size()) + " limbs are")
              << " too thin for cells of this size and left off, near " << places << ": more cells keep "
              << (is_one ? "it" : "them") << '\n';
}

/// Net lines that follow creases or end in steps, singular vertices that were wished for, and details finer than cells
/// may lead to less than all of the surface.
void tell_bare(const DrapeReport& measured, const RemeshOptions& options) {
    if (measured.coverage >= k_covered) return;
    std::cerr << "chebnet: the net covers " << number_text(100 * measured.coverage, 3) << " % of the surface; "
              << fuller_way(options, measured.gaps) << '\n';
}

void read_crease(const std::string& text, RemeshOptions& options) {
    options.tries_creases = text == "fitting";
    if (options.tries_creases) return;
    const std::optional<double> degrees = parse_number(text);
    if (!degrees)
        throw Error(ErrorCode::bad_option, "--crease wants fitting or a number, not " + chebnet::quoted(text));
    options.crease = *degrees * k_degree;
}

int run_remesh(const RemeshArguments& arguments) {
    Surface loaded = load_surface(arguments.surface);
    Stopwatch watch;
    const auto guide = std::make_shared<const Guide>(std::move(loaded));
    Json milliseconds = {{"tree", watch.milliseconds()}};
    RemeshOptions options = arguments.options;
    options.smallest_angle = arguments.smallest_angle * k_degree;
    read_crease(arguments.crease, options);
    options.border = k_borders.at(arguments.border);
    read_wishes(arguments, options.singular);
    for (const std::string& text : arguments.creases)
        options.marked_creases.push_back(points_in(text, "--crease-along"));
    const Remesh made = remesh(guide, options);
    for (int phase = 0; phase < k_remesh_phases; ++phase)
        milliseconds[to_string(static_cast<RemeshPhase>(phase))] = made.milliseconds[phase];
    write_net(arguments.output, made.net.rest_positions(), made.net.faces());
    const DrapeReport measured = measure_drape(guide->surface(), guide->tree(), made.net);
    print({{"surface", name_of(arguments.surface)},
           {"described", surface_report(describe(guide))},
           {"net", remesh_report(made, measured, options.singular)},
           {"milliseconds", milliseconds}});
    tell_left_off(made.left_off);
    if (made.sharp_quads > 0) tell_sharp_quads(made.sharp_quads, options.smallest_angle);
    tell_crumpled(crumpled_edges(*guide, made.net), "the surface does", smoother_way(options));
    tell_bare(measured, options);
    return k_success;
}

}  // namespace

Command add_remesh(CLI::App& program) {
    CLI::App& command = *program.add_subcommand(
        "remesh",
        "Make a net over a whole surface, closed or not, with singular vertices, near it and every edge of one length; "
        "report, as JSON");
    const auto arguments = std::make_shared<RemeshArguments>();
    add_surface_argument(command, arguments->surface);
    CLI::Option* cells =
        command.add_option("--cells", arguments->options.cells, "About so many")->capture_default_str();
    command
        .add_option("--length,--edge", arguments->options.length,
                    "In place of their number: the length of all edges, exactly")
        ->type_name("LENGTH")
        ->check(length_fault)
        ->excludes(cells);
    command
        .add_option("--shear-limit", arguments->smallest_angle,
                    "No corner is to be sharper than this, in degrees; a remark says where no such net is found")
        ->type_name("DEGREES")
        ->capture_default_str();
    command
        .add_option("--smoothing", arguments->options.smoothing,
                    "The more, the larger are the bumps that make no singular vertices: 0 to 100")
        ->type_name("NUMBER")
        ->capture_default_str();
    command.add_flag(
        "--fewest", arguments->options.fewest,
        "As few singular vertices as a net within the shear limit can do with, no farther than 0.2 edges from "
        "the surface on average; takes longer");
    command
        .add_option("--singular", arguments->singular,
                    "A singular vertex is wanted at that point, of valence 3, 5 or 6; may be given again")
        ->type_name("X,Y,Z:VALENCE")
        ->allow_extra_args(false);
    command
        .add_option("--forbid", arguments->forbidden,
                    "No singular vertex is wanted within the radius of that point; may be given again")
        ->type_name("X,Y,Z:RADIUS")
        ->allow_extra_args(false);
    command.add_flag("--only-these", arguments->options.singular.only,
                     "No singular vertices are wanted but those of --singular");
    command
        .add_option("--crease", arguments->crease,
                    "Net lines follow edges of the surface that are sharper than this, in degrees; 0: none are "
                    "followed; fitting: "
                    "those over 30 degrees, where the net lies better so")
        ->type_name("DEGREES")
        ->capture_default_str();
    command
        .add_option(
            "--crease-along", arguments->creases,
            "Net lines follow shortest ways between points on the surface, \"x,y,z x,y,z ...\", too. Can be given "
            "several times")
        ->type_name("POINTS")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option("--border", arguments->border,
                    "Where the surface ends: in a net line (always), in one, but in steps around holes (outer), in "
                    "steps (never), or with net lines that run up to it at 45 degrees (across); fitting: as fits best, "
                    "left open along gaps where all others would crumple")
        ->check(CLI::IsMember(k_borders))
        ->capture_default_str();
    add_net_output(command, "-o,--out,--output", arguments->output)->type_name("OUT");
    return {&command, [arguments] { return run_remesh(*arguments); }};
}

}  // namespace chebnet
