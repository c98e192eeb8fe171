#include <cmath>
#include <numbers>

#include "base/in_this_build.h"
#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_wave_parameters[] = {
    vertices_parameter(2000),
    {"waves", 2, 1, 5, "How many times it rises."},
    {"slope", 35, 5, 45, "How steep the waves are, in degrees."},
    {"aspect", 1, 0.4, 2.5, "Length divided by width."},
};

Shape make_wave(const Values& values) {
    const GridSize size = grid_size(values["vertices"], values["aspect"]);
    const int waves = static_cast<int>(std::lround(values["waves"]));
    const double steepest = values["slope"] * std::numbers::pi / 180;
    // Level at both ends, where it is lowest.
    const auto slope = [=](double t) { return steepest * std::sin(std::numbers::pi * waves * (t + 1)); };
    const Positions across =
        guide(size.columns, [=](double t) { return Eigen::Vector3d(std::cos(slope(t)), 0, std::sin(slope(t))); });
    const Positions along =
        guide(size.rows, [=](double t) { return Eigen::Vector3d(0, std::cos(slope(t)), std::sin(slope(t))); });

    const auto vertex = [size](int column, int row) { return row * size.columns + column; };
    const int right = size.columns - 1, back = size.rows - 1;
    const double crest = (waves / 2 + 0.5) / waves;
    return {place_net({sum_of_guides(across, along), grid_faces(size)}),
            {vertex(0, 0), vertex(right, 0), vertex(0, back), vertex(right, back),
             vertex(static_cast<int>(crest * right), static_cast<int>(crest * back))}};
}

}  // namespace

constinit const Family k_wave = {{"wave", "Waves", "A roof of waves, one carried along the other.", k_wave_parameters},
                                 in_this_build(make_wave)};

}  // namespace chebnet
