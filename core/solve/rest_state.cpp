#include "solve/rest_state.h"

namespace chebnet {

Eigen::VectorXd edge_forces(const RestState& state) {
    const auto edges = state.multipliers.head(state.net.edge_count()).array();
    return state.net.mean_length() * edges / state.net.rest_lengths().array();
}

}  // namespace chebnet
