#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "drape/drape.h"

namespace chebnet {

/// How nets are laid on the pieces of a surface.
struct PiecesOptions {
    DrapeOptions drape;          ///< of each; seed and direction are chosen anew, and arms are geodesic on pieces on
                                 ///< which not all of the curve is that they were to run along
    bool best = false;           ///< each begins where the best of several trials does (see propose_drapes), one with a
                                 ///< seed in the best direction there, all in that of `drape` if `has_direction`
    double leave = 0;            ///< but for 0: how far each may leave the surface (see bridged_drape), in edge lengths
    bool has_direction = false;  ///< all have the direction of `drape`
    bool first_seed = false;     ///< on its piece, the net has the seed of `drape`, and its direction unless the best
                                 ///< is looked for
    std::vector<Eigen::Vector3d> seeds;  ///< none: a net on each piece; else one for each of these, on its piece
};

/// A net on one piece.
struct DrapedPiece {
    int piece = 0;  ///< in the order of pieces_of()
    double area = 0;
    DrapeOptions options;
    Drape drape;
    DrapeReport report{};  ///< of this piece alone
};

/// A piece that has no net, and why.
struct BarePiece {
    int piece = 0;
    double area = 0;
    std::string reason;
};

struct DrapedPieces {
    Net net;  ///< of all pieces, one behind the other in the order of `draped`, no two joined; that of `first_seed`
              ///< comes first, others in the order of their numbers
    std::vector<DrapedPiece> draped;
    std::vector<BarePiece> bare;
    DrapeReport report{};  ///< of all, on the whole surface

    // As of one Drape: of all pieces together.
    Eigen::Matrix2Xi places{};  ///< 2×V, each from the seed of its own piece
    int locked = 0, met = 0, cut_ends = 0;
    DrapeOptions::Arms arms = DrapeOptions::Arms::geodesic;  ///< geodesic where those of all pieces are
};

/// A net on each piece of a surface that may have been cut open (see cut_open), all with edges of one length: each lies
/// on its piece alone, without its roughness (see without_roughness), and no edge goes across a slit. Throws Error
/// bad_option where two seeds are on one piece, and as drape() does if not one piece takes a net, or that of the curve
/// does not.
DrapedPieces drape_pieces(const Surface& surface, const PiecesOptions& wanted);

/// Nets as one, with no vertex in common.
Net side_by_side(const std::vector<DrapedPiece>& pieces);

}  // namespace chebnet
