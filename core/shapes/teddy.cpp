#include "shapes/family.h"
#include "shapes/smooth_figure.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_teddy_parameters[] = {
    vertices_parameter(4000),
    rounding_parameter(),
};

Shape make_teddy(const Values& values) {
    Boxes boxes;
    boxes.add(-2.5, 2.5, -2, 1.75, 0, 5);              // body
    boxes.add(-3, 3, -2.25, 2.25, 5, 9.5);             // head
    boxes.add(-1.25, 1.25, -3.5, -2.25, 5.5, 7.5);     // muzzle
    boxes.add_pair(1.25, 3, -0.75, 0.75, 9.5, 11.25);  // ears
    boxes.add_pair(2.5, 4.75, -0.75, 0.75, 3, 4.5);    // arms
    boxes.add_pair(0.5, 2.5, -4.75, -2, 0, 1.75);      // legs

    const Eigen::Vector3d handles[] = {{1.25, -4, 0}, {-1.25, -4, 0}, {1.5, 1, 0}, {-1.5, 1, 0}, {0, 0, 9.5}};
    return make_smooth_figure(boxes, values["vertices"], values["rounding"], handles);
}

}  // namespace

constinit const Family k_teddy = {
    {"teddy", "Teddy",
     "A sitting teddy bear, smooth but for cones where three, five or six edges meet instead of four.",
     k_teddy_parameters, "teddy:rounding=1"},
    make_teddy};

}  // namespace chebnet
