#include "drape/drape.h"

#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.h"
#include "base/error.h"
#include "base/number.h"
#include "base/stopwatch.h"
#include "command.h"
#include "drape/bridged_drape.h"
#include "drape/cut_proposals.h"
#include "drape/drape_pieces.h"
#include "drape/proposals.h"
#include "drape/surface_report.h"
#include "drape/tilt.h"
#include "net_output.h"
#include "option_words.h"
#include "points_argument.h"
#include "report.h"
#include "surface/shortest_cut.h"
#include "surface/smoothed_surface.h"
#include "surface/surface_cut.h"
#include "surface_argument.h"

namespace chebnet {
namespace {

constexpr int k_most_cuts = 10;

const std::map<std::string, DrapeOptions::Arms> k_arms = option_words(k_drape_arms);

struct DrapeArguments {
    SurfaceArgument surface;
    NetOutput output;
    std::vector<double> seed, direction;
    double length = 0;
    bool has_length = false, best = false;
    int cells = 4000;
    double angle = 90, smallest_angle = k_usual_limit_degrees, leave = 0;
    int reach = DrapeOptions().reach;
    bool inside = false, cut = false;
    std::string arms, along;
    std::vector<std::string> cuts, cuts_to_border;
    int cuts_between_borders = 0;
    bool pieces = false;
    int propose_cuts = 0;

