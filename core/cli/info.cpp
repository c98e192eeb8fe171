#include <memory>

#include "command.h"
#include "net/measures.h"
#include "net/topology.h"
#include "net_argument.h"
#include "report.h"

namespace chebnet {
namespace {

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

int run_info(const NetArgument& argument) {
    const Net net = load_net(argument);
    const Topology topology(net);
    print({{"net", argument.name},
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
    const auto argument = std::make_shared<NetArgument>();
    add_net_argument(command, *argument);
    return {&command, [argument] { return run_info(*argument); }};
}

}  // namespace chebnet
