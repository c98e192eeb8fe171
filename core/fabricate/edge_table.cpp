#include "fabricate/edge_table.h"

#include "base/number.h"
#include "net/measures.h"

namespace chebnet {

std::string edge_table(const Net& net, const Positions& positions, const Eigen::VectorXd& forces) {
    const bool has_forces = forces.size() > 0;
    std::string table = "edge,vertex_a,vertex_b,length,rest_length,deviation";
    table += has_forces ? ",force\n" : "\n";
    for (int e = 0; e < net.edge_count(); ++e) {
        const int a = net.edges()(0, e), b = net.edges()(1, e);
        table += std::to_string(e) + ',' + std::to_string(a) + ',' + std::to_string(b);
        const double length = (positions.col(a) - positions.col(b)).stableNorm(), rest_length = net.rest_lengths()(e);
        for (const double number : {length, rest_length, deviation(length / rest_length)})
            table += ',' + exact_text(number);
        if (has_forces) table += ',' + exact_text(forces[e]);
        table += '\n';
    }
    return table;
}

}  // namespace chebnet
