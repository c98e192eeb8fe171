#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "net/net.h"
#include "net/topology.h"

namespace chebnet {

/// Where a piece of a net lies in its pattern: the squares from a column and a row on.
struct PatternPiece {
    int column = 0, row = 0;
    int columns = 0, rows = 0;
};

/// A net laid flat: where no vertex is singular, a Chebyshev net is a piece of the square grid, or several.
struct FlatPattern {
    Eigen::Matrix2Xd places{};         ///< 2×V, column and row of each vertex, from 0; between two where a rod is cut
    int columns = 0, rows = 0;         ///< of squares
    std::vector<PatternPiece> pieces;  ///< by their first faces; at least one
};

/// Why a net has no flat pattern.
struct PatternFault {
    enum class Reason {
        not_quads,  ///< `face` is none, nor what a border leaves of one
        unequal,    ///< rest lengths differ, and not only of rods that end, cut, on the boundary
        loose,      ///< nothing says where `face` lies: no rod leads to it, or only some that are cut at both ends
        singular,   ///< the inner `vertex` has another valence than 4
        closed,     ///< two ways to `vertex` lead to two places
        overlap,    ///< `face` would lie upon another one
        touching,   ///< faces meet at `vertex`, but not at an edge there
    };
    Reason reason = Reason::not_quads;
    int vertex = -1, face = -1;
};
const char* to_string(PatternFault::Reason reason);

/// Lays the faces as squares in the plane, each beside one before it. Rows count upwards, and the first face of each
/// piece that has a whole rod is seen from its front. Where rods are cut at a border (see drape/border_cut.h) each
/// keeps its length, and the edges between their ends become as long as that makes them. Pieces lie in lines as words
/// do, two squares apart, about as wide as high in all. What is a rod and what a rim says cell_sides(). Rest lengths
/// nearer to that of whole edges than whole_edge_tolerance() are that, and those across a strip one cell wide that was
/// cut alike are one length.
std::variant<FlatPattern, PatternFault> flat_pattern(const Net& net, const Topology& topology);

}  // namespace chebnet
