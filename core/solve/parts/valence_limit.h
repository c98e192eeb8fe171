#pragma once

#include "base/error.h"
#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// All that meets at a vertex is coupled with each other: a dense block of a system, whose factor takes the more
/// operations. Throws Error too_large where they would be too many, before anything is made for them. `unknowns`: of
/// the system, for each edge.
inline void check_valences(const Net& net, const Topology& topology, int unknowns = 1) {
    constexpr double k_most_block_operations = 3e9;
    double operations = 0;
    for (int v = 0; v < net.vertex_count(); ++v) {
        const double size = unknowns * topology.valence(v);
        operations += size * size * size / 3;
    }
    if (operations > k_most_block_operations) throw Error(ErrorCode::too_large, "too many edges meet at one vertex");
}

}  // namespace chebnet
