#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "net/net.h"
#include "solve/options.h"

namespace chebnet {

class Guide;

/// A vertex that is held at a point: exactly, or softly by a pull beside which the net keeps its edges and its shape. A
/// soft handle's weight is finite and above 0; an edge has the weight 1 (see Pull).
struct Handle {
    int vertex;
    Eigen::Vector3d target;
    double weight = std::numeric_limits<double>::infinity();

    bool is_exact() const { return weight == std::numeric_limits<double>::infinity(); }
    bool operator==(const Handle&) const = default;
};

/// Where a net may move; see Editor::set_locality().
struct Locality {
    double radius;             ///< in mean edge lengths along the net, above 0
    std::vector<int> origins;  ///< vertices
    Positions held_at;         ///< 3×V, where the net stood when this began and is held; empty: where it stands now

    bool operator==(const Locality&) const = default;
};

/// The state of an edit, with all that another editor of the same net needs to go on from there: editors that
/// were set to the same state (Editor::set_state()) solve to the same positions, bit for bit. What is not in it: what a
/// method keeps of the frames before, such as factors and the rigid shape of `projection`, so that a first editor that
/// goes on warm may find other positions, as good; a solve under way, which begins anew, as does its count of
/// iterations.
struct EditState {
    std::vector<Handle> handles;
    std::string method;          ///< a name in method_table(), or the method that the editor has already
    std::string initialisation;  ///< see Initialisation
    Options options;
    std::optional<Locality> locality;    ///< none: everything may move
    std::shared_ptr<const Guide> guide;  ///< a surface beside the net, see Options::guide_mode; null: none
    Positions positions;                 ///< 3×V, finite: a vertex that was a far handle once may be anywhere

    bool operator==(const EditState&) const = default;
};

}  // namespace chebnet