    bool has_seed() const { return !seed.empty(); }
    bool has_several_seeds() const { return seed.size() > 3; }
    bool has_direction() const { return !direction.empty(); }
    bool has_cuts() const { return !cuts.empty() || !cuts_to_border.empty() || cuts_between_borders > 0; }
};

/// But for where and how it begins.
DrapeOptions shared_options(const DrapeArguments& arguments, const Surface& surface, const SurfaceTree& tree) {
    DrapeOptions options = suggested_drape(surface, tree, arguments.cells);
    if (arguments.has_length) options.length = arguments.length;
    options.angle = arguments.angle * k_degree;
    options.smallest_angle = arguments.smallest_angle * k_degree;
    options.reach = arguments.reach;
    if (arguments.inside) options.border = DrapeOptions::Border::inside;
    if (arguments.cut) options.border = DrapeOptions::Border::cut;
    const std::string usual = arguments.along.empty() ? "geodesic" : "curve";
    options.arms = k_arms.at(arguments.arms.empty() ? usual : arguments.arms);
    if (!arguments.along.empty() && options.arms != DrapeOptions::Arms::curve)
        throw Error(ErrorCode::bad_option, "--along is for --arms curve");
    options.along = points_in(arguments.along, "--along");
    return options;
}

/// Throws Error bad_option where one is farther from the surface than that is large, as one in another unit. Where a
/// net begins is the nearest point, so that a seed may well be beside it; points of cuts may not.
void check_seeds(const DrapeArguments& arguments, const Surface& surface, const SurfaceTree& tree) {
    const double size = (surface.positions().rowwise().maxCoeff() - surface.positions().rowwise().minCoeff()).norm();
    for (std::size_t k = 0; k + 2 < arguments.seed.size(); k += 3) {
        const Eigen::Vector3d seed = Eigen::Vector3d::Map(&arguments.seed[k]);
        if (!seed.allFinite()) continue;  // which is refused where it is used
        const double distance = tree.nearest(seed).distance;
        if (distance <= size) continue;
        const std::string name = arguments.has_several_seeds() ? "seed " + std::to_string(k / 3 + 1) : "the seed";
        throw Error(ErrorCode::bad_option, name + " is " + std::to_string(distance) +
                                               " away from the surface, which is " + std::to_string(size) + " large");
    }
}

/// Where and how it begins if that is not looked for.
DrapeOptions given_options(const DrapeArguments& arguments, const Surface& surface, const SurfaceTree& tree) {
    DrapeOptions options = shared_options(arguments, surface, tree);
    check_seeds(arguments, surface, tree);
    if (arguments.has_seed()) {
        options.seed = Eigen::Vector3d::Map(arguments.seed.data());
        options.direction = suggested_direction(surface, tree, options.seed);
    }
    if (!arguments.has_direction()) return options;
    options.direction = Eigen::Vector3d::Map(arguments.direction.data());
    if (options.direction.isZero(0)) throw Error(ErrorCode::bad_option, "--direction 0 0 0 has no length");
    return options;
}

DrapeOptions options_of(const DrapeArguments& arguments, const Surface& surface, const SurfaceTree& tree) {
    DrapeOptions options = given_options(arguments, surface, tree);
    const bool has_seed = arguments.has_seed(), has_direction = arguments.has_direction();
    if (!arguments.best || (has_seed && has_direction)) return options;
    if (has_seed) return with_best_direction(surface, tree, options);
    const auto propose = has_direction ? propose_seeds : propose_drapes;
    return propose(surface, tree, options).front().options;
}

/// Of a Drape, or of all DrapedPieces together.
template <typename Draped>
Json drape_report(const Draped& draped, const DrapeReport& measured) {
    Json report = net_on_surface_report(draped.net, measured);
    report["refused_by_the_shear_limit"] = draped.locked;
    report["refused_where_the_net_meets_itself"] = draped.met;
    report["rod_ends_cut_at_the_border"] = draped.cut_ends;
    for (const auto& [name, arms] : k_arms)
        if (arms == draped.arms) report["arms"] = name;
    return report;
}

// ---------------------------------------------------------------------------------------------------- cuts and pieces

Json point_report(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

Json pieces_report(const DrapedPieces& made) {
    Json list = Json::array();
    for (const DrapedPiece& piece : made.draped)
        list.push_back({{"piece", piece.piece + 1},
                        {"area", piece.area},
                        {"seed", point_report(piece.options.seed)},
                        {"direction", point_report(piece.options.direction)},
                        {"net", drape_report(piece.drape, piece.report)}});
    for (const BarePiece& piece : made.bare)
        list.push_back({{"piece", piece.piece + 1}, {"area", piece.area}, {"no_net", piece.reason}});
    return list;
}

PiecesOptions pieces_options(const DrapeArguments& arguments, const Surface& surface, const SurfaceTree& tree) {
    PiecesOptions options;
    options.leave = arguments.leave;
    if (arguments.propose_cuts > 0) {
        if (arguments.has_several_seeds())
            throw Error(ErrorCode::bad_option, "--propose-cuts tries nets from one --seed");
        options.drape = options_of(arguments, surface, tree);
        options.first_seed = true;
        return options;
    }
    options.drape = given_options(arguments, surface, tree);
    options.best = arguments.best;
    options.has_direction = arguments.has_direction();
    options.first_seed = arguments.has_seed() && !arguments.has_several_seeds();
    if (!arguments.has_several_seeds()) return options;
    for (std::size_t k = 0; k + 2 < arguments.seed.size(); k += 3)
        options.seeds.emplace_back(Eigen::Vector3d::Map(&arguments.seed[k]));
    return options;
}

/// Those along given points, then those to the border, then those between borders: each finds what those before it
/// left.
std::vector<CutLine> cuts_of(const DrapeArguments& arguments, const Surface& whole, const SurfaceTree& tree) {
    std::vector<CutLine> cuts;
    for (const std::string& cut : arguments.cuts) cuts.push_back(cut_line(whole, tree, points_in(cut, "--cut-along")));
    const auto add = [&](const auto& find) {
        const Surface opened = cut_open(whole, cuts);
        cuts.push_back(cut_line(whole, tree, points_of(opened, find(opened))));
    };
    for (const std::string& text : arguments.cuts_to_border) {
        const Positions points = points_in(text, "--cut-to-border");
        if (points.cols() != 1) throw Error(ErrorCode::bad_option, "--cut-to-border: one point is the cut's beginning");
        add([&](const Surface& opened) {
            return shortest_cut_to_border(
                opened, point_meant(opened, SurfaceTree(opened), points.col(0), "the beginning of a cut"));
        });
    }
    for (int k = 0; k < arguments.cuts_between_borders; ++k) add(shortest_cut_between_borders);
    return cuts;
}

/// Cuts that others can be made from: --cut-along takes their points.
Json proposals_report(const Surface& surface, const CutProposals& proposals) {
    Json cuts = Json::array();
    for (std::size_t k = 0; k < proposals.cuts.size(); ++k) {
        std::string along;
        const Positions points = points_of(surface, proposals.cuts[k]);
        for (const auto& x : points.colwise()) {
            if (!along.empty()) along += ' ';
            along.append(exact_text(x.x())).append(",").append(exact_text(x.y())).append(",");
            along.append(exact_text(x.z()));
        }
        cuts.push_back({{"cut_along", along}, {"coverage_with_it", proposals.coverage[k + 1]}});
    }
    return {{"coverage_uncut", proposals.coverage[0]}, {"cuts", cuts}};
}

/// Off the surface nothing keeps the net from folding.
const char* smoother_way(const DrapeArguments& arguments) {
    return arguments.leave > 0
               ? "--leave 0, which leaves gaps, or a smaller --shear-limit often leads to a smoother one"
               : "more cells often lead to a smoother one";
}

int run_pieces(const DrapeArguments& arguments) {
    Surface loaded = load_surface(arguments.surface);
    Stopwatch watch;
    const Guide guide(std::move(loaded));
    const Surface& whole = guide.surface();
    const SurfaceTree& tree = guide.tree();
    std::vector<CutLine> cuts = cuts_of(arguments, whole, tree);
    const PiecesOptions options = pieces_options(arguments, whole, tree);
    Json proposed;
    if (arguments.propose_cuts > 0) {
        const CutProposals proposals = propose_cuts(whole, options.drape, arguments.propose_cuts);
        proposed = proposals_report(whole, proposals);
        cuts = proposals.cuts;
    }
    const Surface surface = cut_open(whole, cuts);
    const double cut_ms = watch.milliseconds();
    watch.restart();
    const DrapedPieces made = drape_pieces(surface, options);
    const double drape_ms = watch.milliseconds();
    write_net(arguments.output, made.net.rest_positions(), made.net.faces());
    print({{"surface", name_of(arguments.surface)},
           {"described", surface_report(describe(surface))},
           {"net", drape_report(made, made.report)},
           {"pieces", pieces_report(made)},
           {"proposed", proposed},
           {"milliseconds", {{"cut", cut_ms}, {"drape", drape_ms}}}});
    tell_crumpled(crumpled_edges(guide, made.net), "the surface does", smoother_way(arguments));
    return k_success;
}

void tell_roughness(const DrapeReport& measured) {
    std::cerr << "chebnet: the surface is rough, as noisy scans are: the net lies on it smoothed over its edges, "
              << number_text(measured.mean_distance / measured.length, 2) << " of an edge away on average\n";
}

int run_drape(const DrapeArguments& arguments) {
    if (arguments.pieces || arguments.has_cuts() || arguments.has_several_seeds() || arguments.propose_cuts > 0)
        return run_pieces(arguments);
    Surface loaded = load_surface(arguments.surface);
    Stopwatch watch;
    const auto guide = std::make_shared<const Guide>(std::move(loaded));
    const Surface& surface = guide->surface();
    const SurfaceTree& tree = guide->tree();
    const double tree_ms = watch.milliseconds();
    watch.restart();
    const auto laid_on = without_roughness(guide, shared_options(arguments, surface, tree).length);
    const DrapeOptions options = options_of(arguments, laid_on->surface(), laid_on->tree());
    const Drape draped = arguments.leave != 0 ? bridged_drape(laid_on, options, arguments.leave)
                                              : drape(laid_on->surface(), laid_on->tree(), options);
    const double drape_ms = watch.milliseconds();
    const DrapeReport measured = measure_drape(surface, tree, draped.net, options.length);
    write_net(arguments.output, draped.net.rest_positions(), draped.net.faces());
    print({{"surface", name_of(arguments.surface)},
           {"described", surface_report(describe(guide))},
           {"net", drape_report(draped, measured)},
           {"milliseconds", {{"tree", tree_ms}, {"drape", drape_ms}}}});
    if (laid_on != guide) tell_roughness(measured);
    tell_crumpled(crumpled_edges(*laid_on, draped.net), "the surface does", smoother_way(arguments));
    return k_success;
}

}  // namespace

Command add_drape(CLI::App& program) {
    CLI::App& command = *program.add_subcommand(
        "drape",
        "Lay a net on a surface from a seed, every vertex on it and every edge of one length; report, as JSON");
    const auto arguments = std::make_shared<DrapeArguments>();
    add_surface_argument(command, arguments->surface);
    command
        .add_option("--seed", arguments->seed,
                    "Where to begin: the point of the surface nearest to this one; its middle if not given. Given "
                    "several times: a net from each, on pieces of their own, and none on others")
        ->type_name("X Y Z")
        ->type_size(3)
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option(
            "--direction", arguments->direction,
            "Of the first family of net lines there, in space; along the x axis if not given, or the y axis where "
            "that stands upright")
        ->type_name("X Y Z")
        ->type_size(3)
        ->expected(1);
    CLI::Option* length = command.add_option("--edge,--length", arguments->length, "Length of all edges");
    length->type_name("LENGTH");
    command.add_option("--cells", arguments->cells, "In place of the length: about how many cells cover the surface")
        ->capture_default_str()
        ->excludes(length);
    command.add_option("--angle", arguments->angle, "Between the two families at the seed, in degrees")
        ->type_name("DEGREES")
        ->capture_default_str();
    command.add_option("--shear-limit", arguments->smallest_angle, "No corner is sharper than this, in degrees")
        ->type_name("DEGREES")
        ->capture_default_str();
    command
        .add_option("--reach", arguments->reach,
                    "Cells from the seed along each family; as far as it goes if not given")
        ->type_name("CELLS");
    command
        .add_option("--arms", arguments->arms,
                    "How the net lines through the seed run: geodesic; least-shear, bent so that cells are sheared "
                    "less, where that makes a better net; curve, the first family's along a curve")
        ->check(CLI::IsMember(k_arms))
        ->default_str("geodesic, or curve where one is given");
    command
        .add_option(
            "--along", arguments->along,
            "That curve: shortest ways between points on the surface, \"x,y,z x,y,z ...\". The seed goes to its "
            "nearest point, and the direction is its own")
        ->type_name("POINTS")
        ->check([](const std::string& points) { return std::string(points.empty() ? "has no points" : ""); });
    command.add_flag("--best", arguments->best,
                     "Begin where the best of several trials does; with --seed, there in the best direction, with "
                     "--direction, in that one");
    command
        .add_option(
            "--cut-along", arguments->cuts,
            "Cut the surface open along shortest ways between points on it, \"x,y,z x,y,z ...\", and lay a net on "
            "each piece; no edge goes across a cut. Can be given several times")
        ->type_name("POINTS")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option(
            "--cut-to-border", arguments->cuts_to_border,
            "Cut the shortest way from a point on the surface, \"x,y,z\", to its border, or to a cut. Can be given "
            "several times")
        ->type_name("POINT")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option("--cut-between-borders", arguments->cuts_between_borders,
                    "So many times cut the shortest way between the two borders that are nearest to each other")
        ->type_name("CUTS")
        ->check(CLI::Range(1, k_most_cuts));
    command
        .add_option("--propose-cuts", arguments->propose_cuts,
                    "Look for up to so many cuts with which more is covered, and cut along those found")
        ->type_name("CUTS")
        ->check(CLI::Range(1, k_most_cuts))
        ->excludes("--cut-along")
        ->excludes("--cut-to-border")
        ->excludes("--cut-between-borders");
    command.add_flag("--pieces", arguments->pieces, "Lay a net on each piece of a surface that is of several");
    CLI::Option* inside =
        command.add_flag("--inside", arguments->inside, "Set no vertex beyond the border of the surface");
    command
        .add_flag("--cut", arguments->cut,
                  "Cut rods at the border of the surface; edges there are shorter, and keep the lengths they have")
        ->excludes(inside);
    command
        .add_option("--leave", arguments->leave,
                    "Where the net would lock it leaves the surface by up to this, in edge lengths; 0: a gap stays")
        ->check(CLI::Range(0., 10.))
        ->type_name("LENGTHS")
        ->capture_default_str();
    add_net_output(command, "-o,--out,--output", arguments->output)->type_name("OUT");
    return {&command, [arguments, length] {
                arguments->has_length = length->count() > 0;
                return run_drape(*arguments);
            }};
}

}  // namespace chebnet
