#include "drape/drape_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "base/error.h"
#include "drape/bridged_drape.h"
#include "drape/proposals.h"
#include "surface/geodesics.h"
#include "surface/guide.h"
#include "surface/smoothed_surface.h"
#include "surface/surface_cut.h"
#include "surface/surface_parts.h"

namespace chebnet {

namespace {

int piece_of(const Surface& surface, const Eigen::Vector3d& point) {
    return surface.components()[SurfaceTree(surface).nearest(point).at.face];
}

/// By the numbers of the pieces on which they are.
std::map<int, Eigen::Vector3d> seeds_by_piece(const Surface& surface, const std::vector<Eigen::Vector3d>& seeds) {
    const SurfaceTree tree(surface);
    const std::vector<int> component = surface.components();
    std::map<int, Eigen::Vector3d> by_piece;
    for (std::size_t k = 0; k < seeds.size(); ++k) {
        if (!seeds[k].allFinite())
            throw Error(ErrorCode::non_finite,
                        "seed " + std::to_string(k + 1) + " has a coordinate that is not finite");
        if (!by_piece.emplace(component[tree.nearest(seeds[k]).at.face], seeds[k]).second)
            throw Error(ErrorCode::bad_option,
                        "seed " + std::to_string(k + 1) + " is on a piece of the surface that has another already");
    }
    return by_piece;
}

// In edge lengths: nearer to a border or a slit a net would hardly begin.
constexpr double k_clear_of_border = 2;
// In edge lengths: how far off a curve may be that lies on a piece.
constexpr double k_on_piece = 1e-6;

/// Of each vertex, to the nearest border; infinity if there is none.
std::vector<double> distances_from_border(const Surface& surface) {
    std::vector<SurfacePoint> sources;
    for (const std::vector<int>& loop : surface.boundary_loops())
        for (const int side : loop) sources.push_back(Surface::start_of(side));
    return geodesic_distances(surface, sources);
}

/// In the middle or, where that is near a border or a slit, as far from these as can be.
Eigen::Vector3d beginning_on(const Guide& piece, double length) {
    const Surface& surface = piece.surface();
    const Eigen::Vector3d middle = suggested_drape(surface, piece.tree(), 1).seed;
    const std::vector<double> distances = distances_from_border(surface);
    const int nearest = surface.triangles()(0, piece.tree().nearest(middle).at.face);
    if (distances[nearest] >= k_clear_of_border * length) return middle;
    const auto farthest = std::max_element(distances.begin(), distances.end()) - distances.begin();
    return surface.positions().col(farthest);
}

DrapeOptions options_on(const Guide& piece, const PiecesOptions& options, const Eigen::Vector3d* seed) {
    DrapeOptions own = options.drape;
    own.slits = true;  // trials keep to them, too
    own.seed = seed != nullptr ? *seed : beginning_on(piece, options.drape.length);
    if (!options.has_direction) own.direction = suggested_direction(piece.surface(), piece.tree(), own.seed);
    if (!options.best || (seed != nullptr && options.has_direction)) return own;
    if (seed != nullptr) return with_best_direction(piece.surface(), piece.tree(), own);
    const auto propose = options.has_direction ? propose_seeds : propose_drapes;
    return propose(piece.surface(), piece.tree(), own).front().options;
}

/// A curve's points on the surface.
Positions laid_onto(const Surface& surface, const Positions& points) {
    const SurfaceTree tree(surface);
    Positions laid(3, points.cols());
    for (Eigen::Index k = 0; k < points.cols(); ++k)
        laid.col(k) = surface.position_at(
            point_meant(surface, tree, points.col(k), "point " + std::to_string(k + 1) + " of the curve"));
    return laid;
}

bool is_on(const Guide& piece, const Positions& points, double tolerance) {
    return std::all_of(points.colwise().begin(), points.colwise().end(),
                       [&](const Eigen::Vector3d& point) { return piece.tree().nearest(point).distance <= tolerance; });
}

const std::string k_no_seed = "no seed is on it";

/// Where a side goes from and to.
using Ends = std::array<double, 6>;

Ends ends_of(const Surface& surface, int side) {
    const Eigen::Vector3d from = surface.positions().col(surface.from(side)),
                          to = surface.positions().col(surface.to(side));
    return {from.x(), from.y(), from.z(), to.x(), to.y(), to.z()};
}

/// Of the sides along which a surface has been cut.
std::set<Ends> cut_ends(const Surface& surface) {
    std::set<Ends> cut;
    const std::vector<int> facing = facing_sides(surface);
    for (int side = 0; side < std::ssize(facing); ++side)
        if (facing[side] >= 0) cut.insert(ends_of(surface, side));
    return cut;
}

/// Which sides of a piece are among those; empty if there are none.
std::vector<bool> sides_among(const Surface& piece, const std::set<Ends>& cut) {
    if (cut.empty()) return {};
    std::vector<bool> is_cut(3 * static_cast<std::size_t>(piece.face_count()));
    for (int side = 0; side < 3 * piece.face_count(); ++side)
        is_cut[side] = piece.opposite(side) < 0 && cut.contains(ends_of(piece, side));
    return is_cut;
}

/// `laid_on`: the piece without its roughness.
DrapedPiece draped_from(int number, const std::shared_ptr<const Guide>& piece,
                        const std::shared_ptr<const Guide>& laid_on, DrapeOptions own, double leave) {
    own.slits = true;
    const bool has_curve = own.arms == DrapeOptions::Arms::curve;
    if (has_curve && !is_on(*piece, own.along, k_on_piece * own.length)) own.arms = DrapeOptions::Arms::geodesic;
    Drape draped = leave != 0 ? bridged_drape(laid_on, own, leave) : drape(laid_on->surface(), laid_on->tree(), own);
    const DrapeReport report = measure_drape(piece->surface(), piece->tree(), draped.net, own.length);
    return {number, piece->surface().area(), own, std::move(draped), report};
}

DrapedPiece draped_piece(int number, const std::shared_ptr<const Guide>& piece,
                         const std::shared_ptr<const Guide>& laid_on, const PiecesOptions& options,
                         const Eigen::Vector3d* seed) {
    return draped_from(number, piece, laid_on, options_on(*laid_on, options, seed), options.leave);
}

void add_up(DrapedPieces& made) {
    made.places.resize(2, made.net.vertex_count());
    Eigen::Index first = 0;
    for (const DrapedPiece& piece : made.draped) {
        const Drape& drape = piece.drape;
        made.places.middleCols(first, drape.places.cols()) = drape.places;
        first += drape.places.cols();
        made.locked += drape.locked;
        made.met += drape.met;
        made.cut_ends += drape.cut_ends;
        if (drape.arms != DrapeOptions::Arms::geodesic) made.arms = drape.arms;
    }
}

}  // namespace

Net side_by_side(const std::vector<DrapedPiece>& pieces) {
    Eigen::Index count = 0;
    for (const DrapedPiece& piece : pieces) count += piece.drape.net.vertex_count();
    Positions positions(3, count);
    Faces faces;
    int first = 0;
    for (const DrapedPiece& piece : pieces) {
        const Net& net = piece.drape.net;
        positions.middleCols(first, net.vertex_count()) = net.rest_positions();
        for (int f = 0; f < net.face_count(); ++f) {
            std::vector<int> face(net.faces()[f].begin(), net.faces()[f].end());
            for (int& vertex : face) vertex += first;
            faces.add(face);
        }
        first += net.vertex_count();
    }
    return Net(std::move(positions), std::move(faces));
}

DrapedPieces drape_pieces(const Surface& surface, const PiecesOptions& wanted) {
    check_drape(surface, wanted.drape);
    PiecesOptions options = wanted;
    const bool wants_curve = wanted.drape.arms == DrapeOptions::Arms::curve;
    if (wants_curve) options.drape.along = laid_onto(surface, wanted.drape.along);
    const std::map<int, Eigen::Vector3d> seeds = seeds_by_piece(surface, options.seeds);
    std::vector<Surface> pieces = pieces_of(surface);
    const std::set<Ends> cuts = cut_ends(surface);
    const int first = options.first_seed ? piece_of(surface, options.drape.seed) : -1;
    std::vector<DrapedPiece> draped;
    std::vector<BarePiece> bare;
    std::optional<Error> refused;
    for (int number = 0; number < std::ssize(pieces); ++number) {
        const double area = pieces[number].area();
        const auto found = seeds.find(number);
        if (!seeds.empty() && found == seeds.end()) {
            bare.push_back({number, area, k_no_seed});
            continue;
        }
        const Eigen::Vector3d* seed = found != seeds.end() ? &found->second : nullptr;
        if (number == first) seed = &options.drape.seed;
        const bool is_given = number == first && (!options.best || options.has_direction);
        try {
            options.drape.seam = sides_among(pieces[number], cuts);
            const auto piece = std::make_shared<const Guide>(std::move(pieces[number]));
            const auto laid_on = without_roughness(piece, options.drape.length);
            draped.push_back(is_given ? draped_from(number, piece, laid_on, options.drape, options.leave)
                                      : draped_piece(number, piece, laid_on, options, seed));
        } catch (const Error& error) {
            if (!refused) refused = error;
            bare.push_back({number, area, error.what()});
        }
    }
    const bool has_curve = std::any_of(draped.begin(), draped.end(), [&](const DrapedPiece& piece) {
        return piece.options.arms == DrapeOptions::Arms::curve;
    });
    if (draped.empty() || (wants_curve && !has_curve))
        throw refused ? *refused : Error(ErrorCode::bad_option, "no piece has all of the curve");
    std::stable_partition(draped.begin(), draped.end(), [&](const DrapedPiece& piece) { return piece.piece == first; });
    Net net = side_by_side(draped);
    const DrapeReport report = measure_drape(surface, SurfaceTree(surface), net, options.drape.length);
    DrapedPieces made{std::move(net), std::move(draped), std::move(bare), report};
    add_up(made);
    return made;
}

}  // namespace chebnet
