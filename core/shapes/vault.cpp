#include <cmath>
#include <numbers>

#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_vault_parameters[] = {
    vertices_parameter(2000),
    {"rise", 0.3, 0.02, 0.6, "Height of the arch divided by its width."},
    {"aspect", 1.4, 0.4, 4, "Length of the vault divided by the length of its arch."},
    {"waves", 2, 0, 6, "How many times the vault swings up and down along its length."},
    {"slope", 30, 0, 45, "How steep the waves are, in degrees."},
};

Shape make_vault(const Values& values) {
    const GridSize size = grid_size(values["vertices"], values["aspect"]);
    // A circular arch of this rise begins and ends at this slope.
    const double springing = 2 * std::atan(2 * values["rise"]);
    const double steepest = values["slope"] * std::numbers::pi / 180;
    const double frequency = values["waves"] * std::numbers::pi;

    const Positions arch = guide(
        size.columns, [=](double t) { return Eigen::Vector3d(std::cos(springing * t), 0, -std::sin(springing * t)); });
    const Positions crest = guide(size.rows, [=](double t) {
        const double slope = -steepest * std::sin(frequency * t);
        return Eigen::Vector3d(0, std::cos(slope), std::sin(slope));
    });

    const auto vertex = [size](int column, int row) { return row * size.columns + column; };
    const int right = size.columns - 1, back = size.rows - 1;
    return {place_net({sum_of_guides(arch, crest), grid_faces(size)}),
            {vertex(0, 0), vertex(right, 0), vertex(0, back), vertex(right, back), vertex(right / 2, back / 2)}};
}

}  // namespace

constinit const Family k_vault = {
    {"vault", "Vault", "A vault over a rectangle: one arch carried along a waving line.", k_vault_parameters},
    make_vault};

}  // namespace chebnet
