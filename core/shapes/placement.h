#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "shapes/block_lattice.h"

namespace chebnet {

/// A block with its sides along the axes; flat if it stands for an opening.
struct Box {
    Eigen::Vector3d low, high;
};

class Boxes : public std::vector<Box> {
public:
    void add(double x_low, double x_high, double y_low, double y_high, double z_low, double z_high) {
        push_back({{x_low, y_low, z_low}, {x_high, y_high, z_high}});
    }
    /// A box and its mirror image in the plane x = 0.
    void add_pair(double x_low, double x_high, double y_low, double y_high, double z_low, double z_high) {
        add(x_low, x_high, y_low, y_high, z_low, z_high);
        add(-x_high, -x_low, y_low, y_high, z_low, z_high);
    }
};

/// How a figure is laid into the lattice of cells: its origin at a lattice point (offset 0) or in the middle of a cell
/// (offset 1/2). What is symmetric about the origin is an even number of cells wide on the one and odd on the other.
struct Placement {
    double cells_per_unit, offset;
};

/// The placement in which the figure of these boxes has about `vertices` vertices.
Placement place_for(std::span<const Box> boxes, std::span<const Box> openings, double vertices);

/// The cells of blocks. One that rounding would make vanish is thickened away from the origin, so that symmetric
/// figures stay symmetric.
std::vector<CellBox> cells_of(std::span<const Box> boxes, const Placement& placement);
/// Openings, which stay flat.
std::vector<CellBox> openings_of(std::span<const Box> openings, const Placement& placement);

/// The vertex nearest to each of `points`, which are given in the units of the boxes.
std::vector<int> nearest_vertices(const Positions& lattice_points, std::span<const Eigen::Vector3d> points,
                                  const Placement& placement);

}  // namespace chebnet
