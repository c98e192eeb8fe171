#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "net/net.h"
#include "solve/options.h"

namespace chebnet {

/// A vertex that is held at a point: exactly, or softly by a pull beside which the net keeps its edges and its shape. A
/// soft handle's weight is finite and above 0; an edge has the weight 1 (see Hold).
struct Handle {
    int vertex;
    Eigen::Vector3d target;
    double weight = std::numeric_limits<double>::infinity();

    bool is_exact() const { return weight == std::numeric_limits<double>::infinity(); }
};

/// Where a net may move; see Editor::set_locality().
struct Locality {
    double radius;             ///< in mean edge lengths along the net, above 0
    std::vector<int> origins;  ///< vertices
    Positions held_at;         ///< 3×V, where the net stood when this began and is held; empty: where it stands now
};

/// All that another editor of the same net needs to go on as this one does: Editor::set_state() of it, and from there
/// on both solve to the same positions. What is not in it follows from it, at the cost of time alone: factorisations,
/// the graph of handles. A solve under way is not in it either; it begins anew from where the net stands, and so does
/// its count of iterations.
struct EditState {
    std::vector<Handle> handles;
    std::string method;          ///< a name in method_table(), or the method that the editor has already
    std::string initialisation;  ///< see Initialisation
    Options options;
    std::optional<Locality> locality;  ///< none: everything may move
    Positions positions;               ///< 3×V
};

}  // namespace chebnet
