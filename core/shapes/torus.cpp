#include <cmath>

#include "base/angle.h"
#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_torus_parameters[] = {
    vertices_parameter(2000),
    {"thickness", 0.35, 0.15, 1, "Length around the upright ring divided by that around the lying one."},
};

/// The upright ring: two arcs of equal edges that meet in a crest above and below. A round one would, in four places,
/// run along the lying ring and fold the net flat there; the arcs stay clear of that direction.
Positions lens(int vertices) {
    constexpr double widest_lean = 70 * k_degree;
    const int half = vertices / 2;
    const Positions arc = guide(
        half + 1, [](double t) { return Eigen::Vector3d(-std::sin(widest_lean * t), 0, std::cos(widest_lean * t)); });
    Positions ring(3, 2 * half);
    ring << arc.leftCols(half), (-arc.leftCols(half)).colwise() + arc.col(half);
    return ring;
}

Shape make_torus(const Values& values) {
    const int rows = 2 * static_cast<int>(std::lround(std::sqrt(values["vertices"] * values["thickness"]) / 2));
    const int columns = static_cast<int>(std::lround(values["vertices"] / rows));

    const auto vertex = [columns](int quarter, int row) { return row * columns + quarter * columns / 4; };
    return {place_net({sum_of_guides(regular_polygon(columns), lens(rows)), grid_faces({columns, rows}, true, true)}),
            {vertex(0, 0), vertex(1, 0), vertex(3, 0), vertex(2, rows / 2)}};
}

}  // namespace

constinit const Family k_torus = {
    {"torus", "Torus", "A small upright ring carried along a large lying one.", k_torus_parameters}, make_torus};

}  // namespace chebnet
