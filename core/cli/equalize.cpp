#include "edit/equalize.h"

#include <iostream>
#include <memory>
#include <optional>

#include "base/angle.h"
#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "command.h"
#include "net/measures.h"
#include "net/rods.h"
#include "net_argument.h"
#include "net_output.h"
#include "report.h"
#include "solver_arguments.h"
#include "surface_argument.h"

namespace chebnet {
namespace {

struct EqualizeArguments {
    NetArgument net;
    NetOutput output;
    std::string length = "mean";
    std::vector<int> handles;
    std::string method;
    double shear_limit = k_usual_limit_degrees;
    std::string guide;
};

EqualizeOptions options_of(const EqualizeArguments& arguments) {
    EqualizeOptions options;
    options.handles = arguments.handles;
    options.way = equalize_way_named(arguments.method);
    options.shear_limit = arguments.shear_limit * k_degree;
    if (!arguments.guide.empty()) options.guide = load_guide(arguments.guide, arguments.net.repair);
    if (arguments.length == "mean") return options;
    options.choice = arguments.length == "fit" ? EqualLength::fitting : EqualLength::given;
    if (options.choice == EqualLength::fitting) return options;
    const std::optional<double> number = parse_number(arguments.length);
    if (!number)
        throw Error(ErrorCode::bad_option,
                    "--length wants mean, fit or a number, not " + chebnet::quoted(arguments.length));
    options.length = *number;
    return options;
}

Json spread_report(const LengthSpread& spread) {
    return {
        {"shortest", spread.shortest}, {"longest", spread.longest}, {"standard_deviation", spread.standard_deviation}};
}

Json worst_edges_report(const EqualizeReport& equalized, const Net& net, const Positions& positions) {
    Json list = Json::array();
    for (const int e : equalized.worst_edges) {
        const int a = net.edges()(0, e), b = net.edges()(1, e);
        list.push_back({{"vertices", {a, b}}, {"length", (positions.col(a) - positions.col(b)).norm()}});
    }
    return list;
}

Json equalize_report(const EqualizeArguments& arguments, const Equalizer& equalizer, const EqualizeReport& equalized) {
    const std::optional<GuideDistance>& distance = equalized.distance;
    return {{"net", arguments.net.name},
            {"status", to_string(equalized.status)},
            {"method", to_string(equalized.way)},
            {"length", equalized.length},
            {"fitting_length", equalized.fitting_length},
            {"max_dL", equalized.max_deviation},
            {"iterations", equalized.iterations},
            {"milliseconds", equalized.milliseconds},
            {"mean_move_in_lengths", equalized.mean_move},
            {"max_move_in_lengths", equalized.max_move},
            {"mean_distance_in_lengths", distance ? Json(distance->mean) : Json()},
            {"largest_distance_in_lengths", distance ? Json(distance->largest) : Json()},
            {"smallest_corner_angle_degrees", equalized.smallest_angle / k_degree},
            {"quads_beyond_shear_limit", equalized.quads_beyond_limit},
            {"folds_over_60_degrees_before", equalized.folds_before},
            {"folds_over_60_degrees", equalized.folds},
            {"lengths_before", spread_report(equalized.before)},
            {"lengths_after", spread_report(equalized.after)},
            {"worst_edges", worst_edges_report(equalized, equalizer.original(), equalizer.positions())},
            {"unreachable_pairs", unreachable_report(equalized.unreachable_pairs)}};
}

/// The whole edges of such a net are of one length already, and few of its faces at the border are quads.
void tell_of_cut_net(const Net& net) {
    const Topology topology(net);
    if (!is_cut(net, topology)) return;
    int others = net.face_count();
    for (const auto& [corners, count] : faces_by_arity(net.faces()))
        if (corners == 4) others -= count;
    std::cerr << "chebnet: a border has cut this net; its edges have one length but for those cut there, which now get "
                 "it, too, and the limit does not hold for the "
              << others << (others == 1 ? " face that is no quad\n" : " faces that are no quads\n");
}

/// Where held vertices are near each other for edges that long, or all edges of the mesh cannot have one length near
/// its surface. Where its faces are no surface, no other net can be made on it.
const char* smoother_way(const EqualizeArguments& arguments, const EqualizeReport& equalized) {
    if (!arguments.handles.empty())
        return arguments.length == "mean"
                   ? "fewer vertices after --hold often leave a smoother one"
                   : "--length mean, or fewer vertices after --hold, often lead to a smoother one";
    return equalized.distance ? "chebnet remesh, which gives the surface edges of its own, often makes a smoother one"
                              : "";
}

/// Of a net whose edges came out unequal.
std::string what_failed(const Equalizer& equalizer, const EqualizeReport& equalized) {
    if (equalized.status == Status::unreachable && !equalized.unreachable_pairs.empty()) {
        const UnreachablePair& pair = equalized.unreachable_pairs[0];
        return "there is no such net: held vertices " + std::to_string(pair.vertex_a) + " and " +
               std::to_string(pair.vertex_b) + " are " + number_text(pair.distance, 6) +
               " apart, but the net between them is " + number_text(pair.reach, 6) + " long";
    }
    if (equalized.status == Status::non_finite) return "a number overflowed, and the last finite shape is held";
    std::string what = "no net with edges of length " + number_text(equalized.length, 6) + " was found";
    if (equalized.worst_edges.empty()) return what;
    const Eigen::Vector2i ends = equalizer.original().edges().col(equalized.worst_edges[0]);
    const double length = (equalizer.positions().col(ends[0]) - equalizer.positions().col(ends[1])).norm();
    return what + ": the worst, from vertex " + std::to_string(ends[0]) + " to " + std::to_string(ends[1]) + ", is " +
           number_text(length, 6) + " long";
}

void tell_unequal(const EqualizeArguments& arguments, const Equalizer& equalizer, const EqualizeReport& equalized) {
    const char* way_out = equalized.distance ? "; chebnet remesh gives the surface edges of its own" : "";
    if (!arguments.handles.empty()) way_out = "; another --length, or fewer vertices after --hold, may do";
    std::cerr << "chebnet: " << what_failed(equalizer, equalized) << way_out << '\n';
}

/// From half an edge on the net covers the surface no longer, as DrapeReport has it.
void tell_far(const EqualizeArguments& arguments, const EqualizeReport& equalized) {
    if (!equalized.distance || equalized.distance->mean <= 0.5) return;
    std::cerr << "chebnet: every edge has its length, but the net is far from the surface, on average "
              << number_text(equalized.distance->mean, 2) << " edge lengths"
              << (arguments.handles.empty() ? "; chebnet remesh gives the surface edges of its own"
                                            : "; another --length, or fewer vertices after --hold, may do")
              << '\n';
}

int run_equalize(const EqualizeArguments& arguments) {
    Equalizer equalizer(load_net(arguments.net), options_of(arguments));
    tell_of_cut_net(equalizer.original());
    const EqualizeReport equalized = equalizer.solve();
    write_net(arguments.output, equalizer.positions(), equalizer.original().faces());
    print(equalize_report(arguments, equalizer, equalized));
    if (!keeps_lengths(equalized.status)) {
        tell_unequal(arguments, equalizer, equalized);
        return k_not_converged;
    }
    if (equalized.status == Status::exact)
        tell_sharp_quads(equalized.quads_beyond_limit, arguments.shear_limit * k_degree);
    const Net& original = equalizer.original();
    tell_crumpled(new_folds(original, original.rest_positions(), equalizer.positions()), "the mesh did",
                  smoother_way(arguments, equalized));
    tell_far(arguments, equalized);
    return k_success;
}

}  // namespace

Command add_equalize(CLI::App& program) {
    CLI::App& command =
        *program.add_subcommand("equalize", "Turn a mesh into a net near it with edges of one length; report, as JSON");
    const auto arguments = std::make_shared<EqualizeArguments>();
    add_net_argument(command, arguments->net);
    command
        .add_option(
            "--length", arguments->length,
            "mean: of the edges; fit: so that the net lies nearest to the mesh; or a number, to which the mesh is "
            "scaled without --hold or --guide: distances are from the scaled one then")
        ->type_name("LENGTH")
        ->capture_default_str();
    command.add_option("--hold", arguments->handles, "Vertices that stay where they are, from 0")->type_name("VERTEX");
    command
        .add_option("--method", arguments->method,
                    "equilibrium: near the mesh's surface and fair, within the limit, or where no such net is found "
                    "projection, with status exact if corners are sharper; projection: lengths alone; with --guide the "
                    "first, without it " +
                        usual_methods())
        ->type_name("METHOD");
    command
        .add_option("--shear-limit", arguments->shear_limit,
                    "With equilibrium no corner of a quad is sharper, degrees; 0: none")
        ->type_name("NUMBER")
        ->capture_default_str();
    command
        .add_option("--guide", arguments->guide,
                    "With equilibrium the net comes near this surface and not near the mesh's own: a file, or the name "
                    "of one of ours (see drape)")
        ->type_name("SURFACE");
    add_net_output(command, "-o,--output", arguments->output)->type_name("OUT");
    return {&command, [arguments] { return run_equalize(*arguments); }};
}

}  // namespace chebnet
