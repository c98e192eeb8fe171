#include "shapes/family.h"
#include "shapes/smooth_figure.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_rabbit_parameters[] = {
    vertices_parameter(4000),
    rounding_parameter(),
};

Shape make_rabbit(const Values& values) {
    Boxes boxes;
    boxes.add(-2, 2, -1.75, 2.75, 0, 4.75);             // body
    boxes.add(-1.75, 1.75, -3, 1, 4.75, 8.25);          // head
    boxes.add_pair(0.25, 1.75, -0.75, 0.25, 8.25, 13);  // ears
    boxes.add_pair(0.5, 1.5, -3, -1.75, 2.25, 3.5);     // fore paws
    boxes.add_pair(0.75, 2.75, -3.5, 0.5, 0, 1.5);      // hind legs
    boxes.add(-0.75, 0.75, 2.75, 4, 0.75, 2.25);        // tail

    const Eigen::Vector3d handles[] = {{1.75, -3, 0}, {-1.75, -3, 0}, {1.5, 2, 0}, {-1.5, 2, 0}, {0, -3, 6.5}};
    return make_smooth_figure(boxes, values["vertices"], values["rounding"], handles);
}

}  // namespace

constinit const Family k_rabbit = {
    {"rabbit", "Rabbit", "A sitting rabbit, smooth but for cones where three, five or six edges meet instead of four.",
     k_rabbit_parameters, "rabbit:rounding=1"},
    make_rabbit};

}  // namespace chebnet
