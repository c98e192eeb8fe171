#include "shapes/family.h"
#include "shapes/smooth_figure.h"

namespace chebnet {

namespace {

constexpr ShapeParameter k_jug_parameters[] = {
    vertices_parameter(2500),
    rounding_parameter(),
};

Shape make_jug(const Values& values) {
    Boxes boxes, openings;
    boxes.add(-2.5, 2.5, -2.5, 2.5, 0, 6);        // belly
    boxes.add(-1.25, 1.25, -1.25, 1.25, 6, 8.5);  // neck
    openings.add(-1.25, 1.25, -1.25, 1.25, 8.5, 8.5);
    boxes.add(2.5, 4.5, -0.5, 0.5, 4.5, 5.5);  // handle, from the top
    boxes.add(3.5, 4.5, -0.5, 0.5, 1.5, 5.5);
    boxes.add(2.5, 4.5, -0.5, 0.5, 1.5, 2.5);

    const Eigen::Vector3d handles[] = {{2, -2, 0}, {-2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, {-1.25, 0, 8.5}};
    return make_smooth_figure(boxes, values["vertices"], values["rounding"], handles, openings);
}

}  // namespace

constinit const Family k_jug = {
    {"jug", "Jug",
     "A jug with a handle, smooth but for cones where three or five edges meet instead of four. It is open at the top.",
     k_jug_parameters, "jug:rounding=1"},
    make_jug};

}  // namespace chebnet
