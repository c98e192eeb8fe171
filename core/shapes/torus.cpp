#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_parameters[] = {
    vertices_parameter(2000),
    {"thickness", 0.35, 0.15, 1, "Size of the upright ring divided by that of the lying one."},
};

/// The upright section: a lens, two arcs that meet in a crest above and below. A round one would lie along the ring's
/// own edges in four places, and the net would fold flat there: an arc keeps this far from the horizontal.
Positions lens(int arc_vertices) {
    constexpr double steepest = 70 * std::numbers::pi / 180;
    const Positions arc = guide(
        arc_vertices, [](double t) { return Eigen::Vector3d(-std::sin(steepest * t), 0, std::cos(steepest * t)); });
    Positions section(3, 2 * (arc_vertices - 1));
    section << arc.leftCols(arc_vertices - 1), (-arc).rightCols(0),
        (-arc.leftCols(arc_vertices - 1)).colwise() + arc.col(arc_vertices - 1);
    return section;
}

Shape make(const Values& values) {
    GridSize size = grid_size(values["vertices"], values["thickness"]);
    size.rows = (size.rows + 1) / 2 * 2;
    const Positions lying = regular_polygon(size.columns);
    const Positions standing = lens(size.rows / 2 + 1);

    const auto vertex = [size](int quarter, int row) { return row * size.columns + quarter * size.columns / 4; };
    return {place_net({sum_of_guides(lying, standing), grid_faces(size, true, true)}),
            {vertex(0, 0), vertex(1, 0), vertex(2, 0), vertex(3, 0)}};
}

}  // namespace

constinit const Family k_torus = {{"torus", "Torus", "A ring: one circle carried around another.", k_parameters}, make};

}  // namespace chebnet
