#include "shapes/family.h"
#include "shapes/grid.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_sheet_parameters[] = {
    vertices_parameter(1600),
    {"aspect", 1, 0.25, 4, "Length of the sheet divided by its width."},
};

Shape make_sheet(const Values& values) {
    const GridSize size = grid_size(values["vertices"], values["aspect"]);
    const Positions across = guide(size.columns, [](double) { return Eigen::Vector3d::UnitX(); }),
                    along = guide(size.rows, [](double) { return Eigen::Vector3d::UnitY(); });

    // Two opposite corners: all others would hold the sheet flat, since its net lines between them are already
    // straight.
    const auto vertex = [size](int column, int row) { return row * size.columns + column; };
    return {place_net({sum_of_guides(across, along), grid_faces(size)}),
            {vertex(0, 0), vertex(size.columns - 1, size.rows - 1), vertex(size.columns / 2, size.rows / 2)}};
}

}  // namespace

constinit const Family k_sheet = {
    {"sheet", "Sheet", "A flat sheet of squares, as wire mesh comes from the roll.", k_sheet_parameters}, make_sheet};

}  // namespace chebnet
