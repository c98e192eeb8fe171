#include "change/change.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "base/angle.h"
#include "base/error.h"
#include "command.h"
#include "edit/exact_change.h"
#include "net/measures.h"
#include "net/topology.h"
#include "net_argument.h"
#include "net_output.h"
#include "report.h"
#include "text_table.h"

namespace chebnet {
namespace {

struct ChangeArguments {
    NetArgument net;
    std::string name;
    std::vector<int> line;
    std::vector<int> vertices;
    NetOutput output;
};

/// Of the net line from vertex a to its neighbour b.
std::vector<int> edges_of_line(const Net& net, int a, int b) {
    const Topology topology(net);
    for (const std::vector<int>& line : topology.net_lines()) {
        std::vector<int> edges;
        bool is_it = false;
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
            is_it = is_it || std::minmax(line[k], line[k + 1]) == std::minmax(a, b);
            edges.push_back(topology.edge_between(line[k], line[k + 1]));
        }
        if (is_it) return edges;
    }
    throw Error(ErrorCode::bad_option,
                "--line wants the two ends of an edge, not " + std::to_string(a) + " and " + std::to_string(b));
}

/// The option that names this part of a place.
std::string option_of(PlacePart part) { return part == PlacePart::edges ? "--line" : "--vertices"; }

/// A place that the change does not read would be passed over in silence, and the whole net be changed.
void check_reads(const ChangeInfo& change, PlacePart given) {
    if (change.place_part == given) return;
    const std::string reads = change.place_part == PlacePart::nothing
                                  ? " changes the whole net: it takes no "
                                  : " takes its place from " + option_of(change.place_part) + ", not from ";
    throw Error(ErrorCode::bad_option, change.name + reads + option_of(given));
}

/// Without a place a change would but say that nothing is there.
void check_has_place(const ChangeInfo& change, const ChangeArguments& arguments) {
    const bool lacks_line = change.place_part == PlacePart::edges && arguments.line.empty();
    const bool lacks_vertices = change.place_part == PlacePart::vertices && arguments.vertices.empty();
    if (lacks_line || lacks_vertices)
        throw Error(ErrorCode::bad_option, change.name + std::string(" needs a place: ") +
                                               (lacks_line ? "--line A B, the net line from vertex A to its neighbour B"
                                                           : "--vertices, one or more"));
}

int run_change(const ChangeArguments& arguments) {
    const Net net = load_net(arguments.net);
    const ChangeInfo& change = find_change(arguments.name);
    if (!arguments.line.empty()) check_reads(change, PlacePart::edges);
    if (!arguments.vertices.empty()) check_reads(change, PlacePart::vertices);
    check_has_place(change, arguments);
    ChangePlace place;
    place.vertices = arguments.vertices;
    if (!arguments.line.empty()) place.edges = edges_of_line(net, arguments.line[0], arguments.line[1]);
    const ChangedMesh changed = change.make(net, place);
    const ExactChangeOptions options{.length = net.is_chebyshev() ? std::optional(net.mean_length()) : std::nullopt};
    ExactChange exact(changed, options);
    const Status status = exact.solve().status;

    const Net after(exact.positions(), changed.mesh.faces);  // before it is written: refuses what is no net
    write_net(arguments.output, exact.positions(), changed.mesh.faces);
    if (status == Status::exact)
        tell_sharp_quads(sharp_quads(after, exact.positions(), options.shear_limit - k_limit_tolerance),
                         options.shear_limit);
    const LengthRange lengths = edge_length_range(after, exact.positions());
    const double wanted = options.length ? changed.length_factor * *options.length : 0;
    const double max_dL =
        options.length ? std::max(deviation(lengths.shortest / wanted), deviation(lengths.longest / wanted)) : 0;
    print({{"net", arguments.net.name},
           {"change", arguments.name},
           {"status", to_string(status)},
           {"vertices", after.vertex_count()},
           {"faces", after.face_count()},
           {"pieces", Topology(after).component_count()},
           {"length", after.mean_length()},
           {"shortest_length", lengths.shortest},
           {"longest_length", lengths.longest},
           {"chebyshev", after.is_chebyshev()},
           {"max_dL", max_dL},
           {"smallest_corner_angle_degrees", corner_angle_range(after, exact.positions()).smallest / k_degree}});
    return keeps_lengths(status) ? k_success : k_not_converged;
}

std::string change_list() {
    std::vector<std::vector<std::string>> rows;
    for (const ChangeInfo& change : change_table()) rows.push_back({change.name, change.sentence});
    return "Changes:\n" + text_table(rows);
}

}  // namespace

Command add_change(CLI::App& program) {
    CLI::App& command =
        *program.add_subcommand("change", "Change the faces of a net and make its edges exact again; report, as JSON");
    const auto arguments = std::make_shared<ChangeArguments>();
    add_net_argument(command, arguments->net);
    command.add_option("CHANGE", arguments->name, "See below")->required();
    command.add_option("--line", arguments->line, "The net line that goes from vertex A to its neighbour B")
        ->expected(2)
        ->type_name("A B");
    command.add_option("--vertices", arguments->vertices, "Where faces or pieces are deleted or kept, from 0")
        ->type_name("VERTEX");
    add_net_output(command, "-o,--output", arguments->output)->type_name("OUT");
    command.footer(change_list());
    return {&command, [arguments] { return run_change(*arguments); }};
}

}  // namespace chebnet
