#include "drape/bridged_drape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/error.h"
#include "drape/bound.h"
#include "drape/draped_net.h"
#include "drape/opened_corners.h"
#include "drape/slits.h"
#include "drape/surroundings.h"

namespace chebnet {

namespace {

constexpr double k_highest = 10;  // in edge lengths
// Corners to begin with, as a part of the limit: the next where one covers no more than the net that locks.
constexpr double k_sharper[] = {0.5, 0.75};

/// `faces`: of the surface, near the vertices and on their side of slits.
std::vector<DrapedVertex> draped_vertices(const Compass& compass, const Positions& positions,
                                          const std::vector<int>& faces) {
    std::vector<DrapedVertex> vertices;
    for (const auto& position : positions.colwise())
        vertices.push_back(compass.vertex_at(position, faces[vertices.size()]));
    return vertices;
}

bool is_parted(const Compass& compass, const std::vector<DrapedVertex>& vertices, std::span<const int> face) {
    for (std::size_t k = 0; k < face.size(); ++k)
        if (compass.is_slit_between(vertices[face[k]], vertices[face[(k + 1) % face.size()]])) return true;
    return false;
}

/// Whether a cell ends at the border as drape() says: opening corners may have moved it there.
bool keeps_border(const Compass& compass, const DrapeOptions& options, const Slits* slits,
                  const std::vector<DrapedVertex>& vertices, std::span<const int> face) {
    const auto is_on_surface = [&](int v) { return compass.is_on_surface(vertices[v]); };
    const auto may_stand = [&](int v) { return is_on_surface(v) || !is_bound(options, slits, vertices[v].at); };
    return std::any_of(face.begin(), face.end(), is_on_surface) && std::all_of(face.begin(), face.end(), may_stand);
}

/// Which vertices do not lie on those before them, which are nearer to the seed. Opening corners may have moved them
/// there. `places`: their steps from the seed. `smallest_angle`: of corners, radians.
std::vector<bool> beside_others(const Compass& compass, const std::vector<DrapedVertex>& vertices,
                                const Eigen::Matrix2Xi& places, double smallest_angle) {
    Surroundings surroundings(compass.length());
    std::vector<bool> is_beside(vertices.size());
    for (int v = 0; v < std::ssize(vertices); ++v) {
        is_beside[v] = !surroundings.any_near(vertices[v].position, [&](int other) {
            return lie_on_each_other(compass, vertices[other], vertices[v], places.col(v) - places.col(other),
                                     smallest_angle);
        });
        if (is_beside[v]) surroundings.add(vertices[v].position, v);
    }
    return is_beside;
}

/// The cells that are near enough, within the limit, on no others, across no slit and not farther over the border than
/// they may be, joined to the seed.
std::vector<std::array<int, 4>> good_cells(const Drape& laid, const Compass& compass, const DrapeOptions& options,
                                           const Slits* slits, const std::vector<DrapedVertex>& vertices,
                                           const Eigen::VectorXd& heights, double most_height) {
    const Net& net = laid.net;
    const std::vector<bool> is_beside = beside_others(compass, vertices, laid.places, options.smallest_angle);
    std::vector<std::vector<int>> good;
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        std::array<Eigen::Vector3d, 4> corners;
        std::transform(face.begin(), face.end(), corners.begin(), [&](int v) { return vertices[v].position; });
        const bool is_near = std::all_of(face.begin(), face.end(),
                                         [&](int v) { return std::abs(heights[v]) <= most_height && is_beside[v]; });
        if (is_near && keeps_limit(corners, largest_cosine(options.smallest_angle)) &&
            !is_parted(compass, vertices, face) && keeps_border(compass, options, slits, vertices, face))
            good.emplace_back(face.begin(), face.end());
    }
    std::vector<std::array<int, 4>> cells;
    for (const std::vector<int>& face : joined_to_seed(good)) cells.push_back({face[0], face[1], face[2], face[3]});
    return cells;
}

/// Laid with corners sharper than the limit, which are opened then; nothing where that leads to no net.
std::optional<Drape> opened_drape(const Guide& guide, const DrapeOptions& options, double sharper, double most_height) {
    DrapeOptions to_open = options;
    to_open.smallest_angle *= sharper;
    if (options.border == DrapeOptions::Border::cut) {
        to_open.border = DrapeOptions::Border::beyond;
        to_open.beyond_cuts = true;
    }
    const Drape laid = drape(guide.surface(), guide.tree(), to_open);
    const std::optional<Positions> positions = with_opened_corners(laid.net, guide, options.smallest_angle);
    if (!positions) return std::nullopt;
    std::optional<Slits> own;
    if (options.slits) own.emplace(guide.surface(), guide.tree(), options.length, options.seam);
    const Slits* const slits = own && !own->none() ? &*own : nullptr;
    const Compass compass(guide.surface(), guide.tree(), options.length, slits);
    const std::vector<DrapedVertex> vertices = draped_vertices(compass, *positions, laid.faces);
    const std::vector<std::array<int, 4>> cells = good_cells(
        laid, compass, options, slits, vertices, heights_over(guide, *positions), most_height * options.length);
    BorderCut left;
    if (options.border == DrapeOptions::Border::cut)
        left = cut_at_border(compass, options.smallest_angle, vertices, cells);
    else
        for (const auto& cell : cells) left.faces.emplace_back(cell.begin(), cell.end());
    if (left.faces.empty()) return std::nullopt;
    Drape opened = draped_net(vertices, laid.places, left);
    opened.locked = laid.locked;
    opened.met = laid.met;
    opened.arms = laid.arms;
    return opened;
}

}  // namespace

Drape bridged_drape(const std::shared_ptr<const Guide>& guide, const DrapeOptions& options, double most_height) {
    if (!(most_height > 0 && most_height <= k_highest))
        throw Error(ErrorCode::bad_option, "the net may leave the surface by more than 0 and up to 10 edge lengths");
    Drape locked = drape(guide->surface(), guide->tree(), options);
    if (locked.locked == 0) return locked;
    const auto coverage = [&](const Drape& laid) {
        return measure_drape(guide->surface(), guide->tree(), laid.net, options.length).coverage;
    };
    const double enough = coverage(locked);
    for (const double sharper : k_sharper) {
        std::optional<Drape> opened = opened_drape(*guide, options, sharper, most_height);
        if (opened && coverage(*opened) > enough) return std::move(*opened);
    }
    return locked;
}

}  // namespace chebnet
