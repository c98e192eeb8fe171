#include <cmath>
#include <numbers>

#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_tube_parameters[] = {
    vertices_parameter(2000),
    {"aspect", 1.2, 0.3, 6, "Length of the tube divided by the length around it."},
    {"bend", 30, 0, 50, "How far the tube leans to either side, in degrees."},
};

Shape make_tube(const Values& values) {
    const GridSize size = grid_size(values["vertices"], values["aspect"]);
    const double bend = values["bend"] * std::numbers::pi / 180;
    const Positions axis = guide(size.rows, [=](double t) {
        const double lean = bend * std::sin(std::numbers::pi * t);
        return Eigen::Vector3d(std::sin(lean), 0, std::cos(lean));
    });

    const auto vertex = [size](int quarter, int row) { return row * size.columns + quarter * size.columns / 4; };
    // No anchor stands on the net line of the vertex to drag: along it the tube is stiff, and little would be in reach.
    return {place_net({sum_of_guides(regular_polygon(size.columns), axis), grid_faces(size, true)}),
            {vertex(1, 0), vertex(2, 0), vertex(3, 0), vertex(0, size.rows - 1)}};
}

}  // namespace

constinit const Family k_tube = {{"tube", "Tube", "A leaning tube, open at both ends.", k_tube_parameters}, make_tube};

}  // namespace chebnet
