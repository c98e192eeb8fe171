#include "shapes/family.h"
#include "shapes/smooth_figure.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_shirt_parameters[] = {
    vertices_parameter(3000),
};

Shape make_shirt(const Values& values) {
    Boxes boxes, openings;
    boxes.add(-3, 3, -1.5, 1.5, 0, 7.5);
    openings.add(-3, 3, -1.5, 1.5, 0, 0);          // below
    openings.add(-1.25, 1.25, -1, 1, 7.5, 7.5);    // neck
    openings.add_pair(3, 3, -1.5, 1.5, 4.5, 7.5);  // arms

    const Eigen::Vector3d handles[] = {{3, 0, 0}, {-3, 0, 0}, {0, -1.5, 0}, {0, 1.5, 0}, {0, -1.5, 6}};
    return make_smooth_figure(boxes, values["vertices"], 0, handles, openings);
}

}  // namespace

constinit const Family k_shirt = {
    {"shirt", "Shirt", "A shirt without sleeves, open below, at the neck and at the arms.", k_shirt_parameters},
    make_shirt};

}  // namespace chebnet
