#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "net/net.h"
#include "solve/options.h"
#include "solve/slide.h"

namespace chebnet {

class Guide;
class Method;

/// A vertex that is held at a point: exactly, or softly by a pull beside which the net keeps its edges and its shape. A
/// soft handle's weight is finite and above 0, and counts as k_most_pull at most; an edge has the weight 1 (see Pull).
/// An exact handle may slide: it holds some coordinates and leaves the others, one or two, to the net; there its target
/// follows the vertex. Methods that do not know this (Heeds::slides) hold it where it stands.
struct Handle {
    int vertex;
    Eigen::Vector3d target;
    double weight = std::numeric_limits<double>::infinity();
    Axes slides = k_no_axes;  ///< along these

    bool is_exact() const { return weight == std::numeric_limits<double>::infinity(); }
    /// Exact in all its coordinates.
    bool is_pinned() const { return is_exact() && slides == k_no_axes; }
    /// Whether a vertex there is where an exact handle holds it.
    bool holds_at(const Eigen::Vector3d& position) const { return across(slides, position) == across(slides, target); }
    /// Takes the target to where the vertex has slid.
    void follow(const Eigen::Vector3d& position) { copy_along(slides, position.data(), target.data()); }
    /// The same, and puts the vertex of an exact handle where that holds it.
    void snap(Eigen::Ref<Eigen::Vector3d> position) {
        follow(position);
        position = target;
    }
    bool operator==(const Handle&) const = default;
};

/// Where a net may move; see Editor::set_locality().
struct Locality {
    double radius;             ///< in mean edge lengths along the net, above 0
    std::vector<int> origins;  ///< vertices
    Positions held_at;         ///< 3×V, where the net stood when this began and is held; empty: where it stands now

    bool operator==(const Locality& other) const {
        const bool same_size = held_at.cols() == other.held_at.cols();
        return radius == other.radius && origins == other.origins && same_size && held_at == other.held_at;
    }
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

/// Throws Error non_finite.
void check_target(int vertex, const Eigen::Vector3d& target);
/// Throws Error bad_option where a handle is soft and the method, of this name, keeps all of them exactly.
void check_softness(const std::vector<Handle>& handles, const Method& method, const std::string& name);
/// Throws Error index_out_of_range for a wrong size, non_finite.
void check_positions(const Net& net, const Positions& positions);
/// Throws Error bad_option unless the radius is above 0, index_out_of_range; and as check_positions() does.
void check_locality(const Net& net, const Locality& locality);
/// The same for a whole state that is to be solved by the method; throws as Editor::set_handles() does, too.
void check_state(const Net& net, const EditState& state, const Method& method);

/// Puts exact handles to their targets.
void snap(std::vector<Handle>& handles, Positions& positions);
/// The state in the form of Editor::state(): exact handles at their targets, no locality where everything may move.
void normalise(EditState& state);

}  // namespace chebnet
