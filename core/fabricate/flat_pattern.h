#pragma once

#include <Eigen/Core>
#include <variant>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// A net laid flat: where no vertex is singular, a Chebyshev net is a piece of the square grid.
struct FlatPattern {
    Eigen::Matrix2Xi places;    ///< 2×V, column and row of each vertex, from 0
    int columns = 0, rows = 0;  ///< of squares
};

/// Why a net has no flat pattern.
struct PatternFault {
    enum class Reason {
        not_quads,  ///< `face` is none
        unequal,    ///< rest lengths differ
        singular,   ///< the inner `vertex` has another valence than 4
        closed,     ///< two ways to `vertex` lead to two places
        overlap,    ///< `face` would lie upon another one
        pieces,     ///< the net is not in one piece
    };
    Reason reason = Reason::not_quads;
    int vertex = -1, face = -1;
};
const char* to_string(PatternFault::Reason reason);

/// Lays the faces as squares in the plane, each beside one before it. Rows count upwards, and the first face is seen
/// from its front. Rest lengths that differ by less than 1e-6 of a length are one length.
std::variant<FlatPattern, PatternFault> flat_pattern(const Net& net, const Topology& topology);

}  // namespace chebnet
