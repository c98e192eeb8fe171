#include "shapes/smooth_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "shapes/block_lattice.h"
#include "shapes/block_net.h"
#include "shapes/family.h"
#include "shapes/relaxation.h"

namespace chebnet {

namespace {

constexpr int k_figure_iterations = 120;  // in the coarsest net
constexpr int k_next_iterations = 80;     // in those that begin where a coarser one has led
// Rounding asks for more of every cell, which takes longer to agree on.
constexpr int k_longer_when_rounded = 2;
// The coarsest net would be at least as many faces wide if it were a square.
constexpr double k_coarsest_width = 11;
// Loads, where edges are 1 long and the whole net were a square of side 1. Pressure makes bodies plump; the springs of
// the other keep them from bending over.
constexpr double k_hold = 10000, k_pressure = 8000;

/// Cut into faces that are at most `longest` cells long, and relaxed.
BlockNet refined(BlockNet net, int longest, double width, double rounding, int iterations) {
    if (rounding > 0) iterations *= k_longer_when_rounded;
    net = cut(net, longest);
    const double square = longest * longest, scale = width * width;
    relax(net.blocks, {k_hold * square / (scale * scale), k_pressure * square / (scale * width)}, rounding, iterations,
          net.positions);
    return net;
}

BlockNet relaxed(const BlockLattice& lattice, double rounding) {
    const double width = std::max(k_coarsest_width, std::sqrt(lattice.vertex_count()));
    int longest = 1;
    while (2 * longest * k_coarsest_width <= width) longest *= 2;

    BlockNet net{lattice.surface(), {}};
    net.positions = net.blocks.positions;
    for (int uncut = 128 * longest; uncut > longest; uncut /= 2) net = cut(net, uncut);
    net = refined(net, longest, width, rounding, k_figure_iterations);
    while (longest > 1) net = refined(net, longest /= 2, width, rounding, k_next_iterations);
    return net;
}

}  // namespace

Shape make_smooth_figure(std::span<const Box> boxes, double vertices, double rounding,
                         std::span<const Eigen::Vector3d> handles, std::span<const Box> openings) {
    const Placement placement = place_for(boxes, openings, vertices);
    BlockNet net = relaxed(BlockLattice(cells_of(boxes, placement), openings_of(openings, placement)), rounding);
    restore_lengths(net.blocks, net.positions);
    const std::vector<int> handle_vertices = nearest_vertices(net.blocks.positions, handles, placement);
    return {place_net({std::move(net.positions), std::move(net.blocks.faces)}), handle_vertices};
}

}  // namespace chebnet
