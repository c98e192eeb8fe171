#include <memory>

#include "command.h"
#include "fabricate/edge_table.h"
#include "io/file.h"
#include "net/measures.h"
#include "net/topology.h"
#include "net_argument.h"
#include "report.h"

namespace chebnet {
namespace {

struct InfoArguments {
    NetArgument net;
    std::string edges;  ///< file to write; empty: none
};

/// Against the mean length, whatever rest lengths the net has.
double max_deviation_from_mean(const Net& net) {
    const Net equal(net.rest_positions(), net.faces(), RestLengths::equal);
    return max_deviation(equal, equal.rest_positions());
}

Json singular_report(const Topology& topology) {
    Json counts = Json::object();
    for (const auto& [valence, count] : topology.singular_vertices()) counts[std::to_string(valence)] = count;
    return counts;
}

int run_info(const InfoArguments& arguments) {
    const Net net = load_net(arguments.net);
    const Topology topology(net);
    if (!arguments.edges.empty()) write_file(arguments.edges, edge_table(net, net.rest_positions()));
    print({{"net", arguments.net.name},
           {"vertices", net.vertex_count()},
           {"edges", net.edge_count()},
           {"faces", net.face_count()},
           {"boundary_loops", topology.boundary_loops().size()},
           {"components", topology.component_count()},
           {"singular_vertices_by_valence", singular_report(topology)},
           {"mean_length", net.mean_length()},
           {"max_dL", max_deviation_from_mean(net)},
           {"chebyshev", net.is_chebyshev()}});
    return k_success;
}

}  // namespace

Command add_info(CLI::App& program) {
    CLI::App& command = *program.add_subcommand("info", "Describe a net, as JSON");
    const auto arguments = std::make_shared<InfoArguments>();
    add_net_argument(command, arguments->net);
    command.add_option("--edges", arguments->edges, "Write one line for each edge with its length, as CSV")
        ->type_name("EDGES.csv");
    return {&command, [arguments] { return run_info(*arguments); }};
}

}  // namespace chebnet
