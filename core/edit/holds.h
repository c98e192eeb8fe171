#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "edit/edit_state.h"
#include "edit/hand.h"
#include "edit/locality.h"
#include "edit/taut_lines.h"
#include "solve/pull.h"
#include "solve/slide.h"

namespace chebnet {

/// How near a handle that is held back has to come to its target, in edge lengths, to be held there after all; beyond
/// that it is pulled no harder.
inline constexpr double k_nearly_there = 0.5;

/// How handles, those in hand among them, and a region hold a net: what of it stands still, slides or is pulled. Keeps
/// references.
struct Holds {
    const std::vector<Handle>& handles;
    const std::vector<int>& handle_at;  ///< V, the place of the handle that holds a vertex, −1 where there is none
    const Hand& hand;
    const Region* region;  ///< that may move; null: everything may
    bool can_slide;        ///< whether the method heeds slides
    double weight;         ///< of the whole net, as a force over the mean length: what is in hand can bear all of it

    /// Null: no handle holds the vertex.
    const Handle* handle(int vertex) const;
    /// Held at its target by the method, rather than pulled there.
    bool is_held(const Handle& handle) const;
    /// Along which its vertex may move: held back, along those of the hand, too.
    Axes axes(const Handle& handle) const;
    std::vector<Slide> slides() const;
    /// Exact handles that do not slide, what they pull straight, and what lies outside the region.
    std::vector<int> fixed_vertices(std::span<const TautVertex> taut) const;
    /// Those of soft handles, of those held back and of the region, in another unit of length, in which edges have this
    /// mean length and handles these targets. Pulls at one vertex are joined into one; a fixed vertex cannot be pulled.
    std::vector<Pull> pulls(double unit, double mean_length, const Eigen::Matrix3Xd& targets) const;

private:
    bool is_outside(const Handle& handle) const { return region != nullptr && region->is_outside(handle.vertex); }
    Pull pull_of(const Handle& handle, const Eigen::Vector3d& target, double mean_length) const;
};

}  // namespace chebnet
