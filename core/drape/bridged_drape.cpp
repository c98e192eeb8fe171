#include "drape/bridged_drape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "base/error.h"
#include "drape/draped_net.h"
#include "edit/resting_near.h"
#include "surface/height.h"

namespace chebnet {

namespace {

constexpr double k_highest = 10;            // in edge lengths
constexpr double k_sharper = 0.5;           // corners to begin with, as a part of the limit
constexpr double k_anchor_weight = 0.02;    // enough for the net not to slide over its surface
constexpr double k_angle_tolerance = 2e-4;  // radians
constexpr const char* k_iterations = "100";

/// At rest near the surface, with no corner sharper than the limit where that can be.
Positions at_rest(const Net& net, const std::shared_ptr<const Guide>& guide, double limit) {
    Editor editor = resting_near(net, guide, limit);
    std::vector<Handle> anchors;
    for (int v = 0; v < net.vertex_count(); ++v) anchors.push_back({v, net.rest_positions().col(v), k_anchor_weight});
    editor.set_handles(anchors);
    editor.set_option("max_iterations", k_iterations);
    editor.solve();
    return editor.positions();
}

std::vector<DrapedVertex> draped_vertices(const Guide& guide, const Positions& positions) {
    std::vector<DrapedVertex> vertices;
    for (const auto& position : positions.colwise()) {
        const int guess = vertices.empty() ? 0 : vertices.back().at.face;
        const Height height = height_of(guide.surface(), guide.tree(), position, guess);
        vertices.push_back({position, height.at, height.normal, height.overhang});
    }
    return vertices;
}

bool keeps_limit(const std::array<Eigen::Vector3d, 4>& cell, double limit) {
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector3d a = cell[(k + 1) % 4] - cell[k], b = cell[(k + 3) % 4] - cell[k];
        if (std::abs(a.dot(b)) > std::cos(limit - k_angle_tolerance) * a.norm() * b.norm()) return false;
    }
    return true;
}

/// The cells that are near enough and within the limit, joined to the seed.
std::vector<std::array<int, 4>> good_cells(const Net& net, const Positions& positions, const Eigen::VectorXd& heights,
                                           double most_height, double limit) {
    std::vector<std::vector<int>> good;
    for (int f = 0; f < net.face_count(); ++f) {
        const std::span<const int> face = net.faces()[f];
        std::array<Eigen::Vector3d, 4> corners;
        std::transform(face.begin(), face.end(), corners.begin(), [&](int v) { return positions.col(v); });
        const bool is_near =
            std::all_of(face.begin(), face.end(), [&](int v) { return std::abs(heights[v]) <= most_height; });
        if (is_near && keeps_limit(corners, limit)) good.emplace_back(face.begin(), face.end());
    }
    std::vector<std::array<int, 4>> cells;
    for (const std::vector<int>& face : joined_to_seed(good)) cells.push_back({face[0], face[1], face[2], face[3]});
    return cells;
}

}  // namespace

Drape bridged_drape(const std::shared_ptr<const Guide>& guide, const DrapeOptions& options, double most_height) {
    if (!(most_height > 0 && most_height <= k_highest))
        throw Error(ErrorCode::bad_option, "the net may leave the surface by more than 0 and up to 10 edge lengths");
    Drape locked = drape(guide->surface(), guide->tree(), options);
    if (locked.locked == 0) return locked;
    DrapeOptions sharper = options;
    sharper.smallest_angle *= k_sharper;
    if (options.border == DrapeOptions::Border::cut) sharper.border = DrapeOptions::Border::beyond;
    const Drape laid = drape(guide->surface(), guide->tree(), sharper);
    const Positions positions = at_rest(laid.net, guide, options.smallest_angle);
    const std::vector<DrapedVertex> vertices = draped_vertices(*guide, positions);
    const std::vector<std::array<int, 4>> cells = good_cells(laid.net, positions, heights_over(*guide, positions),
                                                             most_height * options.length, options.smallest_angle);
    BorderCut left;
    if (options.border == DrapeOptions::Border::cut)
        left = cut_at_border(Compass(guide->surface(), guide->tree(), options.length), options.smallest_angle, vertices,
                             cells);
    else
        for (const auto& cell : cells) left.faces.emplace_back(cell.begin(), cell.end());
    if (left.faces.empty()) return locked;
    Drape bridged = draped_net(vertices, laid.places, left);
    bridged.locked = laid.locked;
    bridged.met = laid.met;
    const auto coverage = [&](const Net& net) { return measure_drape(guide->surface(), guide->tree(), net).coverage; };
    return coverage(bridged.net) > coverage(locked.net) ? bridged : locked;
}

}  // namespace chebnet
