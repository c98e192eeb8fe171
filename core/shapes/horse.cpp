#include "shapes/family.h"
#include "shapes/smooth_figure.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_horse_parameters[] = {
    vertices_parameter(4000),
    rounding_parameter(),
};

Shape make_horse(const Values& values) {
    Boxes boxes;
    boxes.add_pair(0.5, 1.75, -6, 6, 0, 1);       // rails
    boxes.add_pair(0.5, 1.75, 2.5, 4, 1, 4.5);    // hind legs
    boxes.add_pair(0.5, 1.75, -4, -2.5, 1, 4.5);  // fore legs
    boxes.add(-1.75, 1.75, -4, 4, 4.5, 8);        // body
    boxes.add(-0.5, 0.5, 4, 5.25, 3.5, 7.5);      // tail
    boxes.add(-1, 1, -4, -2, 8, 11);              // neck
    boxes.add(-1, 1, -6.25, -2, 11, 13);          // head
    boxes.add_pair(0.25, 1, -3, -2, 13, 14);      // ears

    const Eigen::Vector3d handles[] = {{1.75, -6, 0}, {-1.75, -6, 0}, {1.75, 6, 0}, {-1.75, 6, 0}, {0, -6.25, 12}};
    return make_smooth_figure(boxes, values["vertices"], values["rounding"], handles);
}

}  // namespace

constinit const Family k_horse = {
    {"horse", "Horse",
     "A rocking horse, smooth but for cones where three, five or six edges meet. Two holes go through it.",
     k_horse_parameters, "horse:rounding=1"},
    make_horse};

}  // namespace chebnet
