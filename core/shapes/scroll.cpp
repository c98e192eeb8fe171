#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/in_this_build.h"
#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr double k_round = 2 * std::numbers::pi;

constexpr ShapeParameter k_scroll_parameters[] = {
    vertices_parameter(2000),
    {"turns", 1.75, 0.5, 2.5, "How often it is rolled around."},
    {"aspect", 0.6, 0.3, 3, "Width divided by length."},
};

// Radius at the innermost edge, in distances from turn to turn.
constexpr double k_core = 1.5;
// The part of its length that lies on the ground, unrolled already.
constexpr double k_unrolled = 0.25;

/// An involute, whose turns are one distance apart: the radius of curvature grows with the angle, by 1 in a turn.
double length_until(double angle) { return k_core * angle + angle * angle / (2 * k_round); }
/// The inverse of `length_until`.
double angle_after(double length) { return k_round * (std::sqrt(k_core * k_core + 2 * length / k_round) - k_core); }

Shape make_scroll(const Values& values) {
    const GridSize size = grid_size(values["vertices"], values["aspect"]);
    const double whole = k_round * values["turns"], rolled = length_until(whole), length = rolled / (1 - k_unrolled);
    const Positions spiral = guide(size.columns, [=](double t) {
        const double angle = angle_after(std::min(length * (t + 1) / 2, rolled)) - whole;
        return Eigen::Vector3d(std::cos(angle), 0, std::sin(angle));
    });
    const Positions straight = guide(size.rows, [](double) { return Eigen::Vector3d::UnitY(); });

    const auto vertex = [size](int column, int row) { return row * size.columns + column; };
    const int outer = size.columns - 1, back = size.rows - 1;
    const int lowest = static_cast<int>(std::lround(outer * rolled / length));
    return {place_net({sum_of_guides(spiral, straight), grid_faces(size)}),
            {vertex(0, 0), vertex(0, back), vertex(lowest, 0), vertex(lowest, back), vertex(outer, back / 2)}};
}

}  // namespace

constinit const Family k_scroll = {
    {"scroll", "Scroll", "A sheet rolled up, its loose end on the ground.", k_scroll_parameters},
    in_this_build(make_scroll)};

}  // namespace chebnet
