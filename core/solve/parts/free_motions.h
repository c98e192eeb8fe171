#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "net/net.h"
#include "net/topology.h"
#include "solve/options.h"
#include "solve/pull.h"
#include "solve/slide.h"

namespace chebnet {

/// The turns and shifts of whole pieces of a net that nothing resists: no fixed vertex, no axis that a slide keeps, no
/// pull and no weight. A net that two handles hold turns freely about the line through them; one whose feet slide on
/// the ground, about the handle that lifts its middle. Its energy stays the same, but a step of Newton's method away
/// from rest may have a part of it, as M treats it like any other way: the net would spin.
class FreeMotions {
public:
    FreeMotions(const Net& net, const Topology& topology, std::span<const int> fixed, std::span<const Slide> slides);

    /// From now on with these pulls, of soft handles, and the gravity of these options.
    void set_forces(std::span<const Pull> pulls, const Options& options);
    /// Takes those of a net that stands there (3×V).
    void begin(const Positions& x);
    /// Takes away from the columns (3×V) what they have of them.
    void take_out(Eigen::Matrix3Xd& vectors) const;

private:
    struct Piece {
        std::vector<int> vertices, fixed, pulled;
        Axes kept = k_no_axes;  // by something that slides
    };
    struct Motion {
        const Piece* piece = nullptr;
        Eigen::Matrix3Xd moves;  // of its vertices; of length 1, and orthogonal to those before
    };
    void find_motions(const Piece& piece, const Positions& x);

    std::vector<Piece> m_pieces;
    std::vector<int> m_piece_of_vertex;
    Axes m_kept_by_weight = k_no_axes;
    std::vector<Motion> m_motions;  // the first so many; more have been there before
    std::size_t m_count = 0;
};

}  // namespace chebnet
