#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "edit/editor.h"

namespace chebnet {

/// What keeps a corner of a quad from becoming sharper: pushes the ends of a diagonal apart.
struct CornerForce {
    int vertex_a, vertex_b;
    double push;  ///< above 0
};

/// A part of the energy by its name, see Term.
struct TermEnergy {
    const char* name;
    double energy;
};

/// What holds a net at rest: with these forces each vertex is in balance, as far as ToRest::gradient_norm says. All
/// forces are in the unit of Options::gravity, of which an edge of mean length has its weight.
struct NetForces {
    Eigen::VectorXd edges;             ///< E, see edge_forces()
    std::vector<CornerForce> corners;  ///< of the diagonals at the shear limit
    /// 3×handles, what each of them does to the net: the support of an exact one, the pull of a soft one. Without a
    /// guide and a locality their sum bears the net's weight.
    Eigen::Matrix3Xd handles;
    std::vector<TermEnergy> energies;
};

/// Of the last solve; none where the method does not bring nets to rest, or while handles are on their way.
std::optional<NetForces> net_forces(const Editor& editor);

/// The table of its edges, see fabricate/edge_table.h, with their forces if they are known.
std::string edge_table(const Editor& editor);

}  // namespace chebnet
