#include <cmath>

#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_saddle_parameters[] = {
    vertices_parameter(2000),
    {"rise", 0.2, 0.02, 0.35, "Height of each arc divided by its width."},
    {"aspect", 1, 0.4, 2.5, "Length of the hanging arc divided by that of the standing one."},
};

Shape make_saddle(const Values& values) {
    const GridSize size = grid_size(values["vertices"], values["aspect"]);
    // A circular arc of this rise begins and ends at this slope.
    const double steepest = 2 * std::atan(2 * values["rise"]);
    const Positions standing = guide(
        size.columns, [=](double t) { return Eigen::Vector3d(std::cos(steepest * t), 0, -std::sin(steepest * t)); });
    const Positions hanging =
        guide(size.rows, [=](double t) { return Eigen::Vector3d(0, std::cos(steepest * t), std::sin(steepest * t)); });

    const auto vertex = [size](int column, int row) { return row * size.columns + column; };
    const int right = size.columns - 1, back = size.rows - 1;
    return {place_net({sum_of_guides(standing, hanging), grid_faces(size)}),
            {vertex(0, 0), vertex(right, 0), vertex(0, back), vertex(right, back), vertex(right / 2, back / 2)}};
}

}  // namespace

constinit const Family k_saddle = {
    {"saddle", "Saddle", "A saddle over a rectangle: a standing arc carried along a hanging one.", k_saddle_parameters},
    make_saddle};

}  // namespace chebnet
