#include <map>
#include <memory>

#include "command.h"
#include "drape/drape.h"
#include "fabricate/edge_table.h"
#include "fabricate/rod_table.h"
#include "io/file.h"
#include "net/measures.h"
#include "net/topology.h"
#include "net_argument.h"
#include "net_output.h"
#include "report.h"
#include "surface_argument.h"

namespace chebnet {
namespace {

struct InfoArguments {
    NetArgument net;
    std::string edges;    ///< file to write; empty: none
    std::string rods;     ///< likewise
    std::string surface;  ///< one of ours or a file; empty: none
};

Json counts_report(const std::map<int, int>& counts) {
    Json report = Json::object();
    for (const auto& [size, count] : counts) report[std::to_string(size)] = count;
    return report;
}

int run_info(const InfoArguments& arguments) {
    check_apart({arguments.edges, arguments.rods});
    const Net net = load_net(arguments.net);
    const Topology topology(net);
    const LengthRange lengths = edge_length_range(net, net.rest_positions());
    if (!arguments.edges.empty()) write_file(arguments.edges, edge_table(net, net.rest_positions()));
    if (!arguments.rods.empty()) write_file(arguments.rods, rod_table(net, topology, net.rest_positions()));
    const int coinciding = tell_coinciding({net.rest_positions(), net.faces()}, arguments.net.name);
    Json report = {{"net", arguments.net.name},
                   {"vertices", net.vertex_count()},
                   {"coinciding_vertices", coinciding},
                   {"edges", net.edge_count()},
                   {"faces", net.face_count()},
                   {"faces_by_arity", counts_report(faces_by_arity(net.faces()))},
                   {"boundary_loops", topology.boundary_loops().size()},
                   {"components", topology.component_count()},
                   {"singular_vertices_by_valence", counts_report(topology.singular_vertices())},
                   {"shortest_length", lengths.shortest},
                   {"mean_length", net.mean_length()},
                   {"longest_length", lengths.longest},
                   {"max_dL", max_deviation_from_mean(net)},
                   {"chebyshev", net.is_chebyshev()}};
    if (!arguments.surface.empty()) {
        const auto guide = load_guide(arguments.surface, arguments.net.repair);
        report["surface"] = arguments.surface;
        report["on_surface"] = net_on_surface_report(net, measure_drape(guide->surface(), guide->tree(), net));
    }
    print(report);
    return k_success;
}

}  // namespace

Command add_info(CLI::App& program) {
    CLI::App& command = *program.add_subcommand("info", "Describe a net, as JSON");
    const auto arguments = std::make_shared<InfoArguments>();
    add_net_argument(command, arguments->net);
    command.add_option("--edges", arguments->edges, "Write one line for each edge with its length, as CSV")
        ->type_name("EDGES.csv");
    command
        .add_option("--rods", arguments->rods,
                    "Write one line for each rod with its length and the marks where others cross it, as CSV")
        ->type_name("RODS.csv");
    command
        .add_option("--surface", arguments->surface,
                    "File of a surface, or the name of one of our own: how the net lies on it")
        ->type_name("SURFACE");
    return {&command, [arguments] { return run_info(*arguments); }};
}

}  // namespace chebnet
