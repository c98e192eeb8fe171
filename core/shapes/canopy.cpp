#include <cmath>
#include <numbers>

#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_canopy_parameters[] = {
    vertices_parameter(2000),
    {"rise", 0.18, 0.02, 0.3, "Height of the arch divided by its width."},
    {"aspect", 1.2, 0.4, 4, "Length of the canopy divided by the length of its arch."},
    {"slope", 40, 5, 50, "How steep it rises from its foot, in degrees."},
};

// Where along the canopy its crest is, from foot to lip.
constexpr double k_crest = 0.45;

/// The slope at a part of the way from foot to lip, where it is 1 at the foot: falling to 0 at the crest, on down, and
/// back to 0 at the lip, with the curvature at the crest the same from either side.
double slope_at(double part) {
    constexpr double before = k_crest, after = 1 - k_crest;
    if (part < before) return std::cos(std::numbers::pi / 2 * part / before);
    return -after / (2 * before) * std::sin(std::numbers::pi * (part - before) / after);
}

Shape make_canopy(const Values& values) {
    const GridSize size = grid_size(values["vertices"], values["aspect"]);
    // A circular arch of this rise begins and ends at this slope.
    const double springing = 2 * std::atan(2 * values["rise"]);
    const double steepest = values["slope"] * std::numbers::pi / 180;

    const Positions arch = guide(
        size.columns, [=](double t) { return Eigen::Vector3d(std::cos(springing * t), 0, -std::sin(springing * t)); });
    const Positions spine = guide(size.rows, [=](double t) {
        const double slope = steepest * slope_at((t + 1) / 2);
        return Eigen::Vector3d(0, std::cos(slope), std::sin(slope));
    });

    const auto vertex = [size](int column, int row) { return row * size.columns + column; };
    const int right = size.columns - 1, lip = size.rows - 1, crest = static_cast<int>(k_crest * lip);
    return {place_net({sum_of_guides(arch, spine), grid_faces(size)}),
            {vertex(0, 0), vertex(right, 0), vertex(0, crest), vertex(right, crest), vertex(right / 2, lip)}};
}

}  // namespace

constinit const Family k_canopy = {
    {"canopy", "Canopy",
     "A free-form shell: an arch carried along a line that rises from a foot and runs out into a lip.",
     k_canopy_parameters},
    make_canopy};

}  // namespace chebnet
