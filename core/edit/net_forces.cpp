#include "edit/net_forces.h"

#include "fabricate/edge_table.h"
#include "solve/parts/length_system.h"
#include "solve/parts/rest_energy.h"
#include "solve/rest_state.h"
#include "solve/terms/load_terms.h"

namespace chebnet {

namespace {

/// 3×V, what the multipliers do to the ends of the rows, Jᵀλ.
Eigen::Matrix3Xd pull_of_rows(const RestState& state) {
    Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, state.net.vertex_count());
    for (int row = 0; row < state.system.row_count(); ++row) {
        if (!state.system.is_on(row)) continue;
        const auto& [a, b, distance, unit] = state.system.row(row);
        const Eigen::Vector3d along = (state.positions.col(a) - state.positions.col(b)).normalized();
        const Eigen::Vector3d force = state.multipliers[row] / unit * along;
        sum.col(a) += force;
        sum.col(b) -= force;
    }
    return sum;
}

/// 3×V, what holds each vertex: ∇E + Jᵀλ, without the pulls in E. 0 at rest where nothing does.
Eigen::Matrix3Xd supports(const RestState& state) {
    Eigen::Matrix3Xd pulls = Eigen::Matrix3Xd::Zero(3, state.net.vertex_count());
    PullTerm(state.net, state.pulls).evaluate(state.positions, pulls);
    return state.gradient - pulls + pull_of_rows(state);
}

std::vector<CornerForce> corner_forces(const RestState& state) {
    const double L = state.net.mean_length();
    std::vector<CornerForce> corners;
    for (int row = state.net.edge_count(); row < state.system.row_count(); ++row) {
        const auto& [a, b, distance, unit] = state.system.row(row);
        if (state.system.is_on(row) && state.multipliers[row] < 0)
            corners.push_back({a, b, -state.multipliers[row] / unit * L});
    }
    return corners;
}

std::vector<TermEnergy> energies(const RestEnergy& energy) {
    std::vector<TermEnergy> table;
    for (std::size_t i = 0; i < energy.values().size(); ++i)
        table.push_back({energy.terms()[i]->name(), energy.values()[i]});
    return table;
}

}  // namespace

std::optional<NetForces> net_forces(const Editor& editor) {
    const std::optional<RestState> state = editor.rest_state();
    if (!state || !state->is_balanced) return std::nullopt;
    NetForces forces{edge_forces(*state), corner_forces(*state), {}, energies(state->energy)};
    std::vector<int> vertices;
    for (const Handle& handle : editor.handles()) vertices.push_back(handle.vertex);
    Eigen::Matrix3Xd held_by = supports(*state);
    // A line that is pulled straight hands on to its ends what it bears, as a beam does.
    const std::vector<TautVertex>& taut = editor.taut_vertices();
    std::vector<int> ends = vertices;
    for (const TautVertex& each : taut) ends.push_back(each.vertex);
    for (auto each = taut.rbegin(); each != taut.rend(); ++each) {
        held_by.col(ends[each->end_a]) += (1 - each->part) * held_by.col(each->vertex);
        held_by.col(ends[each->end_b]) += each->part * held_by.col(each->vertex);
    }
    forces.handles = state->net.mean_length() * held_by(Eigen::all, vertices);
    return forces;
}

std::string edge_table(const Editor& editor) {
    const std::optional<NetForces> forces = net_forces(editor);
    return edge_table(editor.net(), editor.positions(), forces ? forces->edges : Eigen::VectorXd());
}

}  // namespace chebnet
